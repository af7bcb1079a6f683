// That orbits which are proved to exist obey what claims assume, so that these are of something.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/methods/paper.hpp"

namespace stickslip::proofs::pascal2012 {

// Claims and the orbit that obeys all that they assume.
struct Met {
  std::string example;                     // "S": the orbit of "S.motion"
  std::vector<std::string> ids;            // of the claims
  std::vector<std::string> premises = {};  // claims that say more of the orbit, each by those before
  symbols::Replacements values = {};       // of letters of which the orbit says nothing
  // When the first phase ends again, a period later, where claims look beyond it.
  std::optional<symbols::Term> goes_on_to = {};
  bool at_the_last_phase = false;  // the time t is when this begins, else 0
};

// The data of its orbit.
[[nodiscard]] const methods::Example& example_of(const Met& met);

// ⊢ there are frequencies that give the example's chi and eta, durations, the motion and values of all
// letters with which everything holds at once that the claims assume. Throws KernelError where one of these
// does not follow.
[[nodiscard]] kernel::Theorem met_theorem(methods::Prover& prover, const Met& met);

// "S.meets", "O.meets", "P.meets", and those with premises.
[[nodiscard]] std::vector<methods::Claim> met_by_orbits();

}  // namespace stickslip::proofs::pascal2012
