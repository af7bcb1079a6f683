#include "numeric/example_orbits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace stickslip {
namespace {

// The largest difference from a printed value, by size where the sign is lost.
double distance(const Example& example, const DecidedOrbit& orbit) {
  double largest = 0;
  for (const NamedBall& value : orbit.values) {
    for (const PrintedResult& printed : example.results) {
      if (printed.name == value.name) {
        const double x = value.value.approximate();
        const double difference = (printed.sign_lost ? std::abs(x) : x) - printed.value.value.get_d();
        largest = std::max(largest, std::abs(difference));
      }
    }
  }
  return largest;
}

}  // namespace

OrbitQuestion question_of(const Example& example, int digits) {
  const ExactParameters& a = example.data;
  OrbitQuestion q{example.family, {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}}, {}, {}, digits};
  if (example.phi) {
    q.phi = Range{*example.phi};
  }
  if (example.ur) {
    q.ur = Range{*example.ur};
  }
  return q;
}

DecidedOrbit printed_orbit(const Example& example, int digits) {
  const OrbitList list = list_orbits(question_of(example, digits));
  const DecidedOrbit* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const DecidedOrbit& orbit : list.orbits) {
    const double d = distance(example, orbit);
    if (orbit.admissible.truth == Truth::proved && d < least) {
      least = d;
      best = &orbit;
    }
  }
  if (best == nullptr) {
    throw InternalError("no admissible orbit for the data of example " + example.name);
  }
  return *best;
}

}  // namespace stickslip
