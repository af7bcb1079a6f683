#include "numeric/attractors/starts.hpp"

#include <algorithm>
#include <cmath>

#include "model/load.hpp"

namespace stickslip::numeric::attractors {

StartBox start_box(const model::Parameters<double>& a) {
  const model::Modes<double> m = model::modes<double>(a.chi, a.eta);
  const model::Vector2<double> Q = model::Q<double>(a, m);
  const double d = a.us / (a.chi * (1 - a.chi));
  const auto is_resonant = [&](double omega_j) { return std::abs(omega_j - a.omega) < 1e-12 * omega_j; };
  const double forced =  // without a bound at resonance
      is_resonant(m.omega1) || is_resonant(m.omega2) ? 0 : std::abs(Q(1)) * a.omega;
  const double s = std::max({a.V, 1.2 * forced, 3 * a.us, 0.1});
  return {{a.chi * d, d, 0, a.V - s}, {2 * s, 3 * s, 1.5 * s, 1.5 * s}};
}

std::vector<model::Vector4<double>> random_starts(const model::Parameters<double>& a, std::size_t count,
                                                  std::uint64_t seed) {
  return random_starts_in(start_box(a), count, seed);
}

}  // namespace stickslip::numeric::attractors
