// The paper, section by section: M. Pascal, New limit cycles of dry friction oscillators under harmonic load,
// Nonlinear Dynamics 70 (2012) 1435-1443.
#pragma once

#include <string>
#include <vector>

#include "proofs/methods/claim.hpp"

namespace stickslip::proofs::pascal2012 {

[[nodiscard]] std::vector<methods::Claim> section2();   // (1)-(4)
[[nodiscard]] std::vector<methods::Claim> section3();   // (5)-(11)
[[nodiscard]] std::vector<methods::Claim> section4();   // (12)-(16), example S
[[nodiscard]] std::vector<methods::Claim> section5();   // (18)-(24), example O
[[nodiscard]] std::vector<methods::Claim> section6();   // (25)-(37), example P
[[nodiscard]] std::vector<methods::Claim> section7();   // abstract and conclusion
[[nodiscard]] std::vector<methods::Claim> appendix1();  // (38)-(42)
[[nodiscard]] std::vector<methods::Claim> appendix2();  // (43)-(46), (17)
[[nodiscard]] std::vector<methods::Claim> appendix3();  // (47)-(51)
[[nodiscard]] std::vector<methods::Claim> appendix4();  // (52)-(54)
[[nodiscard]] std::vector<methods::Claim> appendix5();  // (55)-(70)

[[nodiscard]] std::vector<methods::Claim> reduced();  // what the proofs of orbits solve in place of (13)-(28)

struct Place {
  std::string id;      // "sec3", "A1"
  std::string title;   // "Section 3: closed-form phases"
  std::string source;  // the file in proofs/, also the name of its identity-check program
  std::vector<methods::Claim> (*claims)();
};

// In the paper's order.
[[nodiscard]] const std::vector<Place>& places();

// All claims in the paper's order.
[[nodiscard]] std::vector<methods::Claim> paper();

// The ids that a word names: a claim (47.c1), an equation with all its parts (47), a place (sec4, A3). Throws
// UsageError naming the word and what there is.
[[nodiscard]] std::set<std::string> ids_named(const std::vector<methods::Claim>& claims,
                                              const std::string& word);

}  // namespace stickslip::proofs::pascal2012
