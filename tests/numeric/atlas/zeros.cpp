// How many zeros there are over a box of parameters, in one unknown and in two; and whether a function stays
// positive.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include "numeric/atlas/along.hpp"
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
        zeros_between(cells, [&](int u) { return scalars::sign_of(f(Form<HardwareBall, 3>(u)).over); });
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

TEST_CASE("Next to a fold the parameter is a function of the zero") {
  using T = Form<HardwareBall, 3>;
  // (u - 1/2)² = q - b/10, with q the variable 1 and b the variable 2.
  const T b = T::variable(0.01, 0.005, 2);
  const auto f = [&](const T& u, const T& q) {
    const T v = u - T(HardwareBall(0.5));
    return T(v * v - q + b / T(10));
  };
  const double radius = 0.001;
  const T q = T::variable(0.0028, radius, 1);
  const Bracket zero{0.515625, 0.5625, 0.03, 0.13, 1};
  const auto found = steep_zero<HardwareBall, 3>(f, zero, 1, q);
  REQUIRE(found);
  CHECK(found->u.over.ball().contains(Ball(0.515625)));
  CHECK(found->u.over.ball().contains(Ball(0.5625)));
  for (const double u : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
    for (const double e : {-1.0, 0.0, 0.6, 1.0}) {
      const Ball at_u = Ball(0.5390625) + Ball(0.0234375) * Ball(u);
      const Ball exact =
          (at_u - Ball(0.5)) * (at_u - Ball(0.5)) + (Ball(0.01) + Ball(0.005) * Ball(e)) / Ball(10);
      CHECK(found->q.over.ball().overlaps(exact));
      const T& form = found->q;
      const HardwareBall mean = form.at + form.slopes[1] * HardwareBall(u) + form.slopes[2] * HardwareBall(e);
      CHECK(mean.ball().overlaps(exact));
    }
  }
  CHECK(is_zero(found->q.slopes[0]));
  // Where f does not rise or fall with q there is no such function.
  const auto even = [&](const T& u, const T& x) {
    const T v = u - T(HardwareBall(0.5));
    return T(v * v - (x - q.at) * (x - q.at));
  };
  CHECK_FALSE(steep_zero<HardwareBall, 3>(even, zero, 1, q));
}

// scale (t - lowest)² + a, with a the parameter.
struct Bowl {
  double lowest, scale;
  Form<HardwareBall, 3> a;
  [[nodiscard]] std::array<Form<HardwareBall, 3>, 2> operator()(const Form<HardwareBall, 3>& t) const {
    using T = Form<HardwareBall, 3>;
    const T v = t - T(HardwareBall(lowest));
    return {T(T(HardwareBall(scale)) * v * v + a), T(T(HardwareBall(2 * scale)) * v)};
  }
};

TEST_CASE("The least value of what bends upwards is bounded from below, and tightly") {
  using T = Form<HardwareBall, 3>;
  const auto least = [](double lowest, double scale, double a, double radius) {
    const Bowl g{lowest, scale, T::variable(a, radius, 1)};
    const auto at = [&](double e) { return g(T(HardwareBall(0.5 + 0.25 * e))); };
    return convex<T>(g(T::variable(0.5, 0.25, 0)), T(HardwareBall(0.25)), false, false, at);
  };
  for (const double lowest : {-0.3, 0.2, 0.25, 0.4, 0.61, 0.75, 0.9, 2.0}) {
    const double nearest = std::clamp(lowest, 0.25, 0.75);
    for (const double scale : {0.1, 1.0, 30.0}) {
      const double distance = scale * (nearest - lowest) * (nearest - lowest);
      CAPTURE(lowest);
      CAPTURE(scale);
      CHECK(least(lowest, scale, 0.001 - distance, 0.0009)->is_proved);
      CHECK_FALSE(least(lowest, scale, 0.001 - distance, 0.0011)->is_proved);
      CHECK(least(lowest, scale, -0.001 - distance, 0.0009)->is_refuted);
      CHECK_FALSE(least(lowest, scale, -0.001 - distance, 0.0011)->is_refuted);
    }
  }
  // Lowest elsewhere for each member: v² - 2 a v + d, v = t - 1/2, is least at v = a, where it is d - a².
  const auto moving = [](double d) {
    const T a = T::variable(0, 0.1, 1);
    const auto g = [=](const T& t) {
      const T v = t - T(HardwareBall(0.5));
      return std::array<T, 2>{T(v * T(v - T(2) * a) + T(HardwareBall(d))), T(T(2) * T(v - a))};
    };
    const auto at = [&](double e) { return g(T(HardwareBall(0.5 + 0.25 * e))); };
    return convex<T>(g(T::variable(0.5, 0.25, 0)), T(HardwareBall(0.25)), false, false, at);
  };
  CHECK(moving(0.0105)->is_proved);
  CHECK_FALSE(moving(0.0095)->is_proved);
  CHECK_FALSE(least(0.5, -1, 0.001, 0.0001));
  CHECK_FALSE(least(0.5, 0, 0.001, 0.0001));
}

TEST_CASE("What has to be positive during a phase is judged for every time and every member") {
  using T = Form<HardwareBall, 3>;
  const auto judged = [](auto g, motion::Touches touches) {
    Times open{{0, 1}};
    return is_positive_along<T>(g, T(1), touches, 0x1p-12, open).truth;
  };
  const auto bowl = [](double a, double radius) { return Bowl{0.37, 1, T::variable(a, radius, 1)}; };
  CHECK(judged(bowl(0.001, 0.0009), {false, false}) == Truth::proved);
  CHECK(judged(bowl(0.001, 0.0011), {false, false}) == Truth::undecided);
  CHECK(judged(bowl(-0.001, 0.0009), {false, false}) == Truth::refuted);
  // t (t + a), and -t (t - a) which falls again: zero at the start.
  const auto from_zero = [](double sign, double a, double radius) {
    return [=, slope = T::variable(a, radius, 1)](const T& t) {
      const T s(HardwareBall{sign});
      return std::array<T, 2>{T(t * T(s * t + slope)), T(T(2) * s * t + slope)};
    };
  };
  CHECK(judged(from_zero(1, 0.01, 0.009), {true, false}) == Truth::proved);
  CHECK(judged(from_zero(1, 0.01, 0.011), {true, false}) == Truth::undecided);
  CHECK(judged(from_zero(1, -0.01, 0.009), {true, false}) == Truth::refuted);
  CHECK(judged(from_zero(-1, 1.01, 0.009), {true, false}) == Truth::proved);
  CHECK(judged(from_zero(-1, 0.9, 0.009), {true, false}) == Truth::refuted);
  CHECK(judged(from_zero(-1, 1.001, 0.009), {true, false}) == Truth::undecided);
  CHECK(judged(from_zero(1, 0.01, 0.009), {false, false}) != Truth::proved);
  // The same seen backwards: zero at the end.
  const auto to_zero = [](double sign, double a, double radius) {
    return [=, slope = T::variable(a, radius, 1)](const T& t) {
      const T s(HardwareBall{sign});
      const T rest = T(1) - t;
      return std::array<T, 2>{T(rest * T(s * rest + slope)), T(T(-2) * s * rest - slope)};
    };
  };
  CHECK(judged(to_zero(1, 0.01, 0.009), {false, true}) == Truth::proved);
  CHECK(judged(to_zero(1, 0.01, 0.011), {false, true}) == Truth::undecided);
  CHECK(judged(to_zero(1, -0.01, 0.009), {false, true}) == Truth::refuted);
  CHECK(judged(to_zero(-1, 0.9, 0.009), {false, true}) == Truth::refuted);
  CHECK(judged(to_zero(-1, 1.001, 0.009), {false, true}) == Truth::undecided);
}

// Four zeros (s, w) = (0.5 ± √a, 0.5 ± √b), which meet in pairs at a = 0 and b = 0.
struct Crossing {
  Form<HardwareBall, 4> a, b;
  std::optional<std::array<Form<HardwareBall, 4>, 2>> operator()(const Form<HardwareBall, 4>& s,
                                                                 const Form<HardwareBall, 4>& w) const {
    using T = Form<HardwareBall, 4>;
    const T half(HardwareBall(0.5));
    const T f = (s - half) * (s - half) - a;
    const T g = (w - half) * (w - half) - b;
    return std::array<T, 2>{T(f + T(2) * g), T(f - g)};
  }
};

TEST_CASE(
    "Common zeros of two functions over a box are counted only where the number is the same for all "
    "members") {
  using T = Form<HardwareBall, 4>;
  const auto settle = [](double a, double b, double radius) {
    Knowledge::Sheet sheet;
    settle_patches<HardwareBall, 4>(Crossing{T::variable(a, radius, 1), T::variable(b, radius, 2)}, sheet,
                                    0x1p-10);
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
