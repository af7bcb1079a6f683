// The domain of the model and of the orbit families, decided exactly.
#pragma once

#include "core/rational.hpp"
#include "model/parameters.hpp"

namespace stickslip {

// The data of a problem, exactly as the user or the paper gave them.
using ExactParameters = model::Parameters<Rational>;

// Throws DomainError unless 0 < chi < 1, eta > 0, us > 0, omega > 0 and p >= 0: the domain of (2), (4).
void require_model_domain(const ExactParameters& a);

// The same, and V > 0 (an orbit that sticks travels with the belt), and omega not a natural frequency, where
// (7) has no Q.
void require_stick_slip_domain(const ExactParameters& a);

// omega² is a root of (39): decided in rationals.
[[nodiscard]] bool is_resonant(const ExactParameters& a);

}  // namespace stickslip
