// Hardware balls contain what Arb's contain of the same members, and lose little.
#include "numeric/scalars/hardware_ball.hpp"

#include "numeric/scalars/hardware_balls.hpp"

#include <doctest/doctest.h>

#include "core/sinc.hpp"
#include "numeric/zeros/elimination.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric::scalars;
using namespace stickslip::examples;
namespace zeros = stickslip::numeric::zeros;

namespace {

struct Drawn {
  HardwareBall ball;
  Ball member;
};

// A ball with a member in it or at its end: narrow, wide, tiny, huge, next to zero, exact.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}

  double share() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Drawn operator()(int most_exponent) {
    const double mid = pick(6) == 0 ? 0 : std::ldexp(share(), pick(2 * most_exponent) - most_exponent);
    const double rad =
        pick(4) == 0 ? 0 : std::ldexp(std::abs(share()), pick(80) - 78 + (pick(3) == 0 ? 0 : -20));
    const double t = pick(3) == 0 ? (pick(2) == 0 ? 1.0 : -1.0) : share();
    const WorkingPrecision scope(1200);
    return {{mid, rad}, Ball(mid) + Ball(rad) * Ball(t)};
  }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  std::mt19937_64 engine_;
};

bool holds(const HardwareBall& ball, const Ball& member) {
  return !ball.is_finite() || ball.ball().contains(member);
}

}  // namespace

TEST_CASE("every operation contains the exact result for every member") {
  const RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  Draw draw(random.seed());
  for (int i = 0; i < 3000; ++i) {
    const Drawn a = draw(i % 3 == 0 ? 300 : 12), b = draw(i % 5 == 0 ? 300 : 12), c = draw(18);
    const WorkingPrecision scope(1200);
    CAPTURE(to_string(a.member, 30));
    CAPTURE(to_string(b.member, 30));
    CAPTURE(to_string(c.member, 30));
    CHECK(holds(a.ball + b.ball, a.member + b.member));
    CHECK(holds(a.ball - b.ball, a.member - b.member));
    CHECK(holds(a.ball * b.ball, a.member * b.member));
    CHECK(holds(-a.ball, -a.member));
    HardwareBall sum = c.ball;
    add_product(sum, a.ball, b.ball);
    CHECK(holds(sum, c.member + a.member * b.member));
    add_products(sum, b.ball, c.ball, c.ball, a.ball);
    CHECK(holds(sum, c.member + a.member * b.member + b.member * c.member + c.member * a.member));
    if (!b.member.contains_zero()) {
      CHECK(holds(a.ball / b.ball, a.member / b.member));
    }
    const auto [s, c1] = sin_cos(c.ball);
    CHECK(holds(s, sin(c.member)));
    CHECK(holds(c1, cos(c.member)));
    CHECK(holds(sinc(c.ball), sinc(c.member)));
    CHECK(holds(sinc_slope(c.ball), sinc_slope(c.member)));
    CHECK(holds(HardwareBall(a.ball.ball()), a.member));
    CHECK(holds(HardwareBall(c.member), c.member));
    if (const auto common =
            intersection(a.ball, HardwareBall(a.ball.approximate() + a.ball.radius() / 2, a.ball.radius()));
        common && !(a.member - Ball(a.ball.approximate())).is_negative()) {
      CHECK(holds(*common, a.member));
    }
    CHECK((a.member.is_nonzero() || !a.ball.is_nonzero()));
  }
}

TEST_CASE("combined rows contain the exact ones of every member, and what is zero stays so") {
  constexpr int R = 5, C = 3;
  using Jets = Jet<HardwareBall, 2>;
  const RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  Draw draw(random.seed());
  for (int round = 0; round < 300; ++round) {
    const int most_exponent = round % 4 == 0 ? 300 : round % 4 == 1 ? 1000 : 12;
    Eigen::Matrix<double, R, R> combinations;
    Eigen::Matrix<Jets, R, C> rows;
    Eigen::Matrix<HardwareBall, R, C> values;
    std::array<Eigen::Matrix<Ball, R, C>, 3> members;  // values and partials
    for (double& factor : combinations.reshaped()) {
      factor = draw(most_exponent).ball.approximate();
    }
    for (int i = 0; i < R; ++i) {
      for (int j = 0; j < C; ++j) {
        for (int part = 0; part < 3; ++part) {
          const Drawn drawn = part == j ? Drawn{0, Ball(0)} : draw(most_exponent);
          zeros::detail::BallsOf<Jets>::at(rows(i, j), part) = drawn.ball;
          members.at(static_cast<std::size_t>(part))(i, j) = drawn.member;
        }
        values(i, j) = rows(i, j).value;
      }
    }
    Eigen::Matrix<Jets, R, C> combined = zeros::combined_rows<Jets, R, C>(combinations, rows);
    const auto combined_values = zeros::combined_rows<HardwareBall, R, C>(combinations, values);
    const WorkingPrecision scope(6000);
    for (int i = 0; i < R; ++i) {
      for (int j = 0; j < C; ++j) {
        for (int part = 0; part < 3; ++part) {
          Ball exact(0);
          for (int k = 0; k < R; ++k) {
            exact += Ball(combinations(i, k)) * members.at(static_cast<std::size_t>(part))(k, j);
          }
          const HardwareBall& ball = zeros::detail::BallsOf<Jets>::at(combined(i, j), part);
          CHECK(holds(ball, exact));
          CHECK((part != j || is_zero(ball)));
          CHECK((part != 0 || holds(combined_values(i, j), exact)));
        }
      }
    }
  }
}

TEST_CASE("several at once contain what each of them has to, and what is zero stays zero") {
  const RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  Draw draw(random.seed() + 1);
  for (int i = 0; i < 3000; ++i) {
    const int size = i % 3 == 0 ? 300 : 12;
    const Drawn a = draw(size), b = draw(12);
    std::array<Drawn, 5> x, y;
    HardwareBalls<5> X, Y;
    for (std::size_t k = 0; k < 5; ++k) {
      x[k] = draw(size);
      y[k] = draw(i % 5 == 0 ? 300 : 12);
      if (k == 3) {
        x[k] = y[k] = {{0, 0}, Ball(0)};
      }
      X[k] = x[k].ball;
      Y[k] = y[k].ball;
    }
    const WorkingPrecision scope(1200);
    const HardwareBalls<5> sum = X + Y, difference = X - Y, product = a.ball * X,
                           products = sum_of_products(a.ball, X, b.ball, Y);
    Ball magnitude(0);
    for (std::size_t k = 0; k < 5; ++k) {
      CAPTURE(k);
      CHECK(holds(sum[k], x[k].member + y[k].member));
      CHECK(holds(difference[k], x[k].member - y[k].member));
      CHECK(holds(product[k], a.member * x[k].member));
      CHECK(holds(products[k], a.member * x[k].member + b.member * y[k].member));
      magnitude += abs(x[k].member);
    }
    CHECK_FALSE((Ball(X.magnitude() * (1 + 0x1p-48)) - magnitude).is_negative());
    for (const HardwareBalls<5>& zero : {sum, difference, product, products}) {
      CHECK(is_zero(zero[3]));
    }
    const HardwareBalls<5> unknown = HardwareBall::everything() * X;
    for (std::size_t k = 0; k < 5; ++k) {
      CHECK_FALSE(unknown[k].is_nonzero());
    }
  }
  CHECK(is_zero(HardwareBalls<3>()));
}

TEST_CASE("two places at once, exact numbers and inverses") {
  const RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  Draw draw(random.seed() + 2);
  for (int i = 0; i < 3000; ++i) {
    const Drawn a = draw(18);
    Drawn b = draw(18);
    if (i % 2 == 0) {
      b = {{a.ball.approximate(), a.ball.radius() / 2},
           Ball(a.ball.approximate()) - Ball(a.ball.radius() / 2)};
    }
    const WorkingPrecision scope(1200);
    const auto sines = sin_cos(std::array{a.ball, b.ball});
    const auto sincs = sinc_and_slope(std::array{a.ball, b.ball});
    for (std::size_t k = 0; k < 2; ++k) {
      const Ball& x = (k == 0 ? a : b).member;
      CHECK(holds(sines[k].first, sin(x)));
      CHECK(holds(sines[k].second, cos(x)));
      CHECK(holds(sincs[k].first, sinc(x)));
      CHECK(holds(sincs[k].second, sinc_slope(x)));
    }
    if (!a.member.contains_zero()) {
      CHECK(holds(inverse(a.ball), Ball(1) / a.member));
    }
    const Rational exact = Rational(static_cast<long>(draw.share() * 1e6), 1 + i);
    CHECK(holds(scalar<HardwareBall>(exact), Ball(exact)));
    CHECK(holds(scalar<HardwareBall>(Rational(i, 1 << 20)), Ball(Rational(i, 1 << 20))));
  }
  const WorkingPrecision scope(200);
  CHECK(holds(pi<HardwareBall>(), Ball::pi()));
  CHECK(inverse(HardwareBall(-8)).radius() == 0);
  CHECK(inverse(HardwareBall(3)).radius() > 0);
  CHECK(scalar<HardwareBall>(Rational(-7)).radius() == 0);
}

TEST_CASE("far from 0 sinc turns little, and what is enclosed of it is all of it") {
  const WorkingPrecision scope(200);
  for (int i = 1; i < 400; ++i) {  // both where it is curved most, at odd multiples of pi/2, and elsewhere
    const double m = i * 0.78539816339744831;
    for (const double r : {1e-6, 1e-3, 0.1, 1.0, 3.0}) {
      const HardwareBall x(m, r);
      for (const double share : {-1.0, -0.9, 0.5, 1.0}) {
        const Ball member = Ball(m) + Ball(share) * Ball(r);
        CHECK(holds(sinc(x), sinc(member)));
        CHECK(holds(sinc_slope(x), sinc_slope(member)));
      }
      if (m > r) {
        CHECK(sinc_slope(x).radius() < 1.04 * r / (m - r) + 1e-12);
      }
    }
  }
}

TEST_CASE("what is not a number decides nothing") {
  const HardwareBall nowhere = HardwareBall(1) / HardwareBall(0, 1);
  const HardwareBall none(NAN, 0);
  const HardwareBall huge(1e300);
  for (const HardwareBall& x : {nowhere, none, nowhere * HardwareBall(0), none + HardwareBall(1), huge * huge,
                                huge * huge * huge, sin(none) / none}) {
    CHECK_FALSE(x.is_nonzero());
    CHECK_FALSE(x.is_positive());
    CHECK_FALSE(x.is_negative());
    CHECK_FALSE(x.is_finite());
    CHECK(x.ball().contains(Ball(17)));
  }
  CHECK(intersection(none, HardwareBall(3)).has_value());
  CHECK_FALSE(intersection(HardwareBall(1, 0.5), HardwareBall(3, 0.5)).has_value());
  CHECK(intersection(HardwareBall(1, 1), HardwareBall(3, 1)).has_value());
}

TEST_CASE("at points they are nearly exact") {
  for (const double x : {0.0, 0.3, 0.5, 1.0, 100.0, 400000.0}) {
    CHECK(sin(HardwareBall(x)).radius() < 1e-14);
    CHECK(sinc(HardwareBall(x)).radius() < 1e-13);
    CHECK(sinc_slope(HardwareBall(x)).radius() < 1e-13);
  }
  CHECK(sin(HardwareBall(1e9)).radius() == 1);
}
