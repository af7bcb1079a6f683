#include "numeric/attractors/many_starts.hpp"

#include <cmath>

#include "core/error.hpp"

namespace stickslip::numeric::attractors {

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::periodic:
      return "periodic";
    case Kind::quasi_periodic:
      return "quasi-periodic";
    case Kind::irregular:
      return "irregular";
    case Kind::slides:
      return "slides";
    case Kind::stuck:
      return "stuck";
    case Kind::grows:
      return "grows without bound";
    case Kind::unsettled:
      return "unsettled";
  }
  throw InternalError("an attractor of no known kind");
}

Interval wilson(long count, long total) {
  constexpr double z = 1.959963984540054;  // the quantile of 97.5 % of the normal distribution
  const auto n = static_cast<double>(total);
  const double share = static_cast<double>(count) / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  // Nothing but rounding keeps the ends of the certain shares from being exact.
  return {count == 0 ? 0 : middle - half, count == total ? 1 : middle + half};
}

}  // namespace stickslip::numeric::attractors
