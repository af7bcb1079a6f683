// The routines that proofs of orbits rest on, over balls: what they say holds for every member. As
// inclusion.cpp.
#include <doctest/doctest.h>

#include "core/sinc.hpp"
#include "model/parameters.hpp"
#include "model/saltation.hpp"
#include "numeric/motion/infimum.hpp"
#include "numeric/zeros/krawczyk.hpp"
#include "tests/numeric/families/nest.hpp"
#include "tests/numeric/simulation/response.hpp"

using namespace stickslip;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

Nest positive_nest(RandomData& random) {
  for (;;) {
    Nest n = nest(random);
    if (n.wide.is_positive()) {
      return n;
    }
  }
}

std::vector<Nest> nests(RandomData& random, int count) {
  std::vector<Nest> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(nest(random));
  }
  return result;
}

model::Wave<Ball> wave_of(const std::vector<Ball>& v) {
  model::Wave<Ball> w;
  w.constant = v[0];
  w.slope = v[1];
  w.add(v[2], v[3], v[4]);
  w.add(v[5], v[6], v[7]);
  return w;
}

// x -> A (x - zero) + (x1 - zero1)(x2 - zero2) (c1, c2), whose coefficients are balls.
struct Quadratic {
  Box<2> zero, c;
  BallMatrix<2> A;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& x) const {
    const T a = x(0) - T(zero(0)), b = x(1) - T(zero(1));
    return {T(T(A(0, 0)) * a + T(A(0, 1)) * b + T(c(0)) * a * b),
            T(T(A(1, 0)) * a + T(A(1, 1)) * b + T(c(1)) * a * b)};
  }
};

}  // namespace

TEST_CASE("a wave, its slope, its reverse and its multiples") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < 100; ++i) {
    check_contains_member(nests(random, 11), [](const std::vector<Ball>& v) {
      const model::Wave<Ball> w = wave_of(v);
      const Ball &t = v[8], &T = v[9], &factor = v[10];
      const std::array<Ball, 2> both = model::value_and_slope<Ball>(w, t);
      return std::vector<Ball>{model::value<Ball>(w, t),
                               both[0],
                               both[1],
                               model::value<Ball>(model::derivative<Ball>(w), t),
                               model::value<Ball>(model::reversed<Ball>(w, T), t),
                               model::value<Ball>(model::affine<Ball>(factor, w, T), t)};
    });
  }
}

TEST_CASE("a mode under load, at resonance too") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < 200; ++i) {
    std::vector<Nest> arguments{positive_nest(random), positive_nest(random), nest(random)};
    if (i % 3 == 0) {
      arguments[1] = arguments[0];
    }
    check_contains_member(arguments, [](const std::vector<Ball>& v) {
      const model::ModalResponse<Ball> r = model::modal_response<Ball>(v[0], v[1], v[2]);
      return std::vector<Ball>{r.c,        r.s,        r.e,        r.stiff,    r.from_cos,
                               r.from_sin, r.cos_rate, r.sin_rate, r.load_cos, r.load_sin};
    });
  }
}

TEST_CASE("events, friction and energy") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < 100; ++i) {
    check_contains_member(nests(random, 8), [](const std::vector<Ball>& v) {
      const model::Parameters<Ball> a{v[0], v[1], v[2], v[3], v[4], v[5]};
      const model::Vector4<Ball> Z(v[6], v[7], v[2], v[3]);
      const model::Matrix4<Ball> crossing = model::crossing<Ball>(v[6], v[7]);
      const model::Matrix4<Ball> away = model::break_away<Ball>(v[0], v[6], v[7]);
      return std::vector<Ball>{model::energy<Ball>(v[0], v[1], Z),
                               model::friction_at<Ball>(a, Z, v[5]),
                               model::friction_rate<Ball>(a, Z, v[5]),
                               crossing(3, 3),
                               away(3, 0),
                               away(3, 1)};
    });
  }
}

TEST_CASE("Krawczyk's image holds the zero of every member, and what is proved has one") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  int proved = 0, inflated = 0;
  for (int i = 0; i < 300; ++i) {
    std::array<Nest, 8> n;
    for (Nest& one : n) {
      one = nest(random);
    }
    const Quadratic f{{n[0].narrow, n[1].narrow},
                      {n[2].wide, n[3].wide},
                      (BallMatrix<2>() << n[4].narrow, n[5].narrow, n[6].narrow, n[7].narrow).finished()};
    // Off centre, and wide enough or not.
    const Rational r = random.between(0.001, 0.2), s = random.between(0.001, 0.2);
    const Box<2> X(Ball::from_interval(n[0].member - r, n[0].member + s),
                   Ball::from_interval(n[1].member - s, n[1].member + r));
    if (const auto K = krawczyk_operator<2>(f, X)) {
      CHECK((*K)(0).contains(n[0].member));
      CHECK((*K)(1).contains(n[1].member));
    }
    const ZeroProof<2> test = krawczyk_test<2>(f, X);
    CHECK(test.verdict.truth != Truth::refuted);
    if (test.verdict.truth == Truth::proved) {
      ++proved;
      CHECK(test.box(0).contains(n[0].member));
      // The zero of every member is simple.
      CHECK(n[4].member * n[7].member != n[5].member * n[6].member);
    }
    const ZeroProof<2> grown = prove_zero_by_inflation<2>(f, {Ball(n[0].member), Ball(n[1].member)});
    if (grown.verdict.truth == Truth::proved) {
      ++inflated;
      CHECK(grown.box(0).contains(n[0].member));
      CHECK(grown.box(1).contains(n[1].member));
    }
  }
  CHECK(proved > 10);
  CHECK(inflated > 10);
}

TEST_CASE("what is proved invertible has no vanishing member") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  int invertible = 0;
  for (int i = 0; i < 300; ++i) {
    BallMatrix<3> regular, singular;
    const Rational factor = corner(random);
    for (int column = 0; column < 3; ++column) {
      const Nest a = nest(random), b = nest(random), c = nest(random);
      regular.col(column) << a.narrow, b.narrow, c.narrow;
      const Rational last = a.member + factor * b.member;  // a combination of the rows above
      singular.col(column) << a.narrow, b.narrow, Ball::from_interval(last, last + Rational(1, 1000000));
    }
    CHECK_FALSE(is_invertible(singular));
    invertible += is_invertible(regular) ? 1 : 0;
  }
  CHECK(invertible > 50);
  // More rows than columns, which combine to the unit matrix above zeros.
  CHECK_FALSE(is_invertible(Eigen::Matrix<Ball, 3, 2>::Identity()));
}

TEST_CASE("the infimum over a phase is that of every member, and none of its values is below") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int i = 0; i < 60; ++i) {
    std::vector<Nest> arguments = nests(random, 8);
    for (const std::size_t amplitude : {3U, 4U, 6U, 7U, 0U, 1U}) {
      arguments[amplitude].member /= 1000;  // corner() goes up to 3000
      for (Ball * ball : {&arguments[amplitude].narrow, &arguments[amplitude].wide}) {
        *ball = *ball / Ball(1000);
      }
    }
    for (const std::size_t frequency : {2U, 5U}) {
      const Rational x = random.between(0.1, 3);
      arguments[frequency] = {x, Ball::from_interval(x, x + Rational(1, 1000000)),
                              Ball::from_interval(x - Rational(1, 10000), x + Rational(1, 1000))};
    }
    const Rational length = random.between(0.2, 6);
    const Nest T{length, Ball(length), Ball::from_interval(length - Rational(1, 1000), length)};
    const auto infimum = [&](const auto& ball) {
      std::vector<Ball> balls;
      for (const Nest& nest : arguments) {
        balls.push_back(ball(nest));
      }
      return weighted_infimum(wave_of(balls), ball(T), {});
    };
    const Infimum member = infimum([](const Nest& nest) { return Ball(nest.member); });
    for (const Infimum& around : {infimum([](const Nest& nest) { return nest.narrow; }),
                                  infimum([](const Nest& nest) { return nest.wide; })}) {
      check_holds(around.value, member.value);
      std::vector<Ball> balls;
      for (const Nest& nest : arguments) {
        balls.emplace_back(nest.member);
      }
      for (int k = 0; k <= 50; ++k) {
        const Ball t(Rational(length * random.between(0, 1)));
        CHECK_FALSE((around.value.lower() - model::value<Ball>(wave_of(balls), t)).is_positive());
      }
    }
  }
}
