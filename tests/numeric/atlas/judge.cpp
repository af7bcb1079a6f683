// What a leaf says, held against the lists of orbits at exact points in it: another search, other equations
// of closing, other proofs of the conditions, other multipliers.
#include <random>

#include <doctest/doctest.h>
#include "core/decimal.hpp"
#include "numeric/atlas/judge.hpp"
#include "numeric/atlas/judging.hpp"
#include "numeric/atlas/overshooting_orbit.hpp"
#include "numeric/atlas/symmetric_orbit.hpp"
#include "numeric/atlas/work.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/overshooting.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/machine.hpp"
#include "numeric/orbits.hpp"
#include "numeric/scalars/form.hpp"
#include "numeric/zeros/linear_solve.hpp"

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

Question question(const families::Family& family, const std::vector<std::string>& data, int resolution,
                  Values values = Values::data) {
  Question q{&family, {}, {}, resolution, values};
  for (const std::string& text : data) {
    q.region.push_back(interval(text));
    if (!q.region.back().is_point()) {
      q.axes.push_back(q.region.size() - 1);
    }
  }
  return q;
}

// The machine in SI units that has these values.
MachineInSI machine_of(const Question& q, const std::vector<Rational>& at) {
  const auto value = [&](const char * name) { return at.at(place_of(q, name)); };
  const Rational normal = q.values == Values::forces ? Rational(1) : value("normal_force");
  MachineInSI machine{
      value("m1"),
      value("m2"),
      value("k1"),
      value("k2"),
      normal * value(q.values == Values::forces ? "friction_force_sliding" : "friction_sliding"),
      {},
      value("belt_velocity"),
      value("load_amplitude"),
      value("load_frequency")};
  if (at.size() == names_of(q).size() && !takes_phi(*q.family)) {
    machine.friction_at_rest = normal * at.back();
  }
  return machine;
}

// The list at the corner of a box, or at a point within it; of machines, whose data are rounded, within it.
OrbitList list_at(const Question& q, const Box& box, std::mt19937_64& random) {
  std::vector<Rational> at;
  for (const Interval& side : box) {
    const auto eighths = static_cast<unsigned long>(q.is_in_SI() ? 1 + random() % 7 : random() % 9);
    at.push_back(side.lower + (side.upper - side.lower) * Rational(eighths, 8));
  }
  if (q.is_in_SI()) {
    const DataTaken taken = data_taken(machine_of(q, at));
    const motion::ExactParameters& a = taken.data;
    OrbitQuestion asked{q.family, {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}}, {}, {}, 20};
    if (takes_phi(*q.family)) {
      asked.phi = Range{at.back()};
    } else if (taken.ur) {
      asked.ur = Range{*taken.ur};
    }
    return list_orbits(asked);
  }
  OrbitQuestion asked{q.family, {{at[0]}, {at[1]}, {at[2]}, {at[3]}, {at[4]}, {at[5]}}, {}, {}, 20};
  if (at.size() > place_of_datum) {
    (takes_phi(*q.family) ? asked.phi : asked.ur) = Range{at[place_of_datum]};
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
  // The whole of the paper's neighbourhood, over resonances, folds, poles.
  CHECK(check_leaves(question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.5..0.8", "0..0.2"}, 6),
                     60) > 0);
  CHECK(check_leaves(
            question(families::nonsticking(), {"0.3", "4", "0.1", "0", "0.5..0.8", "0.5..1.5", "0.2"}, 6),
            60) > 0);
  // On both sides of the curve where (18) fails, and of a fold.
  CHECK(check_leaves(question(families::overshooting(),
                              {"0.2", "4", "0.05", "1", "0.63..0.6325", "0.049..0.051", "0"}, 4),
                     20) > 0);
  CHECK(check_leaves(question(families::overshooting(),
                              {"0.2", "4", "0.05", "1", "0.614..0.624", "0.05..0.051", "0"}, 5),
                     30) > 0);
}

TEST_CASE("Leaves say what the lists of orbits say in stripes, and where V, ur and the masses vary" *
          doctest::test_suite("nightly") * doctest::skip()) {
  CHECK(check_leaves(
            question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.6..0.632", "0.1..0.101"}, 6), 30) >
        0);
  CHECK(check_leaves(
            question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.524..0.532", "0.1..0.101"}, 6),
            30) > 0);
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

TEST_CASE("Leaves of machines in SI units say what the lists of orbits of machines in them say" *
          doctest::test_suite("nightly") * doctest::skip()) {
  const auto machines = [](const families::Family& family, const std::vector<std::string>& values,
                           int resolution, Values kind) {
    Question q = question(family, values, resolution, kind);
    require_understood(q);
    return q;
  };
  const families::Family& S = families::symmetric();
  const families::Family& P = families::nonsticking();
  const families::Family& O = families::overshooting();
  // Masses and stiffnesses, with a moving belt and at rest; friction by coefficients and by forces.
  CHECK(
      check_leaves(machines(S, {"3.5..4.1", "1", "180..216", "200", "0.1", "0.08", "0.01", "0.0105", "0.93"},
                            6, Values::coefficients),
                   60) > 0);
  CHECK(check_leaves(
            machines(P, {"3.8..4.2", "1", "304..336", "80", "0.02", "0.01", "0.1", "1.1"}, 5, Values::forces),
            40) > 0);
  CHECK(check_leaves(
            machines(P,
                     {"4", "0.9..1.1", "280", "110..130", "0.1", "0.4..0.41", "0", "0.1", "0.95", "0.5..0.8"},
                     4, Values::coefficients),
            60) > 0);
  CHECK(check_leaves(
            machines(O, {"4", "1", "320", "80..80.2", "0.1", "0.2", "0.01", "0.005", "1.0009..1.0012", "0"},
                     4, Values::coefficients),
            20) > 0);
}

TEST_CASE("The forms of a box of machines contain the data of those in it, however these vary together") {
  using T = Form<HardwareBall, 5>;
  const Question q =
      question(families::nonsticking(),
               {"4", "0.5..2", "100..400", "50..90", "0.1", "0.3", "0.01", "0.02..0.05", "1.1", "0.4"}, 1,
               Values::coefficients);
  CHECK(axis_names(q) == std::vector<std::string>{"m2", "k1", "k2", "load_amplitude"});
  const Data<T, HardwareBall> forms = forms_of<T, HardwareBall>(q, q.region);
  std::mt19937_64 random(19);
  for (int i = 0; i < 200; ++i) {
    std::vector<Rational> at;
    for (const Interval& side : q.region) {
      at.push_back(side.lower +
                   (side.upper - side.lower) * Rational(static_cast<unsigned long>(random() % 9), 8));
    }
    const DataTaken taken = data_taken(machine_of(q, at));
    const motion::ExactParameters& a = taken.data;  // omega and V to 20 digits, more than doubles have
    const auto contains = [](const T& form, const Rational& x) { return form.over.ball().contains(x); };
    CHECK(contains(forms.parameters.chi, a.chi));
    CHECK(contains(forms.parameters.eta, a.eta));
    CHECK(contains(forms.parameters.us, Rational(1)));
    CHECK(contains(forms.parameters.V, Rational(a.V / a.us)));
    CHECK(contains(forms.parameters.omega, a.omega));
    CHECK(contains(forms.parameters.p, Rational(a.p / a.us)));
    CHECK(contains(*forms.datum, Rational(*taken.ur / a.us)));
  }
}

// Nothing is known beforehand.
Finding judge_alone(const Question& q, Tile tile, Balls balls) {
  Knowledge nothing;
  return judge(q, tile, balls, nothing);
}

bool agree(const Finding& a, const Finding& b) {
  const auto one = [](int x, int y) { return x < 0 || y < 0 || x == y; };
  return one(a.orbits, b.orbits) && one(a.admissible, b.admissible) && one(a.stable, b.stable);
}

TEST_CASE("Both kinds of balls find the same, with what is known around a box and without") {
  int decided = 0;
  std::mt19937_64 random(5);
  for (const Question& q :
       {question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.55..0.56", "0.05..0.06"}, 10),
        question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.6..0.65", "0..0.2"}, 10),
        question(families::nonsticking(), {"0.3", "4", "0.1", "0", "0.55..0.8", "0.5..1.5", "0.2"}, 10)}) {
    for (int i = 0; i < 6; ++i) {
      Tile tile = whole;
      while (depth(tile) < 10 + i) {
        tile = 2 * tile + random() % 2;
      }
      const Finding fast = judge_alone(q, tile, Balls::hardware);
      const Finding exact = judge_alone(q, tile, Balls::arb);
      const Finding from_whole = judge_from_whole(q, tile, Balls::hardware);
      CHECK(agree(fast, exact));
      CHECK(agree(fast, from_whole));
      CHECK(agree(exact, from_whole));
      decided += fast.orbits >= 0 && exact.orbits >= 0 ? 1 : 0;
    }
  }
  CHECK(decided > 0);
}

TEST_CASE("What no verdict may be given on is left open, with its reason") {
  const auto reason = [](const families::Family& family, const std::vector<std::string>& data) {
    const Question q = question(family, data, 1);
    return static_cast<Reason>(judge_alone(q, whole, Balls::both).reason);
  };
  const families::Family& S = families::symmetric();
  const families::Family& P = families::nonsticking();
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "-2..-1", "0.1"}) == Reason::outside);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "-1..0", "0.7", "0.1"}) == Reason::outside);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "0.7", "-0.1..0.1"}) == Reason::reaches_out);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "0..1", "0.7", "0.1"}) == Reason::reaches_out);
  CHECK(reason(P, {"0.3", "4", "0.1", "0", "0.6", "1", "0.05..0.2"}) == Reason::reaches_out);
  CHECK(reason(P, {"0.3", "4", "0.1", "0", "0.6", "1", "0.05..0.1"}) == Reason::outside);
  CHECK(reason(P, {"0.3", "4", "0.1", "0", "0.7..0.71", "1", "0.2"}) == Reason::resonance);
  CHECK(reason(S, {"0.5", "3.8", "0.02", "1", "0.7", "0..0.0001"}) == Reason::no_load);
  CHECK(reason(P, {"0.3", "4", "0.1", "-0.001..0.001", "0.6", "1"}) == Reason::belt_at_rest);
  // Of machines: what the belt and the load do.
  const auto of_machine = [](const families::Family& family, const char * belt, const char * load,
                             const char * m1) {
    const Question q = question(family, {m1, "1", "320", "80", "0.02", belt, load, "1.1"}, 1, Values::forces);
    return static_cast<Reason>(judge_alone(q, whole, Balls::both).reason);
  };
  CHECK(of_machine(S, "0", "0.1", "4..4.1") == Reason::outside);
  CHECK(of_machine(S, "0..0.1", "0.1", "4") == Reason::reaches_out);
  CHECK(of_machine(P, "0..0.0001", "0.1", "4") == Reason::belt_at_rest);
  CHECK(of_machine(S, "0.01", "0..0.0001", "4") == Reason::no_load);
}

TEST_CASE(
    "The functions of overshooting orbits vanish at those of the list, and not where a row is another") {
  using T = Form<Ball, 4>;
  using OverOrbit = OvershootingOrbit<Ball, 4>;
  std::mt19937_64 random(3);
  int looked_at = 0;
  for (const char * omega : {"0.6289", "0.61825", "0.6184", "0.645", "0.62", "0.64"}) {
    const Question q =
        question(families::overshooting(), {"0.2", "4", "0.05", "1", omega, "0.05..0.0501", "0.1"}, 1);
    Box box = q.region;
    box[place_of_p].upper = box[place_of_p].lower;
    std::vector<T> a;
    for (const Interval& x : box) {
      a.emplace_back(Ball(x.lower));
    }
    const auto setting = OverOrbit::setting({a[0], a[1], a[2], a[3], a[4], a[5]}, a[6]);
    for (const Orbit& orbit : list_at(q, box, random).orbits) {
      const Ball total = orbit.value("tau") + orbit.value("tau1");
      const T s(total / orbit.value("Theta"));
      const T w(orbit.value("tau1") / total);
      const auto f = OverOrbit::look(setting, s, w);
      REQUIRE(f);
      CHECK(f->at(0).over.contains_zero());
      CHECK(f->at(1).over.contains_zero());
      CHECK(OverOrbit::at(setting, s, w));
      const T moved(s.at + Ball(1e-6));
      const auto beside = OverOrbit::look(setting, moved, w);
      CHECK((!beside || beside->at(1).over.is_nonzero()));
      auto other = setting;
      other.closing.d.us = T(Ball(0.06));
      const auto wrong = OverOrbit::look(other, s, w);
      CHECK((!wrong || wrong->at(1).over.is_nonzero()));
      ++looked_at;
    }
  }
  CHECK(looked_at >= 8);
}

TEST_CASE("No box is decided over which an overshooting orbit grows beyond all bounds") {
  // ur goes to infinity at omega = 0.6182496, nearly, and comes back from minus infinity: there are two zeros
  // all along, and two orbits but there.
  const auto found = [](const std::string& omega) {
    return judge_alone(question(families::overshooting(), {"0.2", "4", "0.05", "1", omega, "0.05", "0"}, 4),
                       whole, Balls::both);
  };
  CHECK(found("0.61825..0.6182501").orbits == 2);
  const Finding across = found("0.6182495..0.6182498");
  CHECK(across.orbits == -1);
  CHECK(static_cast<Reason>(across.reason) == Reason::no_amplitude);
}

TEST_CASE("Three multipliers are inside the unit circle, or not") {
  using T = Form<Ball, 3>;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> modulus(0, 1.6);
  std::uniform_real_distribution<double> angle(0, 3.14);
  const auto truth = [](const Ball& sum, const Ball& product, const Ball& a) {  // of a pair, and the third
    const T e1(sum + a);
    const T e2(product + a * sum);
    const T e3(a * product);
    return is_inside_unit_circle<T>({e1, e2, e3}, T(T(1) - e1 + e2 - e3)).truth;
  };
  int proved = 0;
  int refuted = 0;
  for (int i = 0; i < 400; ++i) {
    const double a = modulus(random) * (random() % 2 == 0 ? 1 : -1);
    const double b = modulus(random) * (random() % 2 == 0 ? 1 : -1);
    const double c = modulus(random) * (random() % 2 == 0 ? 1 : -1);
    const bool real = i % 2 == 0;
    const Truth said = real ? truth(Ball(b) + Ball(c), Ball(b) * Ball(c), Ball(a))
                            : truth(Ball(2) * Ball(b) * cos(Ball(angle(random))), Ball(b) * Ball(b), Ball(a));
    const double largest = std::max({std::abs(a), std::abs(b), real ? std::abs(c) : 0});
    CHECK((said != Truth::proved || largest < 1));
    CHECK((said != Truth::refuted || largest > 1));
    proved += said == Truth::proved ? 1 : 0;
    refuted += said == Truth::refuted ? 1 : 0;
  }
  CHECK(proved > 10);
  CHECK(refuted > 10);
  CHECK(truth(Ball(0), Ball(1), Ball(0)) == Truth::undecided);    // ±i
  CHECK(truth(Ball(0.5), Ball(0), Ball(1)) == Truth::undecided);  // 1
  CHECK(truth(Ball(5), Ball(6), Ball(Rational(1, 100))) ==
        Truth::refuted);  // 2 and 3: p(1), p(-1) do not tell
}

TEST_CASE("The multipliers of symmetric orbits are those of the list, also near a natural frequency") {
  using T = Form<Ball, 3>;
  std::mt19937_64 random(19);
  int looked_at = 0;
  for (const Question& q : {question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.6", "0.05"}, 1),
                            question(families::symmetric(), {"0.5", "3.8", "0.02", "1", "0.6135", "0.1"}, 1),
                            question(families::symmetric(), {"0.4", "3", "0.03", "1.2", "0.7", "0.1"}, 1)}) {
    std::vector<T> data;
    for (const Interval& x : q.region) {
      data.emplace_back(Ball(x.lower));
    }
    const Setting<T> setting =
        setting_of<T>({data[0], data[1], data[2], data[3], data[4], data[5]}, T(Ball::pi()));
    for (const Orbit& orbit : list_at(q, q.region, random).orbits) {
      if (!orbit.stability || orbit.stability->multipliers.empty()) {
        continue;
      }
      const bool first = cos(orbit.motion.phases[0].load +
                             orbit.motion.phases[0].duration * orbit.motion.oscillator.data.omega / Ball(2) -
                             Ball::pi() / Ball(2))
                             .is_positive();
      const T share(orbit.motion.phases[0].duration / motion::period(orbit.motion));
      const auto here = SymmetricOrbit<T>::at({Sheet::Kind::symmetric, first ? 1 : -1}, setting, share, {});
      REQUIRE(here);
      ++looked_at;
      const auto [e1, e2, e3] = here->multipliers();
      for (const double x : {-1.5, 0.5, 2.0, 1.0}) {
        const Ball X(x);
        const Ball p =
            X * (X * X * X - e1.at * X * X + e2.at * X - e3.at);  // and the multiplier 0 of landing
        Ball re(1);
        Ball im(0);
        for (const motion::ComplexBall& mu : orbit.stability->multipliers) {
          const Ball a = X - mu.re;
          const Ball old = re;
          re = re * a + im * mu.im;
          im = im * a - old * mu.im;
        }
        CHECK(p.overlaps(re));
        CHECK((p - re).radius().approximate() < 1e-9);
        if (x == 1.0) {
          const Ball again = here->at_one().at * data[5].at;
          CHECK(again.overlaps(p));
          CHECK((again - p).radius().approximate() < 1e-9);
          CHECK(again.is_nonzero());
        }
      }
      // What the header derives, at the orbit.
      const Ball ur_less_us =
          here->rho(T((data[4].at * Ball(0)) + orbit.motion.phases[1].duration / Ball(2)))[0].at;
      const Ball r = model::friction_at<Ball>(orbit.motion.oscillator.data, orbit.motion.phases[0].Z,
                                              orbit.motion.phases[0].load);
      CHECK(ur_less_us.overlaps(r - orbit.motion.oscillator.data.us));
    }
  }
  CHECK(looked_at >= 4);
}

TEST_CASE(
    "Orbits that never stick are called stable only where no coincidence keeps a multiplier on the circle") {
  using T = Form<Ball, 3>;
  const auto decide = [](double omega, double share) {
    model::Oscillator<T> o;
    o.modes = {T(Ball(Rational(7, 10))), T(Ball(Rational(19, 10))), T(1), T(-1)};
    o.data.omega = T(Ball(parse_rational(std::to_string(omega))));
    return stability_without_stick<T>(o, T(Ball(share))).truth;
  };
  // The largest multiplier in size, in doubles; any 0 < rho < 1.
  const auto largest = [](double omega, double share) {
    const model::Modes<double> m{0.7, 1.9, 1.2, -1.4};
    const double Theta = 2 * M_PI / omega;
    Eigen::Matrix4d D = Eigen::Matrix4d::Identity();
    D(3, 3) = 0.4;
    const Eigen::Matrix4d M =
        D * model::H<double>(m, Theta * (1 - share)) * D * model::H<double>(m, Theta * share);
    return zeros::spectral_radius(M);
  };
  for (const double omega : {0.6, 0.61, 1.2, 1.3, 0.7, 1.4}) {
    for (const double share : {0.5, 0.25, 0.375}) {
      INFO(omega << ' ' << share);
      // 1.2 = omega2 - omega1; 1.4, 3.8, 2.6 the other differences.
      if (decide(omega, share) == Truth::proved) {
        CHECK(largest(omega, share) < 1 - 1e-9);
      } else {
        CHECK(largest(omega, share) > 1 - 1e-9);
      }
    }
  }
  CHECK(decide(0.6, 0.5) == Truth::undecided);  // omega2 - omega1 = 2 omega, tau = Theta/2
  CHECK(decide(0.61, 0.5) == Truth::proved);
}

TEST_CASE("The forms of a box contain its ends") {
  using T = Form<HardwareBall, 3>;
  const Rational third(1, 3);
  const Rational tiny = Rational(1, 1UL << 40U) / 3;
  for (const Interval& side :
       {Interval{third, third + tiny}, Interval{Rational(0), tiny}, Interval{-third, third},
        Interval{Rational(-2) / 7, Rational(-2) / 7 + Rational(1, 1000)}}) {
    const Box box{interval("0.5"), interval("3.8"), interval("0.02"), interval("1"), side, interval("0.1")};
    const Ball omega = forms_of<T, HardwareBall>(Question(), box).parameters.omega.over.ball();
    CHECK(omega.contains(side.lower));
    CHECK(omega.contains(side.upper));
    CHECK(forms_of<T, HardwareBall>(Question(), box).parameters.p.at.ball().contains(box[place_of_p].lower));
  }
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
