// What the paper's symbols look like and in which order they are written, from their plain names.
#pragma once

#include <compare>
#include <string>

namespace stickslip::symbolic::typeset {

// The LaTeX of a plain name: "omega1" \omega_1, "z10" z_{10}, "zdot10" \dot z_{10}, "us" u_s, "phi" \varphi,
// "phiB" or "phi_B" \varphi_B, "pi" \pi. A name is a letter or a Greek letter spelled out, then possibly dot,
// ddot, bar, tilde or hat, then a subscript of one letter, digits, or both, or anything after an underscore;
// any other name is set upright as it stands.
[[nodiscard]] std::string latex_name(const std::string& plain);

// The order of factors in a product: π, χ, η, λ_j, names unknown to the paper, u, p, V, d, q, x, z, ω, φ, and
// times last; equal letters by accent, then by subscript, none first and shorter ones before longer ones.
// Equal only for equal names.
[[nodiscard]] std::strong_ordering compare_names(const std::string& a, const std::string& b);

// Whether the name is that of a frequency: omega with any subscript.
[[nodiscard]] bool names_frequency(const std::string& plain);

// Whether the quantity of that name is greater than 1, by (39): omega2.
[[nodiscard]] bool exceeds_one(const std::string& plain);

}  // namespace stickslip::symbolic::typeset
