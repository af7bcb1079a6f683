#include "numeric/attractors/starts.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "model/load.hpp"

namespace stickslip::numeric::attractors {

std::vector<model::Vector4<double>> random_starts(const model::Parameters<double>& a, std::size_t count,
                                                  std::uint64_t seed) {
  const model::Vector2<double> Q = model::Q<double>(a, model::modes<double>(a.chi, a.eta));
  const double d = a.us / (a.chi * (1 - a.chi));
  const double s = std::max({a.V, 1.2 * std::abs(Q(1)) * a.omega, 3 * a.us, 0.1});
  // Distributions of the standard library differ from one to another; the engine does not.
  std::mt19937_64 engine(seed);
  const auto between = [&](double middle, double half) {
    const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
    return middle + half * (2 * share - 1);
  };
  std::vector<model::Vector4<double>> starts(count);
  for (model::Vector4<double>& X : starts) {
    X(0) = between(a.chi * d, 2 * s);
    X(1) = between(d, 3 * s);
    X(2) = between(0, 1.5 * s);
    X(3) = between(a.V - s, 1.5 * s);
  }
  return starts;
}

}  // namespace stickslip::numeric::attractors
