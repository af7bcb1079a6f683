// Terms and sequents for a reader. No rule looks at it, and nothing compares it: names stand for definitions,
// whose bodies are not shown.
#pragma once

#include <string>

#include "proofs/kernel/theorem.hpp"

namespace stickslip::proofs::kernel {

[[nodiscard]] std::string to_string(const Term& term);
// "hypothesis, hypothesis |- conclusion".
[[nodiscard]] std::string to_string(const Sequent& sequent);

}  // namespace stickslip::proofs::kernel
