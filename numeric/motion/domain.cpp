#include "numeric/motion/domain.hpp"

#include <cmath>

#include "core/domain.hpp"

namespace stickslip::numeric::motion {

ExactParameters parse_parameters(const char * chi, const char * eta, const char * us, const char * V,
                                 const char * omega, const char * p) {
  return {parse_rational(chi), parse_rational(eta),   parse_rational(us),
          parse_rational(V),   parse_rational(omega), parse_rational(p)};
}

bool is_resonant(const ExactParameters& a) {
  const Rational w = a.omega * a.omega;
  return w * w - (1 + a.chi * a.eta) * w + a.chi * a.eta * (1 - a.chi) == 0;
}

Resonances resonances(const ExactParameters& a) {
  const model::Modes<double> m = model::modes<double>(a.chi.get_d(), a.eta.get_d());
  // omega1 < 1 < omega2 tells whose multiple it is.
  const auto multiple = [&a](double omega_j) {
    const long k = std::lround(omega_j / a.omega.get_d());
    ExactParameters b = a;
    b.omega *= k;
    return k >= 1 && is_resonant(b) && (b.omega < 1) == (omega_j < 1) ? k : 0;
  };
  return {multiple(m.omega1), multiple(m.omega2)};
}

void require_model_domain(const ExactParameters& a) {
  require(a.chi > 0 && a.chi < 1, "chi", a.chi, "0 < chi < 1");
  require(a.eta > 0, "eta", a.eta, "eta > 0");
  require(a.us > 0, "us", a.us, "us > 0");
  require(a.omega > 0, "omega", a.omega, "omega > 0");
  require(a.p >= 0, "p", a.p, "p >= 0");
}

void require_response(const ExactParameters& a) {
  require_model_domain(a);
  require(!is_resonant(a), "omega", a.omega, "not a natural frequency: omega ≠ omega1, omega2");
}

void require_stick_slip_domain(const ExactParameters& a) {
  require_response(a);
  require(a.V > 0, "V", a.V, "V > 0 for orbits with a stick phase");
}

}  // namespace stickslip::numeric::motion
