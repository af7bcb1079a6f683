// Claims of the paper as they are decided.
#pragma once

#include <set>
#include <string>

#include "proofs/methods/prover.hpp"

namespace stickslip::proofs {

using namespace proofs::methods;

// Of the paper's claims, one for all tests of a process.
[[nodiscard]] Prover& the_prover();

// The record of that claim, proved when it is first asked for.
[[nodiscard]] const Record& record(const std::string& id);

// Its hypotheses, as text.
[[nodiscard]] std::set<std::string> hypotheses(const std::string& id);

}  // namespace stickslip::proofs
