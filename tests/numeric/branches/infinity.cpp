// Branches that leave for infinity, and those that do not.
#include <doctest/doctest.h>

#include "numeric/branches/curve.hpp"
#include "numeric/families/symmetric.hpp"
#include "tests/numeric/branches/questions.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::branches;
using namespace stickslip::numeric::branches::examples;

namespace {

// Closing conditions in one length x, and motions whose phases last. Homogeneous in x and V.
template <class F>
struct OneLength {
  static constexpr bool takes_phi = false, takes_ur = false;

  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return zeros::VectorOf<T>::Constant(1, F::template value<T>(x(0), p(3), T(p(4) - T(1))));
  }
  template <class T>
  [[nodiscard]] motion::MotionOf<T> motion(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    return families::SymmetricClosing{families::LoadPhase::first}.motion<T>(
        (zeros::VectorOf<T>(2) << T(1), x(0)).finished(), p);
  }
  [[nodiscard]] zeros::Vector unknowns(const motion::Motion& /*motion*/) const {
    return zeros::Vector::Constant(1, Ball(1));
  }
};
struct Hyperbola {
  template <class T>
  [[nodiscard]] static T value(const T& x, const T& V, const T& w) {
    return x * w - V;
  }
};
struct Ellipse {
  template <class T>
  [[nodiscard]] static T value(const T& x, const T& V, const T& w) {
    return x * x + T(1000000) * V * V * (w * w - T(1) / T(100));
  }
};

// omega = 1 + e - 40 e², e = V/x: 1 as x grows, and a fold at x = 80.
struct Parabola {
  template <class T>
  [[nodiscard]] static T value(const T& x, const T& V, const T& w) {
    return x * x * w - V * x + T(40) * V * V;
  }
};

template <class F>
Path followed(const char * from, const char * to, const char * value, double x, int direction,
              double far = 50) {
  const BranchQuestion question = along(S(), "omega", from, to);
  Curve curve = curve_of(question, OneLength<F>{});
  curve.growths = {{{0}, {}, {}}};
  curve.far = far;
  const ProvedPoint start = prove_at(curve, parse_rational(value), zeros::Vector::Constant(1, Ball(x)));
  REQUIRE(start.verdict.truth == Truth::proved);
  return follow(curve, parse_rational(value), start.point, direction);
}

// a = V/(omega - 1), and a number b = 1000 V (omega - 1) that grows where a becomes smaller.
struct Exchange : OneLength<Hyperbola> {
  template <class T>
  [[nodiscard]] zeros::VectorOf<T> closing(const zeros::VectorOf<T>& x, const zeros::VectorOf<T>& p) const {
    const T w = p(4) - T(1);
    return zeros::VectorOf<T>{{T(x(0) * w - p(3)), T(x(1) - T(1000) * p(3) * w)}};
  }
};

}  // namespace

TEST_CASE("x = V/(omega - 1) leaves for infinity at omega = 1, from both sides") {
  for (const int side : {-1, 1}) {
    const Path path = followed<Hyperbola>("0.5", "1.5", side > 0 ? "1.4" : "0.6", 2.5 * side, -side);
    REQUIRE(path.end == End::infinite);
    CHECK(path.limit->contains(Rational(1)));
    CHECK((path.limit->radius() - Ball(1e-15)).is_negative());
    CHECK(path.cells.back().last == 0);
    CHECK(path.cells.back().in_units->units->sign == side);
  }
}

TEST_CASE("a motion that is large and becomes smaller is not on its way to infinity") {
  for (const int side : {-1, 1}) {
    const Path path = followed<Hyperbola>("0.5", "1.5", side > 0 ? "1.4" : "0.6", 2.5 * side, side, 1);
    CHECK(path.end == End::interval);
    CHECK(!path.limit);
  }
}

TEST_CASE("what grows has to be the length that is infinite in the end") {
  const Rational value = parse_rational("1.01");
  Curve curve = curve_of(along(S(), "omega", "0.5", "1.5"), Exchange{});
  curve.growths = {{{0}, {1}, {1}}};
  curve.far = 50;
  const zeros::Vector guess{{Ball(100), Ball(10)}};
  const ProvedPoint start = prove_at(curve, value, guess);
  REQUIRE(start.verdict.truth == Truth::proved);
  const Path path = follow(curve, value, start.point, 1);
  CHECK(path.end == End::stopped);
  CHECK(!path.limit);
  CHECK(follow(curve, value, start.point, -1).end == End::infinite);
}

TEST_CASE("a fold on the way to infinity is in the cells") {
  const Path path = followed<Parabola>("0.5", "1.5", "0.95", 20, 1);
  REQUIRE(path.end == End::infinite);
  CHECK(path.limit->contains(Rational(1)));
  // At e = 1/80 the parameter is greatest, 1 + 1/160: one cell has it, and none that reaches beyond.
  Ball greatest(0);
  for (const Cell& cell : path.cells) {
    if (cell.in_units) {
      const Driven f{cell.in_units.get(), cell.driver};
      const Ball value = f.value<Ball>(cell.proof.box, zeros::Vector::Constant(1, cell.range));
      CHECK((value - Ball(1.1)).is_negative());
      greatest = cell.range.contains(Rational(1, 80)) ? value : greatest;
    }
  }
  CHECK(greatest.contains(Rational(161, 160)));
}

TEST_CASE("a limit beyond the interval is no end of the branch") {
  const Path path = followed<Parabola>("0.5", "0.99", "0.95", 20, 1, 15);
  CHECK(path.end == End::interval);
}

TEST_CASE("a branch that is only large does not leave for infinity") {
  // x² = 10⁶ (1/100 - (omega - 1)²): at most 100.
  const Path path = followed<Ellipse>("0.89", "1.5", "0.9001", 4.5, 1);
  CHECK(path.end == End::stopped);
  CHECK(!path.limit);
}

TEST_CASE(
    "the branch of O leaves for infinity, as does the one beyond, where the list of orbits is singular") {
  // There the even rows have a solution without the load, friction and belt.
  const BranchQuestion question = along(O(), "omega", "0.6182485", "0.6186");
  int infinite = 0;
  for (Start& start : starts(question, parse_rational("0.61825"))) {
    start.curve.far = 0;
    for (const Ball& x : start.point.x) {
      start.curve.far = std::max(start.curve.far, 2 * std::abs(x.approximate()));
    }
    for (const int direction : {-1, 1}) {
      const Path path = follow(start.curve, parse_rational("0.61825"), start.point, direction);
      if (path.end == End::infinite) {
        ++infinite;
        CHECK((abs(*path.limit - Ball(parse_rational("0.618249582007"))) - Ball(1e-11)).is_negative());
      }
    }
  }
  CHECK(infinite >= 1);
}
