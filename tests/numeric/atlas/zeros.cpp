// How many zeros there are over a box of parameters, in one unknown and in two.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include "numeric/atlas/zeros_in_patches.hpp"
#include "numeric/atlas/zeros_over.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {
namespace {

using scalars::Form;
using scalars::HardwareBall;

// (u - 1/2)² - a, u in [0, 1]: a fold at a = 0, the zeros leave at a = 1/4.
struct Parabola {
  Form<HardwareBall, 3> a;
  template <class Q>
  Q operator()(const Q& u) const {
    const Q v = u - Q(Form<HardwareBall, 3>(HardwareBall(0.5)));
    return Q(v * v - Q(a));
  }
};

TEST_CASE("Zeros over a box are counted only where the number is the same for all members") {
  const auto count = [](double middle, double radius) {
    const Parabola f{Form<HardwareBall, 3>::variable(middle, radius, 1)};
    const auto cells = settled<HardwareBall, 3>(f, f, {{0, 1}}, 0x1p-12);
    const auto found =
        zeros_between(cells, [&](int u) { return detail::sign_of(f(Form<HardwareBall, 3>(u)).over); });
    return std::holds_alternative<Reason>(found)
               ? -static_cast<int>(std::get<Reason>(found))
               : static_cast<int>(std::get<std::vector<Bracket>>(found).size());
  };
  CHECK(count(0.1, 0.01) == 2);
  CHECK(count(-0.1, 0.01) == 0);
  CHECK(count(0.5, 0.1) == 0);                                     // outside of (0, 1)
  CHECK(count(0, 0.01) == -static_cast<int>(Reason::merging));     // two, one or none
  CHECK(count(0.25, 0.01) == -static_cast<int>(Reason::no_time));  // at the ends
  CHECK(count(0.0100001, 0.01) == 2);                              // 0 < a
  const Parabola f{Form<HardwareBall, 3>::variable(0.09, 0.01, 1)};
  const auto found = zeros_between(settled<HardwareBall, 3>(f, f, {{0, 1}}, 0x1p-12), [](int) { return 1; });
  Bracket second = std::get<std::vector<Bracket>>(found).at(1);
  const auto zero = zero_over<HardwareBall, 3>(f, f, second);
  CHECK(zero.at.ball().contains(Ball(Rational(4, 5))));
  for (const double a : {0.08, 0.085, 0.09, 0.1}) {
    CHECK(zero.over.ball().contains(Ball(0.5) + sqrt(Ball(a)).midpoint()));
  }
}

// Four zeros (s, w) = (0.5 ± √a, 0.5 ± √b), which meet in pairs at a = 0 and b = 0.
struct Crossing {
  Form<HardwareBall, 4> a, b;
  bool is_equivalent = true;
  Seen<Form<HardwareBall, 4>> operator()(const Form<HardwareBall, 4>& s,
                                         const Form<HardwareBall, 4>& w) const {
    using T = Form<HardwareBall, 4>;
    const T half(HardwareBall(0.5));
    const T f = (s - half) * (s - half) - a;
    const T g = (w - half) * (w - half) - b;
    return {false, std::array<T, 2>{T(f + T(2) * g), T(f - g)}, [this] { return is_equivalent; }};
  }
};

TEST_CASE(
    "Common zeros of two functions over a box are counted only where the number is the same for all "
    "members") {
  using T = Form<HardwareBall, 4>;
  const auto settle = [](double a, double b, double radius, bool is_equivalent = true) {
    Knowledge::Sheet sheet;
    settle_patches<HardwareBall, 4>(
        Crossing{T::variable(a, radius, 1), T::variable(b, radius, 2), is_equivalent}, sheet, 0x1p-10);
    return sheet;
  };
  const auto count = [&](double a, double b, double radius) {
    const Knowledge::Sheet sheet = settle(a, b, radius);
    return sheet.patches.empty() ? static_cast<int>(sheet.zeros.size()) : -1;
  };
  CHECK(count(0.09, 0.04, 0.001) == 4);
  CHECK(count(0.0625, 0.015625, 0.001) == 4);  // on the borders of patches
  CHECK(count(-0.09, 0.04, 0.001) == 0);
  CHECK(count(0.09, 0.004, 0.001) == 4);
  CHECK(count(0.09, 0.0009, 0.001) == -1);  // four or none
  CHECK(count(0.5, 0.5, 0.01) == 0);        // outside of the square
  CHECK_FALSE(settle(0.09, 0.04, 0.001, false).patches.empty());
  CHECK(settle(0.09, 0.04, 0.001, false).zeros.empty());

  // Where a zero is said to be there is one for every member.
  for (const double a : {0.001, 0.0015, 0.003, 0.01, 0.1}) {
    for (const double b : {0.012, 0.0166, 0.03, 0.24}) {
      for (const double radius : {0.0005, 0.0011, 0.0014, 0.01}) {
        for (const ZeroPatch& zero : settle(a, b, radius).zeros) {
          const auto holds = [&](std::size_t k, double square) {
            const double root = std::sqrt(square);
            const auto& [first, last] = zero.where[k];
            return (first <= 0.5 + root && 0.5 + root <= last) || (first <= 0.5 - root && 0.5 - root <= last);
          };
          REQUIRE(std::min(a, b) > radius);
          for (const double end : {-radius, radius}) {
            CHECK(holds(0, a + end));
            CHECK(holds(1, b + end));
          }
        }
      }
    }
  }

  // What is known of a box is right in its parts, and the zeros are functions of the parameters.
  Knowledge::Sheet sheet = settle(0.09, 0.04, 0.001);
  REQUIRE(sheet.zeros.size() == 4);
  for (ZeroPatch& zero : sheet.zeros) {
    const auto part = zero_in_patch<HardwareBall, 4>(
        Crossing{T::variable(0.0905, 0.0005, 1), T(HardwareBall(0.0395))}, zero);
    REQUIRE(part);
    for (const double a : {0.0901, 0.0905, 0.0909}) {
      const auto holds = [](const T& x, double square) {
        const Ball root = sqrt(Ball(square));
        return x.over.ball().overlaps(Ball(0.5) + root) || x.over.ball().overlaps(Ball(0.5) - root);
      };
      CHECK(holds((*part)[0], a));
      CHECK(holds((*part)[1], 0.0395));
    }
    CHECK((*part)[0].over.radius() < 0.001);
    // ds/da = ±1/(2 √a).
    CHECK(std::abs((*part)[0].slopes[1].approximate()) == doctest::Approx(0.0005 / (2 * std::sqrt(0.0905))));
  }
}

}  // namespace
}  // namespace stickslip::numeric::atlas
