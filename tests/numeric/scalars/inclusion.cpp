// Every routine over balls contains the exact result for every member of its arguments: rational functions
// against exact rational numbers, the others against the same routine at a member, computed to 1000 bits.
// Arguments are drawn with a bias to corner cases: tiny, huge, next to zero, wide, exact.
#include <doctest/doctest.h>

#include <functional>

#include "model/waves.hpp"
#include "numeric/motion/eigenvalues.hpp"
#include "numeric/motion/infimum.hpp"
#include "numeric/scalars/exact.hpp"
#include "numeric/zeros/elimination.hpp"
#include "tests/numeric/families/nest.hpp"

// For jets over it.
namespace stickslip::numeric::scalars {
inline void add_product(Exact& sum, const Exact& a, const Exact& b) {
  sum += a * b;
}
}  // namespace stickslip::numeric::scalars

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::scalars;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

constexpr int rounds = 300;

}  // namespace

TEST_CASE("rational operations contain the exact rational result") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < rounds; ++i) {
    const Nest a = nest(random), b = nest(random);
    CAPTURE(a.member.get_str());
    CAPTURE(b.member.get_str());
    for (const long bits : {24L, 64L, 256L}) {
      const WorkingPrecision precision(bits);
      for (const auto& [x, y] : {std::pair(a.narrow, b.wide), std::pair(a.wide, b.narrow)}) {
        CHECK((x + y).contains(a.member + b.member));
        CHECK((x - y).contains(a.member - b.member));
        CHECK((x * y).contains(a.member * b.member));
        CHECK((-x).contains(-a.member));
        CHECK(abs(x).contains(abs(a.member)));
        CHECK((x * x).contains(a.member * a.member));
        CHECK(Ball::hull(x, y).contains(a.member));
        CHECK(Ball::hull(x, y).contains(b.member));
        if (b.member != 0) {
          CHECK((x / y).contains(a.member / b.member));
        }
        CHECK((a.member - b.member != 0 || !(x - y).is_nonzero()));
      }
      CHECK(Ball(a.member).contains(a.member));
      CHECK_FALSE((a.wide.lower() - Ball(a.member)).is_positive());
      CHECK_FALSE((Ball(a.member) - a.wide.upper()).is_positive());
    }
  }
}

TEST_CASE("transcendental functions contain their values at every member") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < rounds; ++i) {
    const Nest a = nest(random);
    CAPTURE(a.member.get_str());
    check_contains_member({a}, [](const std::vector<Ball>& v) {
      const Ball& x = v[0];
      return std::vector<Ball>{sin(x),  cos(x),        tan(x),           sqrt(x * x + Ball(1)),
                               sinc(x), sinc_slope(x), sin_cos(x).first, sin_cos(x).second};
    });
  }
}

TEST_CASE("jets over balls contain the exact value and slope of a rational function") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  const auto f = [](const auto& x, const auto& y) {
    using S = std::decay_t<decltype(x)>;
    return S(S(x * x * y - S(3) * y) / S(x * x + y * y + S(1)));
  };
  for (int i = 0; i < rounds; ++i) {
    const Nest a = nest(random), b = nest(random);
    using E = Jet<Exact, 2>;
    using B = Jet<Ball, 2>;
    const E exact = f(E::variable(Exact(a.member), 0), E::variable(Exact(b.member), 1));
    const B ball = f(B::variable(a.wide, 0), B::variable(b.wide, 1));
    CHECK(ball.value.contains(exact.value.value()));
    CHECK(ball.partials[0].contains(exact.partials[0].value()));
    CHECK(ball.partials[1].contains(exact.partials[1].value()));
  }
}

TEST_CASE("the flows over balls of states and times contain those of every member") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < 40; ++i) {
    const ExactParameters a = random.parameters();
    CAPTURE(to_string(a));
    check_contains_member({nest(random), nest(random)}, [&](const std::vector<Ball>& v) {
      const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
      const model::Vector4<Ball> Z0(v[1], Ball(1), Ball(0), o.data.V);
      const model::Vector4<Ball> moved =
          model::overshoot_flow<Ball>(o.modes, o.Q, o.d0, o.data.omega, Ball(1), Z0, v[0]);
      const model::Vector4<Ball> stuck = model::stick_flow<Ball>(o.data.chi, Z0, v[0]);
      std::vector<Ball> all(moved.data(), moved.data() + 4);
      all.insert(all.end(), stuck.data(), stuck.data() + 4);
      return all;
    });
  }
}

TEST_CASE("elimination over balls keeps the exact rational solution") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  int eliminated = 0;
  for (int i = 0; i < rounds; ++i) {
    // Five rows that all hold at u: row . (u, 1) = 0.
    std::array<Rational, 3> u;
    for (Rational& x : u) {
      x = corner(random);
    }
    Eigen::Matrix<Ball, 5, 4> rows;
    for (int row = 0; row < 5; ++row) {
      Rational last = 0;
      for (int k = 0; k < 3; ++k) {
        const Rational entry = random.between(-2, 2);
        rows(row, k) = Ball::from_interval(entry - Rational(1, 100000000), entry + Rational(1, 50000000));
        last -= entry * u.at(static_cast<std::size_t>(k));
      }
      rows(row, 3) = Ball(last);
    }
    const auto combinations = proposed_combinations<5, 4>(rows);
    if (!combinations) {
      continue;
    }
    Eigen::Matrix<Ball, 5, 4> reduced =
        combined_rows<Ball, 5, 4>(Eigen::Matrix<Ball, 5, 5>(combinations->cast<Ball>()), rows);
    if (!eliminate<Ball, 5, 4>(reduced, 0, 3)) {
      continue;
    }
    ++eliminated;
    CHECK(reduced(3, 3).contains_zero());
    CHECK(reduced(4, 3).contains_zero());
  }
  CHECK(eliminated > rounds / 2);
}

TEST_CASE("the eigenvalues of a ball matrix hold those of its members") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < 100; ++i) {
    // Lower triangular: the eigenvalues are on the diagonal.
    SquareMatrix m(3, 3);
    std::array<Rational, 3> diagonal{random.between(-2, -1), random.between(0, 1), random.between(2, 3)};
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 3; ++k) {
        const Rational entry = k == row  ? diagonal.at(static_cast<std::size_t>(row))
                               : k < row ? random.between(-1, 1)
                                         : Rational(0);
        const Rational w(1, 1000000);
        m(row, k) = k <= row ? Ball::from_interval(entry - w, entry + w) : Ball(0);
      }
    }
    const auto found = eigenvalues(m);
    REQUIRE(found.has_value());
    for (const Rational& exact : diagonal) {
      CHECK(std::any_of(found->begin(), found->end(), [&](const ComplexBall& value) {
        return value.re.contains(exact) && value.im.contains_zero();
      }));
    }
  }
}
