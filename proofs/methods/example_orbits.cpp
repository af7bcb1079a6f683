#include "proofs/methods/example_orbits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <string>

#include "core/error.hpp"

namespace stickslip::proofs::methods {

using namespace numeric;
using namespace numeric::motion;

namespace {

// How far the orbit is from what is printed. In double: it picks an orbit and proves nothing.
double distance(const Orbit& orbit, const std::vector<PrintedResult>& printed) {
  double largest = 0;
  for (const PrintedResult& result : printed) {
    for (const NamedBall& value : orbit.values) {
      if (value.name == result.name) {
        const double proved = value.value.approximate();
        const double wanted = result.value.value.get_d();
        const double difference = result.sign_lost ? std::abs(proved) - std::abs(wanted) : proved - wanted;
        largest = std::max(largest, std::abs(difference) / std::max(std::abs(wanted), 1e-3));
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

const ExampleOrbits& orbits_of(const Example& example) {
  constexpr int digits = 30;
  static std::mutex one_at_a_time;
  static std::map<std::string, ExampleOrbits> known;
  const std::lock_guard lock(one_at_a_time);
  const auto found = known.find(example.name);
  return found != known.end()
             ? found->second
             : known.try_emplace(example.name, example, list_orbits(question_of(example, digits)))
                   .first->second;
}

std::optional<std::size_t> printed_orbit(const ExampleOrbits& orbits) {
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t i = 0; i < orbits.list.orbits.size(); ++i) {
    const double d = distance(orbits.list.orbits[i], orbits.example.results);
    if (!nearest || d < least) {
      nearest = i;
      least = d;
    }
  }
  return nearest;
}

const Orbit& printed_orbit(const Example& example) {
  const ExampleOrbits& orbits = orbits_of(example);
  const std::optional<std::size_t> nearest = printed_orbit(orbits);
  if (!nearest) {
    throw InternalError("there is no orbit at the data of " + example.figure);
  }
  return orbits.list.orbits[*nearest];
}

}  // namespace stickslip::proofs::methods
