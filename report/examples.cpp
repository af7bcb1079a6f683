#include "report/examples.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::report {
namespace {

// How far the orbit is from what is printed. In double: it picks an orbit and proves nothing.
double distance(const DecidedOrbit& orbit, const std::vector<PrintedResult>& printed) {
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

OrbitQuestion question_of(const Example& example) {
  const ExactParameters& a = example.data;
  OrbitQuestion question;
  question.family = example.family;
  question.parameters = {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}};
  if (example.phi) {
    question.phi = Range{*example.phi};
  }
  if (example.ur) {
    question.ur = Range{*example.ur};
  }
  return question;
}

std::optional<std::size_t> printed_orbit(const ExampleOrbits& example) {
  std::optional<std::size_t> nearest;
  double least = 0;
  for (std::size_t i = 0; i < example.list.orbits.size(); ++i) {
    const double d = distance(example.list.orbits[i], example.example.results);
    if (!nearest || d < least) {
      nearest = i;
      least = d;
    }
  }
  return nearest;
}

std::vector<ExampleOrbits> example_orbits() {
  std::vector<ExampleOrbits> all;
  for (const Example& example : printed_examples()) {
    all.push_back({example, list_orbits(question_of(example))});
  }
  return all;
}

}  // namespace stickslip::report
