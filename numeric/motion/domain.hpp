// The domain of the model and of the orbit families, decided exactly.
#pragma once

#include "core/rational.hpp"
#include "model/parameters.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::motion {

// The data of a problem, exactly as the user or the paper gave them.
using ExactParameters = model::Parameters<Rational>;

// Each read as parse_rational does, in the order of the fields. Throws UsageError likewise.
[[nodiscard]] ExactParameters parse_parameters(const char * chi, const char * eta, const char * us,
                                               const char * V, const char * omega, const char * p);

// The data at the working precision.
template <class S>
[[nodiscard]] model::Parameters<S> parameters_as(const ExactParameters& a) {
  return model::mapped<S>(a, [](const Rational& x) { return scalars::scalar<S>(x); });
}

// Throws DomainError unless 0 < chi < 1, eta > 0, us > 0, omega > 0 and p >= 0: the domain of (2), (4).
void require_model_domain(const ExactParameters& a);

// The same, and omega not a natural frequency, where (7) has no Q.
void require_response(const ExactParameters& a);

// The same, and V > 0: an orbit that sticks travels with the belt.
void require_stick_slip_domain(const ExactParameters& a);

// omega² is a root of (39): decided in rationals.
[[nodiscard]] bool is_resonant(const ExactParameters& a);

// The k >= 1 with k omega = omega1 and k omega = omega2, 0 where there is none: decided in rationals.
struct Resonances {
  long first = 0;
  long second = 0;
};
[[nodiscard]] Resonances resonances(const ExactParameters& a);

}  // namespace stickslip::numeric::motion
