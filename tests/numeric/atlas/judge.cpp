// What a leaf says, held against the lists of orbits at exact points in it: another search, other equations
// of closing, other proofs of the conditions, other multipliers.
#include <random>

#include <doctest/doctest.h>
#include "core/decimal.hpp"
#include "numeric/atlas/cover.hpp"
#include "numeric/atlas/judge.hpp"
#include "numeric/atlas/multipliers.hpp"
#include "numeric/atlas/work.hpp"
#include "numeric/atlas/zeros_over.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/orbits.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {
namespace {

using scalars::Form;
using scalars::HardwareBall;

Interval interval(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    return {parse_rational(text), parse_rational(text)};
  }
  return {parse_rational(text.substr(0, dots)), parse_rational(text.substr(dots + 2))};
}

Question question(const families::Family& family, const std::vector<std::string>& data, int resolution) {
  Question q{&family, {}, {}, resolution};
  for (const std::string& text : data) {
    q.region.push_back(interval(text));
    if (!q.region.back().is_point()) {
      q.axes.push_back(q.region.size() - 1);
    }
  }
  return q;
}

// The list at the corner of a box, or at a point within it.
OrbitList list_at(const Question& q, const Box& box, std::mt19937_64& random) {
  std::vector<Rational> at;
  for (const Interval& side : box) {
    at.push_back(side.lower +
                 (side.upper - side.lower) * Rational(static_cast<unsigned long>(random() % 9), 8));
  }
  OrbitQuestion asked{q.family, {{at[0]}, {at[1]}, {at[2]}, {at[3]}, {at[4]}, {at[5]}}, {}, {}, 20};
  if (at.size() > place_of_ur) {
    asked.ur = Range{at[place_of_ur]};
  }
  return list_orbits(asked);
}

// Checks a sample of the leaves; returns how many orbits were met.
std::size_t check_leaves(const Question& q, std::size_t one_in) {
  std::vector<Leaf> leaves;
  work_on_all(
      q, {whole}, [] { return false; },
      [&](const std::vector<Leaf>& some) { leaves.insert(leaves.end(), some.begin(), some.end()); });
  std::mt19937_64 random(7);
  std::size_t orbits = 0;
  for (const Leaf& leaf : leaves) {
    if (leaf.finding.orbits < 0 || random() % one_in != 0) {
      continue;
    }
    const OrbitList list = list_at(q, box_of(q, leaf.tile), random);
    if (!list.complete()) {
      continue;
    }
    INFO("tile " << leaf.tile << " of " << text_of(q));
    CHECK(list.orbits.size() == static_cast<std::size_t>(leaf.finding.orbits));
    const auto admissible = std::count_if(list.orbits.begin(), list.orbits.end(), [](const Orbit& orbit) {
      return orbit.admissible.truth == Truth::proved;
    });
    const auto stable = std::count_if(list.orbits.begin(), list.orbits.end(), [](const Orbit& orbit) {
      return orbit.stability && orbit.stability->kind == motion::StabilityKind::stable;
    });
    CHECK((leaf.finding.admissible < 0 || leaf.finding.admissible == admissible));
    CHECK((leaf.finding.stable < 0 || leaf.finding.stable == stable));
    orbits += list.orbits.size();
  }
  return orbits;
}

TEST_CASE("Leaves say what the lists of orbits say at points in them") {
  CHECK(check_leaves(question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.55..0.6", "0..0.1"}, 5),
                     30) > 0);
  CHECK(check_leaves(
            question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.7..0.72", "0.1..0.15"}, 5), 20) >
        0);
  CHECK(check_leaves(question(families::nonsticking(), {"0.3", "4", "0.1", "0", "0.58..0.61", "0.5..1.5"}, 5),
                     30) > 0);
  CHECK(check_leaves(
            question(families::nonsticking(), {"0.3", "4", "0.1", "0.1", "0.6", "0.8..1", "0.15..0.25"}, 5),
            20) > 0);
  CHECK(check_leaves(question(families::nonsticking(), {"0.3", "4", "0.1", "-0.2..-0.1", "0.6", "0.9..1"}, 5),
                     20) > 0);
  CHECK(check_leaves(question(families::symmetric(),
                              {"0.5..0.501", "3.8..3.801", "0.02", "1", "0.7", "0.1..0.101"}, 2),
                     1) > 0);
  CHECK(check_leaves(
            question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.624..0.64", "0.132..0.168"}, 5),
            40) > 0);
}

TEST_CASE("Both kinds of balls find the same, where both find something") {
  const Question q =
      question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.55..0.56", "0.05..0.06"}, 10);
  std::mt19937_64 random(5);
  int decided = 0;
  for (int i = 0; i < 12; ++i) {
    Tile tile = whole;
    while (depth(tile) < 10 + i % 6) {
      tile = 2 * tile + random() % 2;
    }
    const Finding fast = judge(q, tile, Balls::hardware);
    const Finding exact = judge(q, tile, Balls::arb);
    CHECK((fast.orbits < 0 || exact.orbits < 0 || fast.orbits == exact.orbits));
    CHECK((fast.admissible < 0 || exact.admissible < 0 || fast.admissible == exact.admissible));
    CHECK((fast.stable < 0 || exact.stable < 0 || fast.stable == exact.stable));
    decided += fast.orbits >= 0 && exact.orbits >= 0 ? 1 : 0;
  }
  CHECK(decided > 0);
}

TEST_CASE("What no verdict may be given on is left open, with its reason") {
  const auto reason = [](const families::Family& family, const std::vector<std::string>& data) {
    const Question q = question(family, data, 1);
    return static_cast<Reason>(judge(q, whole).reason);
  };
  const families::Family& S = families::symmetric();
  const families::Family& P = families::nonsticking();
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "-2..-1", "0.1"}) == Reason::outside);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "-1..0", "0.7", "0.1"}) == Reason::outside);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "0.7", "-0.1..0.1"}) == Reason::reaches_out);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "0..1", "0.7", "0.1"}) == Reason::reaches_out);
  CHECK(reason(P, {"0.3", "4", "0.1", "0", "0.6", "1", "0.05..0.2"}) == Reason::reaches_out);
  CHECK(reason(P, {"0.3", "4", "0.1", "0", "0.6", "1", "0.05..0.1"}) == Reason::outside);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "0.6135..0.6136", "0.1"}) == Reason::resonance);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "0.7", "0..0.0001"}) == Reason::no_load);
  CHECK(reason(P, {"0.3", "4", "0.1", "-0.001..0.001", "0.6", "1"}) == Reason::belt_at_rest);
}

// u² - a over a in [low, high], u in [0, 1]: a fold at a = 0, the zero leaves at a = 1.
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
    const auto found = zeros_over<HardwareBall, 3>(f, f, 0x1p-12);
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
  const auto found = zeros_over<HardwareBall, 3>(f, f, 0x1p-12);
  const Bracket second = std::get<std::vector<Bracket>>(found).at(1);
  const auto zero = zero_over<HardwareBall, 3>(f, f, second);
  CHECK(zero.at.ball().contains(Ball(Rational(4, 5))));
  for (const double a : {0.08, 0.085, 0.09, 0.1}) {
    CHECK(zero.over.ball().contains(Ball(0.5) + sqrt(Ball(a)).midpoint()));
  }
}

TEST_CASE("Polynomials with known zeros are inside the unit circle, or not") {
  using T = Form<Ball, 3>;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> modulus(0, 1.6);
  std::uniform_real_distribution<double> angle(0, 3.14);
  int proved = 0;
  int refuted = 0;
  for (int i = 0; i < 300; ++i) {
    // (x² - 2 r cos(t) x + r²)(x - s)(x - q)
    const double r = modulus(random);
    const double t = angle(random);
    const double s = modulus(random) * (random() % 2 == 0 ? 1 : -1);
    const double q = modulus(random);
    std::vector<T> c{T(Ball(r) * Ball(r)), T(Ball(-2) * Ball(r) * cos(Ball(t)))};
    for (const double root : {s, q}) {
      std::vector<T> next(c.size() + 1, T(0));
      for (std::size_t k = 0; k <= c.size(); ++k) {
        const T here = k < c.size() ? c[k] : T(1);
        next[k] = next[k] - here * T(Ball(root));
        if (k < c.size()) {
          next[k + 1] = next[k + 1] + c[k];
        }
      }
      c = next;
    }
    const double largest = std::max({r, std::abs(s), q});
    const Truth truth = is_inside_unit_circle(c);
    CHECK((truth != Truth::proved || largest < 1));
    CHECK((truth != Truth::refuted || largest > 1));
    proved += truth == Truth::proved ? 1 : 0;
    refuted += truth == Truth::refuted ? 1 : 0;
  }
  CHECK(proved > 10);
  CHECK(refuted > 10);
  CHECK(is_inside_unit_circle<T>({T(-1)}) == Truth::undecided);       // x = 1
  CHECK(is_inside_unit_circle<T>({T(1), T(0)}) == Truth::undecided);  // x = ±i
}

TEST_CASE("The characteristic polynomial has the multipliers as its zeros") {
  std::mt19937_64 random(19);
  int looked_at = 0;
  for (const Question& q : {question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.6", "0.05"}, 1),
                            question(families::symmetric(), {"0.4", "3", "0.03", "1.2", "0.7", "0.1"}, 1),
                            question(families::nonsticking(), {"0.3", "4", "0.1", "0.1", "0.6", "1"}, 1)}) {
    for (const Orbit& orbit : list_at(q, q.region, random).orbits) {
      if (!orbit.stability || orbit.stability->multipliers.empty()) {
        continue;
      }
      ++looked_at;
      const std::vector<Ball> c = characteristic_polynomial<Ball>(orbit.motion);
      for (const double x : {-1.5, 0.5, 2.0}) {
        Ball p(1);
        for (std::size_t i = c.size(); i-- > 0;) {
          p = p * Ball(x) + c[i];
        }
        p *= c.size() == 3 ? Ball(x) : Ball(1);  // the multiplier 0 of a landing
        Ball re(1);
        Ball im(0);
        for (const motion::ComplexBall& mu : orbit.stability->multipliers) {
          const Ball a = Ball(x) - mu.re;
          const Ball old = re;
          re = re * a + im * mu.im;
          im = im * a - old * mu.im;
        }
        CHECK(p.overlaps(re));
        CHECK((p - re).radius().approximate() < 1e-9);
        CHECK(im.contains_zero());
      }
    }
  }
  CHECK(looked_at >= 4);
}

// Every formula over forms contains its values at points of the box.
template <class S>
void check_inclusion() {
  using T = Form<S, 3>;
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const double x0 = share(random) * 3;
    const double y0 = share(random) * 3;
    const double rx = std::abs(share(random)) * 0.3;
    const double ry = std::abs(share(random)) * 0.3;
    const auto f = [](const auto& x, const auto& y) {
      using Q = std::decay_t<decltype(x)>;
      const Q a = Q(sinc(Q(x * y))) * Q(cos(y)) - Q(sinc_slope(x)) / Q(Q(4) + x);
      return Q(a * Q(sqrt(Q(Q(1) + x * x))) + Q(sin(Q(x - y))));
    };
    const T value = f(T::variable(x0, rx, 0), T::variable(y0, ry, 2));
    for (int k = 0; k < 5; ++k) {
      const Ball x = Ball(x0) + Ball(share(random)) * Ball(rx);
      const Ball y = Ball(y0) + Ball(share(random)) * Ball(ry);
      if constexpr (std::is_same_v<S, Ball>) {
        CHECK(value.over.contains(f(x, y).midpoint()));
      } else {
        CHECK(value.over.ball().contains(f(x, y).midpoint()));
      }
    }
  }
}

TEST_CASE("Forms contain what they stand for") {
  check_inclusion<Ball>();
  check_inclusion<HardwareBall>();
}

}  // namespace
}  // namespace stickslip::numeric::atlas
