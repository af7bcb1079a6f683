// What a question about branches comes to: the orbits at one value, the friction law, the curves to follow.
#pragma once

#include "numeric/branches/branches.hpp"
#include "numeric/branches/curve.hpp"
#include "numeric/branches/law.hpp"
#include "numeric/families/strip.hpp"

namespace stickslip::numeric::branches {

// Throws as list_branches does.
void require_question(const BranchQuestion& question);

// The data with the free parameter at that value.
[[nodiscard]] motion::Given<Rational> data_at(const BranchQuestion& question, const Rational& value);

[[nodiscard]] families::StripQuestion strip_question(const BranchQuestion& question);

[[nodiscard]] Law law_of(const BranchQuestion& question);

[[nodiscard]] Curve curve_of(const BranchQuestion& question, const motion::Closing& equations);

// The integer multiple of the load's frequency that is nearest to a natural frequency, 1 (that of a stick)
// among them, in words, where it is next to it: why nothing more is known there. Else empty.
[[nodiscard]] std::string resonance_near(const Ball& value, const BranchQuestion& question);

}  // namespace stickslip::numeric::branches
