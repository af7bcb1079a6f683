// The basin of steady sliding beside a stick-slip cycle: against known values, motions inside and outside by
// Runge and Kutta, areas of polygons, and machines that have none.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/error.hpp"
#include "numeric/machines/attractors/settle.hpp"
#include "numeric/machines/attractors/steady_sliding.hpp"
#include "numeric/machines/basins/planar_basin.hpp"
#include "tests/numeric/machines/one_mass.hpp"

using namespace stickslip;
using namespace stickslip::numeric::machines;

namespace {

// Friction between 1 and 1/2.
Machine on_belt(const Rational& V, model::Fall fall = model::Fall::exponential, const Rational& at_rest = 1) {
  return one_mass(V, smooth_law(at_rest, {fall, Rational(1), Rational(1, 2), Rational(1, 2), Rational(0)}));
}

const Rectangle starts{-2, 2, 0, 2};

Ball share(const Rational& V, const Rectangle& r) {
  const PlanarBasin basin = planar_basin(on_belt(V), r);
  REQUIRE(basin.verdict.truth == Truth::proved);
  return basin.share;
}

Rational decimal(double x) {
  return Rational(x);
}

// The slip in double, by Runge and Kutta's method.
struct SlipInDouble {
  model::FrictionOscillator<double> o;
  double x, y;

  SlipInDouble(const Machine& machine, double x0, double y0)
      : o(oscillator_as<double>(machine)), x(x0), y(y0) {}
  [[nodiscard]] double steady() const { return o.forward.smooth->force(o.V) / o.stiffness(0, 0); }
  void step(double h) {
    const auto rate = [&](double a, double b) {
      return std::array<double, 2>{
          b, (o.forward.smooth->force(o.V - b) - o.damping(0, 0) * b - o.stiffness(0, 0) * a) / o.masses[0]};
    };
    const auto k1 = rate(x, y), k2 = rate(x + h / 2 * k1[0], y + h / 2 * k1[1]),
               k3 = rate(x + h / 2 * k2[0], y + h / 2 * k2[1]), k4 = rate(x + h * k3[0], y + h * k3[1]);
    x += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0]);
    y += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1]);
  }
};

using Points = std::vector<std::array<double, 2>>;

// K at equal times.
Points points(const Machine& machine, const PlanarBasin& basin, int count) {
  SlipInDouble motion(machine, basin.x.approximate(), 0);
  Points result;
  for (int i = 0; i < count; ++i) {
    result.push_back({motion.x, motion.y});
    motion.step(basin.period.approximate() / count);
  }
  return result;
}

// The polygon's area in the rectangle: cut at each of the sides after the other.
double area(Points polygon, const Rectangle& r) {
  const std::array<std::array<double, 3>, 4> sides{{{1, 0, -r.x_from.get_d()},
                                                    {-1, 0, r.x_to.get_d()},
                                                    {0, 1, -r.y_from.get_d()},
                                                    {0, -1, r.y_to.get_d()}}};
  for (const auto& side : sides) {
    Points cut;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double at_a = side[0] * a[0] + side[1] * a[1] + side[2];
      const double at_b = side[0] * b[0] + side[1] * b[1] + side[2];
      if (at_a >= 0) {
        cut.push_back(a);
      }
      if ((at_a >= 0) != (at_b >= 0)) {
        const double part = at_a / (at_a - at_b);
        cut.push_back({a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])});
      }
    }
    polygon = cut;
  }
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += b[0] * a[1] - a[0] * b[1];
  }
  return twice / 2;
}

double size(const Rectangle& r) {
  return Rational((r.x_to - r.x_from) * (r.y_to - r.y_from)).get_d();
}

}  // namespace

TEST_CASE("the basin on Stribeck's smooth law is the inside of the known cycle") {
  const PlanarBasin basin = planar_basin(on_belt(Rational(3, 2)), starts);
  REQUIRE(basin.verdict.truth == Truth::proved);
  // Found before, by another program.
  CHECK(basin.x.overlaps(Ball::from_interval(Rational("-65008882777307897291/100000000000000000000"),
                                             Rational("-65008882777307897289/100000000000000000000"))));
  CHECK(basin.multiplier.approximate() == doctest::Approx(1.49275012288).epsilon(1e-11));
  CHECK(basin.share.overlaps(Ball::from_interval(Rational("3071261377816008928/10000000000000000000"),
                                                 Rational("3071261377816008930/10000000000000000000"))));
  CHECK(basin.share.radius().approximate() < 1e-18);
  CHECK(basin.x.radius().approximate() < 1e-18);
  CHECK(basin.others.truth == Truth::proved);
}

TEST_CASE("the shares of a rectangle agree with published ones, but where those stopped too early") {
  for (const auto& [V, published] :
       std::vector<std::pair<Rational, double>>{{Rational(1175, 1000), 0.0188},
                                                {Rational(155, 100), 0.3566},
                                                {Rational(17, 10), 0.4940},
                                                {Rational(1775, 1000), 0.5583}}) {
    CHECK(share(V, starts).approximate() == doctest::Approx(published).epsilon(0.01));
  }
}

TEST_CASE("areas of parts of the plane are those of polygons, and add up") {
  for (const model::Fall fall : {model::Fall::exponential, model::Fall::hyperbolic}) {
    const Machine machine = on_belt(Rational(13, 10), fall);
    const auto in = [&](const Rectangle& r) {
      const PlanarBasin basin = planar_basin(machine, r, 10);
      REQUIRE(basin.verdict.truth == Truth::proved);
      return basin;
    };
    const PlanarBasin whole = in(starts);
    const Points K = points(machine, whole, 40000);
    const double left = whole.x.approximate();
    const double right = std::ranges::max_element(K)->at(0);
    const double top = std::ranges::max(K, {}, [](const auto& p) { return p[1]; })[1];
    for (const Rectangle& r : std::vector<Rectangle>{
             {-9, 9, -9, 9},
             starts,
             {decimal(left), decimal(right), decimal(-top), decimal(top)},
             {decimal(left + 0.01), decimal(right - 0.01), decimal(0.01 - top), decimal(top - 0.01)},
             {Rational(1, 2), 9, Rational(-1, 10), Rational(1, 10)},
             {Rational(2, 5), Rational(3, 5), Rational(-1, 10), Rational(1, 10)},
             {decimal(right - 0.1), decimal(right + 0.1), Rational(-1, 3), Rational(1, 4)},
             {decimal(left - 1), decimal(left - 0.5), -1, 1},
             {Rational(-1, 3), Rational(4, 5), decimal(top - 1e-3), 9}}) {
      const PlanarBasin part = in(r);
      CHECK(part.share.radius().approximate() < 1e-10);
      CHECK(part.share.approximate() * size(r) == doctest::Approx(area(K, r)).epsilon(1e-6));
    }
    CHECK(whole.area.overlaps(in({-9, 9, -9, 9}).share * Ball(324)));
    CHECK(in({Rational(2, 5), Rational(3, 5), Rational(-1, 10), Rational(1, 10)}).share.overlaps(Ball(1)));
    // A rectangle in four.
    const Rational x(1, 3), y(2, 7);
    Ball sum(0);
    for (const Rectangle& r :
         std::vector<Rectangle>{{-2, x, 0, y}, {x, 2, 0, y}, {-2, x, y, 2}, {x, 2, y, 2}}) {
      sum += in(r).share * Ball(Rational((r.x_to - r.x_from) * (r.y_to - r.y_from)));
    }
    CHECK(sum.overlaps(whole.share * Ball(8)));
  }
}

TEST_CASE("motions from inside of K end in steady sliding, from just outside at the belt") {
  const Machine machine = on_belt(Rational(3, 2));
  const PlanarBasin basin = planar_basin(machine, starts);
  constexpr int count = 1000, most_turns = 80;
  constexpr double h = 0.05;
  const Points K = points(machine, basin, count);
  std::mt19937_64 random(11);
  for (const bool inside : {true, false}) {
    int as_proved = 0;
    for (const auto& p : K) {
      const double chance = static_cast<double>(random() >> 11) * 0x1p-53;
      const double far = inside ? 0.999 * std::sqrt(chance) : 1.001 + 0.01 * chance;
      SlipInDouble motion(machine, 0, 0);
      motion.x = motion.steady() + far * (p[0] - motion.steady());
      motion.y = far * p[1];
      const double end = most_turns * basin.period.approximate();
      bool at_belt = false;
      for (double t = 0; t < end && !at_belt; t += h) {
        motion.step(h);
        at_belt = motion.y >= motion.o.V;
      }
      const bool at_rest = std::hypot(motion.x - motion.steady(), motion.y) < 0.01;
      as_proved += (inside ? at_rest : at_belt) ? 1 : 0;
    }
    CHECK(as_proved == count);
  }
}

TEST_CASE("what starts outside of K is seen to end on a cycle") {
  const Machine machine = on_belt(Rational(3, 2));
  const PlanarBasin basin = planar_basin(machine, starts);
  REQUIRE(basin.others.truth == Truth::proved);
  for (const auto& p : points(machine, basin, 12)) {
    for (const double far : {1.1, 1.5, 4.0}) {  // simulated on pieces, whose K is another
      Eigen::VectorXd X(2);
      X << 0.52 + far * (p[0] - 0.52), far * p[1];
      const Settled found = settle(machine, X);
      CHECK(found.kind == stickslip::numeric::attractors::Kind::periodic);
    }
  }
  // With friction at rest that holds whatever comes, or that lets go on the other side at once.
  Machine other = machine;
  other.oscillator.backward.at_rest = 100;
  CHECK(planar_basin(other, starts).others.truth == Truth::proved);
  CHECK(planar_basin(other, {-20, 30, -40, 50}).others.truth == Truth::proved);
  // From very far it takes too many turns to say.
  const Rational far = Rational(1000000) * 1000000 * 1000000 * 1000000;
  const PlanarBasin open = planar_basin(machine, {-far, far, 0, far});
  CHECK(open.verdict.truth == Truth::proved);
  CHECK(open.others.truth == Truth::undecided);
}

// The theorem that makes K the only one, seen: a turn leads closer to steady sliding inside, farther outside.
TEST_CASE("of random machines each has the closed motion that turns in double show, and no other") {
  std::mt19937_64 random(23);
  const auto from = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  int with_cycle = 0, alone = 0;
  for (int count = 0; count < 30; ++count) {
    Machine machine = on_belt(1);
    auto& o = machine.oscillator;
    const double scale = from(0.3, 2), drop = from(0.4, 4), V = scale * from(0.3, 5);
    const bool exponential = count % 2 == 0;
    const double fall = drop / scale * (exponential ? std::exp(-V / scale) : std::pow(1 + V / scale, -2));
    o.masses[0] = decimal(from(0.2, 5));
    o.stiffness(0, 0) = decimal(from(0.2, 5));
    const double viscous = count % 3 == 0 ? from(0, 0.5) * fall : 0;
    o.damping(0, 0) = decimal(fall * from(1, 2.5) - viscous);
    o.V = decimal(V);
    const Rational last = decimal(from(0, 2)), first = last + decimal(drop);
    o.forward = smooth_law(Rational(count % 5 == 0 ? Rational(first * 2) : first),
                           {exponential ? model::Fall::exponential : model::Fall::hyperbolic, first, last,
                            decimal(scale), decimal(viscous)});
    o.backward = o.forward;
    const PlanarBasin basin = planar_basin(machine, starts, 6);
    CAPTURE(count);
    CAPTURE(basin.verdict.reason);
    const bool none = basin.verdict.reason.find("no closed motion is below the belt") == 0;
    with_cycle += basin.verdict.truth == Truth::proved ? 1 : 0;
    alone += none ? 1 : 0;
    if (!none && basin.verdict.truth != Truth::proved) {
      continue;
    }
    // 0: closer to steady sliding after a turn, 1: farther away, 2: at the belt.
    const SlipInDouble any(machine, 0, 0);
    const double h = 1 / (300 * std::sqrt(o.stiffness(0, 0).get_d() / o.masses[0].get_d()));
    const auto led = [&](double behind) {
      SlipInDouble motion(machine, any.steady() - behind, 0);
      for (double last_y = 0;; last_y = motion.y) {
        motion.step(h);
        if (motion.y > V) {
          return 2;
        }
        if ((last_y < 0 && motion.y >= 0) || std::hypot(motion.x - any.steady(), motion.y) < 1e-3 * behind) {
          return motion.x < any.steady() - behind ? 1 : 0;
        }
      }
    };
    const double K = any.steady() - basin.x.approximate();
    int before = 0;
    for (double behind = 1e-3 * V; before < 2; behind *= 1.15) {
      const int now = led(behind);
      CHECK(now >= before);
      before = now;
      if (none) {
        CHECK(now != 1);
      } else if (std::abs(behind / K - 1) > 1e-4) {
        CHECK((now == 0) == (behind < K));
      }
    }
  }
  CHECK(with_cycle >= 5);
  CHECK(alone >= 5);
}

TEST_CASE("where steady sliding is unstable, or no closed motion is below the belt, there is no such basin") {
  const PlanarBasin slow = planar_basin(on_belt(Rational(115, 100)), starts);
  CHECK(slow.verdict.truth == Truth::refuted);
  CHECK(slow.verdict.reason == "steady sliding is unstable");
  const PlanarBasin fast = planar_basin(on_belt(Rational(184, 100)), starts);
  CHECK(fast.verdict.truth == Truth::refuted);
  CHECK(fast.verdict.reason.find("no closed motion is below the belt") == 0);
  // So it is just beyond the end of the range, where the flow's closed motion passes the belt by little.
  const Rational end = decimal(1.8366009722);
  CHECK(planar_basin(on_belt(end), starts).verdict.truth == Truth::proved);
  const PlanarBasin beyond = planar_basin(on_belt(end + Rational(1, 100000000)), starts);
  CHECK(beyond.verdict.truth == Truth::refuted);
  CHECK(planar_basin(on_belt(0), starts).verdict.truth == Truth::refuted);
  // Damped too much to turn about steady sliding, though friction falls faster near the belt.
  Machine damped = on_belt(Rational(19, 20));
  damped.oscillator.stiffness(0, 0) = Rational(3, 10);
  damped.oscillator.damping(0, 0) = Rational(9, 4);
  damped.oscillator.forward = smooth_law(
      6, {model::Fall::exponential, Rational(26, 5), Rational(8, 5), Rational(14, 25), Rational(0)});
  CHECK(planar_basin(damped, starts).verdict.reason.find("comes back closer") != std::string::npos);
  damped.oscillator.damping(0, 0) = 20;
  CHECK(planar_basin(damped, starts).verdict.reason.find("at all velocities") != std::string::npos);
}

TEST_CASE(
    "the range of belt speeds with such a basin ends where steady sliding does and where K meets the belt") {
  const PlanarBasinAlong along =
      planar_basin_along([](const Rational& V) { return on_belt(V); }, 1, 2, starts, 8);
  REQUIRE(along.ends.size() == 2);
  const double lost = std::log(10) / 2;
  CHECK(along.ends[0].is_gained);
  CHECK(!along.ends[0].at_belt);
  CHECK(along.ends[0].first.get_d() < lost);
  CHECK(along.ends[0].last.get_d() > lost);
  CHECK(!along.ends[1].is_gained);
  CHECK(along.ends[1].at_belt);
  CHECK(along.ends[1].first.get_d() > 1.82);
  CHECK(along.ends[1].last.get_d() < 1.84);
  for (const auto& one : along.ends) {
    CHECK(Rational(one.last - one.first).get_d() < 1e-11);
  }
  double before = 0;
  for (const auto& [V, basin] : along.samples) {
    const bool within = V > along.ends[0].first && V < along.ends[1].last;
    CHECK((basin.verdict.truth == Truth::proved) == within);
    if (within) {
      CHECK(basin.share.approximate() > before);
      CHECK(Ball(basin.multiplier - Ball(1)).is_positive());
      before = basin.share.approximate();
    }
  }
}

TEST_CASE("in other units the share is the same") {
  // Lengths in thousandths, times in hundredths, and two masses of 1.
  Machine machine = on_belt(Rational(3, 20));
  auto& o = machine.oscillator;
  o.masses = {Rational(2)};
  o.stiffness(0, 0) = 20000;
  o.damping(0, 0) = 20;
  o.forward =
      smooth_law(20, {model::Fall::exponential, Rational(20), Rational(10), Rational(1, 20), Rational(0)});
  o.backward = o.forward;
  const PlanarBasin basin = planar_basin(machine, {Rational(-1, 500), Rational(1, 500), 0, Rational(1, 5)});
  REQUIRE(basin.verdict.truth == Truth::proved);
  CHECK(basin.others.truth == Truth::proved);
  const PlanarBasin seen = planar_basin(on_belt(Rational(3, 2)), starts);
  CHECK(basin.share.overlaps(seen.share));
  CHECK(basin.share.radius().approximate() < 1e-18);
  CHECK(basin.multiplier.overlaps(seen.multiplier));
  CHECK(Ball(basin.x * Ball(1000)).overlaps(seen.x));
}

TEST_CASE("a belt that runs backwards is seen in a mirror") {
  Machine machine = on_belt(Rational(-3, 2));
  machine.oscillator.forward.at_rest = 7;  // where the belt does not pull
  const PlanarBasin basin = planar_basin(machine, {-2, 2, -2, 0});
  const PlanarBasin seen = planar_basin(on_belt(Rational(3, 2)), starts);
  REQUIRE(basin.verdict.truth == Truth::proved);
  CHECK(basin.x.overlaps(-seen.x));
  CHECK(basin.share.overlaps(seen.share));
}

TEST_CASE("what is no single mass on a belt with friction that falls smoothly is refused") {
  const auto refusal = [](const Machine& machine, const Rectangle& r) {
    try {
      (void)planar_basin(machine, r);
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const Machine good = on_belt(Rational(3, 2));
  Machine two = good, loaded = good, pieces = good, free = good, driven = good, rising = good;
  two.oscillator.masses.emplace_back(1);
  two.oscillator.stiffness = two.oscillator.damping = model::MatrixX<Rational>::Identity(2, 2);
  loaded.oscillator.loads = {{0, 0, Rational(1), Rational(0)}};
  pieces.oscillator.forward.smooth.reset();
  free.oscillator.stiffness(0, 0) = 0;
  driven.oscillator.damping(0, 0) = -1;
  rising.oscillator.forward =
      smooth_law(1, {model::Fall::exponential, Rational(1, 2), Rational(1), Rational(1, 2), Rational(0)});
  CHECK(refusal(good, starts).empty());
  CHECK(refusal(two, starts).find("the number of masses = 2 is outside the allowed range") == 0);
  CHECK(refusal(loaded, starts).find("the number of loads = 1 is outside the allowed range") == 0);
  CHECK(refusal(pieces, starts).find("a smooth law") != std::string::npos);
  CHECK(refusal(free, starts).find("the stiffness = 0 ") == 0);
  CHECK(refusal(driven, starts).find("the damping = -1 ") == 0);
  CHECK(refusal(rising, starts).find("the sliding friction at 0 = 0.5 ") == 0);
  CHECK(refusal(good, {2, 2, 0, 1}).find("the starts' positions = 2..2 ") == 0);
  CHECK(refusal(good, {0, 2, 1, -1}).find("the starts' velocities = 1..-1 ") == 0);
}
