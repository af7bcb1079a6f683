// The paper, section by section: M. Pascal, New limit cycles of dry friction oscillators under harmonic load,
// Nonlinear Dynamics 70 (2012) 1435-1443.
#pragma once

#include <vector>

#include "proofs/methods/paper.hpp"

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

// The paper, made once.
[[nodiscard]] const methods::Paper& paper();

}  // namespace stickslip::proofs::pascal2012
