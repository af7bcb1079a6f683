// Data drawn at random. The seed is printed with every failure; STICKSLIP_SEED in the environment sets it.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "core/decimal.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::examples {

using namespace numeric::motion;

class RandomData {
 public:
  RandomData() : seed_(chosen_seed()), engine_(seed_) {}

  [[nodiscard]] unsigned seed() const { return seed_; }

  // A multiple of 1/1000 in the closed interval.
  [[nodiscard]] Rational between(double low, double high) {
    const auto last = static_cast<int>(high * 1000);
    Rational value(std::uniform_int_distribution<int>(static_cast<int>(low * 1000), last)(engine_), 1000);
    value.canonicalize();
    return value;
  }
  // Data off resonance.
  [[nodiscard]] ExactParameters parameters() {
    for (;;) {
      const ExactParameters a{between(0.05, 0.95), between(0.3, 6),   between(0.001, 0.5),
                              between(0.1, 3),     between(0.2, 2.5), between(0.01, 2)};
      if (!is_resonant(a)) {
        return a;
      }
    }
  }

 private:
  static unsigned chosen_seed() {
    const char * given = std::getenv("STICKSLIP_SEED");
    return given != nullptr ? static_cast<unsigned>(std::stoul(given)) : std::random_device{}();
  }

  unsigned seed_;
  std::mt19937 engine_;
};

// How many times as much is drawn or looked at where a part tells most of the whole: 1, or the number in
// STICKSLIP_MORE, as script/nightly has it.
[[nodiscard]] inline int more() {
  const char * const given = std::getenv("STICKSLIP_MORE");
  return given != nullptr ? std::max(1, std::atoi(given)) : 1;
}

// For a failure's report.
[[nodiscard]] inline std::string to_string(const ExactParameters& a) {
  using stickslip::to_string;
  return "chi = " + to_string(a.chi) + ", eta = " + to_string(a.eta) + ", us = " + to_string(a.us) +
         ", V = " + to_string(a.V) + ", omega = " + to_string(a.omega) + ", p = " + to_string(a.p);
}

}  // namespace stickslip::examples
