// Example O (Fig. 3) and the complete lists of overshooting orbits, at a given phase and at a given friction.
#include "numeric/families/overshooting.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "numeric/families/through_phases/one_stick_closing.hpp"
#include "proofs/pascal2012/examples/example_o_closing.hpp"
#include "tests/numeric/examples.hpp"
#include "tests/numeric/families/random_data.hpp"

using namespace stickslip;
using namespace stickslip::numeric;
using namespace stickslip::numeric::families;
using namespace stickslip::numeric::motion;
using namespace stickslip::numeric::zeros;
using namespace stickslip::examples;

namespace {

OrbitList list_overshooting_at_phase(const ExactParameters& a, const Rational& phi, int digits) {
  return listed(overshooting(), a, digits, phi);
}
OrbitList list_overshooting_at_friction(const ExactParameters& a, const Rational& ur, int digits) {
  return listed(overshooting(), a, digits, {}, ur);
}

// Every phase leads to the next, with z2' = V between them, to the bound.
void check_list(const OrbitList& list, const char * tiny) {
  const Ball bound(parse_rational(tiny));
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    const Orbit& orbit = list.orbits[i];
    std::vector<Ball> residuals;
    for (const model::Vector4<Ball>& gap : gaps(orbit.motion)) {
      residuals.insert(residuals.end(), gap.begin(), gap.end());
    }
    for (const Phase& phase : orbit.motion.phases) {
      residuals.push_back(phase.Z(3) - orbit.motion.oscillator.data.V);
      CHECK(phase.duration.is_positive());
    }
    for (const Ball& residual : residuals) {
      CHECK(residual.contains_zero());
      CHECK((residual.radius() - bound).is_negative());
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Orbit& other = list.orbits[j];
      CHECK_FALSE((other.value("tau").overlaps(orbit.value("tau")) &&
                   other.value("tau1").overlaps(orbit.value("tau1"))));
    }
  }
}

// The same equations by determinants, without the search's way of eliminating: over double.
struct ByDeterminants {
  model::ReducedData<double> data;
  double phi;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& sw) const {
    const auto d = model::lift<T>(data);
    const Eigen::Matrix<T, 2, 1> t = times<T, 2>(d.Theta, sw);
    const std::pair<T, T> psi = sin_cos(T(T(phi) + d.omega * T(t(0) + t(1)) / T(2)));
    const auto known = [&](const model::OvershootingRow<T>& row) {
      return T(row.one + row.cos_psi * psi.second + row.sin_psi * psi.first);
    };
    const auto [odd1, odd2] = model::overshooting_odd<T>(d, t(0), t(1));
    const auto [even1, even2] = model::overshooting_even<T>(d, t(0), t(1));
    const model::OvershootingRow<T> turn = model::overshooting_turn<T>(d, t(0), t(1));
    const T last = known(turn) * odd1.C - turn.C * known(odd1);  // C from odd_1
    const T rest = even1.a * T(even2.D * last - known(even2) * turn.D * odd1.C) -
                   even1.D * T(even2.a * last - known(even2) * turn.a * odd1.C) +
                   known(even1) * T(even2.a * turn.D - even2.D * turn.a) * odd1.C;
    return {T(odd1.C * known(odd2) - known(odd1) * odd2.C), rest};
  }
};

const Orbit * find(const OrbitList& list, const char * tau, const char * tau1) {
  for (const Orbit& orbit : list.orbits) {
    if (near(orbit.value("tau"), tau, "0.001") && near(orbit.value("tau1"), tau1, "0.001")) {
      return &orbit;
    }
  }
  return nullptr;
}

}  // namespace

TEST_CASE("example O: two orbits at phi = 0, the printed one among them, closing in all of (20)") {
  const OrbitList list = list_overshooting_at_phase(O(), 0, 30);
  CHECK(list.complete());
  CHECK(list.orbits.size() == 2);
  check_list(list, "1e-28");
  const Orbit * printed = find(list, "4.909", "2.8275");
  REQUIRE(printed != nullptr);
  CHECK(near(printed->value("ur"), "0.459", "0.001"));
  CHECK(near(printed->value("T"), "2.2543", "0.001"));
}

TEST_CASE("a thousand digits of example O") {
  const OrbitList coarse = list_overshooting_at_phase(O(), 0, 20);
  const OrbitList fine = list_overshooting_at_phase(O(), 0, 1000);
  REQUIRE(fine.orbits.size() == coarse.orbits.size());
  const WorkingPrecision precision(3500);
  check_list(fine, "1e-995");
  for (std::size_t i = 0; i < fine.orbits.size(); ++i) {
    CHECK(fine.orbits[i].value("tau").overlaps(coarse.orbits[i].value("tau")));
    CHECK(fine.orbits[i].value("ur").overlaps(coarse.orbits[i].value("ur")));
    CHECK((fine.orbits[i].value("tau1").radius() - Ball(parse_rational("1e-999"))).is_negative());
  }
}

TEST_CASE("the closing conditions at printed values contain those at every point of the intervals") {
  const auto closing = [](std::array<const char *, 5> text) {
    std::array<Decimal, 5> printed;
    std::transform(text.begin(), text.end(), printed.begin(),
                   [](const char * t) { return parse_decimal(t); });
    return printed_closing_overshooting(O(), 0, printed);
  };
  const PrintedClosing paper = closing({"4.909", "2.8275", "1.2809", "3.3861", "-0.4117"});
  CHECK(paper.verdict.truth == Truth::refuted);
  const PrintedClosing right = closing({"4.90912", "2.82727", "1.28219", "3.38966", "-0.41265"});
  CHECK(right.verdict.truth == Truth::undecided);
  for (const PrintedClosing& c : {paper, right}) {
    for (int i = 0; i < 5; ++i) {
      CHECK(c.at_intervals(i).contains(c.at_points(i)));
    }
  }
}

TEST_CASE("at a given friction the phase is a result, and giving that phase gives the orbit back") {
  const Rational ur = parse_rational("0.459");
  const OrbitList list = list_overshooting_at_friction(O(), ur, 30);
  CHECK(list.complete());
  CHECK(list.orbits.size() == 2);
  check_list(list, "1e-25");
  for (const Orbit& orbit : list.orbits) {
    CHECK(orbit.value("ur").contains(ur));
  }
  // The phase of the first, cut to a decimal: an orbit with nearly the same friction is in that list.
  const Rational phi = parse_decimal(to_text(list.orbits[0].value("phi"), 12).mid).value;
  const OrbitList at_phase = list_overshooting_at_phase(O(), phi, 20);
  CHECK(at_phase.complete());
  CHECK(std::any_of(at_phase.orbits.begin(), at_phase.orbits.end(), [&](const Orbit& orbit) {
    return near(orbit.value("ur"), "0.459", "1e-9") &&
           (abs(orbit.value("tau") - list.orbits[0].value("tau")) - Ball(1e-9)).is_negative();
  }));
}

TEST_CASE("a phase and that phase plus a turn have the same orbits") {
  const OrbitList list = list_overshooting_at_phase(O(), parse_rational("6.283185307"), 15);
  CHECK(list.complete());
  CHECK(list.orbits.size() == 2);
  CHECK(find(list, "4.9091", "2.8273") != nullptr);
}

TEST_CASE("special frequencies: omega = 1/k has no orbit at tau + tau1 = 0") {
  for (const char * omega : {"1", "1/2"}) {
    CAPTURE(omega);
    const OrbitList list = list_overshooting_at_phase(
        parse_parameters("0.2", "4", "0.05", "1", omega, "0.05"), parse_rational("0.3"), 15);
    CHECK(list.complete());
    check_list(list, "1e-10");
  }
  CHECK(list_overshooting_at_friction(parse_parameters("0.2", "4", "0.05", "1", "1", "0.05"), 1, 15)
            .complete());
}

TEST_CASE(
    "3 omega a natural frequency: what stays open lies at T = 0, where zeros are multiple, and says so") {
  // omega1 = 1/2, omega2 = 2.
  const ExactParameters a = parse_parameters("9/13", "169/36", "0.02", "1", "2/3", "0.05");
  const OrbitList list = list_overshooting_at_phase(a, parse_rational("0.3"), 15);
  CHECK_FALSE(list.complete());
  const Ball Theta = Ball(3) * Ball::pi();
  for (const Unresolved& open : list.unresolved) {
    CAPTURE(open.reason);
    const Ball &tau = open.where.at(0).value, &tau1 = open.where.at(1).value;
    CHECK((Theta - tau - tau1).contains_zero());
    CHECK(open.reason.find("$3 omega$ is a natural frequency") != std::string::npos);
    CHECK((tau.radius() - Ball(1e-3)).is_negative());
    const Ball thirds = tau / (Theta / Ball(3));
    CHECK((abs(thirds - Ball(std::lround(thirds.approximate()))) - Ball(1e-3)).is_negative());
  }
}

TEST_CASE("multiples of omega that are natural frequencies are found exactly") {
  const auto at = [](const char * omega) {
    const Resonances k = resonances(parse_parameters("9/13", "169/36", "0.02", "1", omega, "0.05"));
    return std::pair(k.first, k.second);
  };
  CHECK(at("1/2") == std::pair(1L, 4L));
  CHECK(at("2/3") == std::pair(0L, 3L));
  CHECK(at("1/4") == std::pair(2L, 8L));
  CHECK(at("2") == std::pair(0L, 1L));
  CHECK(at("0.6666") == std::pair(0L, 0L));
  CHECK(at("3") == std::pair(0L, 0L));
}

TEST_CASE("lists are complete at low frequency, at omega = 1 and beside resonances") {
  const auto at_omega = [](const char * omega) {
    ExactParameters a = O();
    a.omega = parse_rational(omega);
    return list_overshooting_at_phase(a, 0, 15);
  };
  const OrbitList slow = at_omega("0.1");
  CHECK(slow.complete());
  CHECK(slow.orbits.size() == 46);
  check_list(slow, "1e-8");
  CHECK(at_omega("1").complete());
  CHECK(at_omega("0.999999").complete());
  // omega_2 is nearly 3 omega in the first, omega_1 in the second.
  const auto beside = [](const char * chi, const char * eta, const char * us, const char * V,
                         const char * omega, const char * p, const char * ur) {
    return list_overshooting_at_friction(parse_parameters(chi, eta, us, V, omega, p), parse_rational(ur), 15);
  };
  const OrbitList first =
      beside("0.495312", "0.536287", "0.0222076", "1.82688", "0.357297", "2.55966", "0.0551784");
  CHECK(first.complete());
  CHECK(first.orbits.size() == 3);
  check_list(first, "1e-8");
  const OrbitList second =
      beside("0.0663598", "14.4027", "0.0057671", "1.91771", "0.283835", "2.92935", "0.0402156");
  CHECK(second.complete());
  CHECK(second.orbits.size() == 4);
  check_list(second, "1e-8");
}

TEST_CASE("where modes are fast, their period long and friction small, cells need not be tiny") {
  struct Datum {
    ExactParameters a;
    Rational ur;
    std::size_t orbits;
    long cells;
  };
  const auto exact = [](const char * text) { return parse_rational(text); };
  const std::array<Datum, 2> data{Datum{{exact("0.464374"), exact("16.5543"), exact("0.522701"),
                                         exact("0.106409"), exact("0.351216"), exact("4.20312")},
                                        exact("0.729118"),
                                        36,
                                        50000},
                                  Datum{{exact("0.691524"), exact("29.8869"), exact("0.122693"),
                                         exact("1.87749"), exact("0.55602"), exact("2.1868")},
                                        exact("0.942405"),
                                        40,
                                        60000}};
  for (const Datum& datum : data) {
    const Effort few(datum.cells, {});
    const OrbitList list = list_overshooting_at_friction(datum.a, datum.ur, 10);
    CHECK(list.unresolved.empty());
    CHECK(list.orbits.size() == datum.orbits);
    check_list(list, "1e-10");
  }
}

TEST_CASE("data outside the domain are refused by name") {
  CHECK_THROWS_AS(
      (void)list_overshooting_at_friction(parse_parameters("0.2", "4", "0.05", "1", "0.6", "0"), 1, 15),
      DomainError);
  CHECK_THROWS_AS((void)list_overshooting_at_friction(O(), 0, 15), DomainError);
  CHECK_THROWS_AS(
      (void)list_overshooting_at_phase(parse_parameters("0.2", "4", "0.05", "-1", "0.6", "0.1"), 0, 15),
      DomainError);
}

TEST_CASE("random data: every zero that Newton's method finds from a grid is in the list") {
  RandomData random;
  INFO("STICKSLIP_SEED=", random.seed());
  for (int k = 0; k < 4; ++k) {
    ExactParameters a = random.parameters();
    a.omega = random.between(0.4, 1.5);
    if (is_resonant(a)) {
      continue;
    }
    const Rational phi = random.between(-3, 3);
    CAPTURE(examples::to_string(a));
    CAPTURE(to_string(phi));
    const OrbitList list = list_overshooting_at_phase(a, phi, 15);
    check_list(list, "1e-8");
    const ByDeterminants f{overshooting_data<double>(a), phi.get_d()};
    for (int cell = 0; cell < 100; ++cell) {
      const Eigen::Vector2d start(0.05 + 0.1 * (cell % 10), 0.05 + 0.1 * (cell / 10));
      const auto zero = newton<double, 2>(f, start, 30);
      if (!zero || zero->minCoeff() < 0.001 || zero->maxCoeff() > 0.999) {
        continue;
      }
      const Eigen::Vector2d value = f(*zero);
      const Eigen::Vector2d t = times<double, 2>(f.data.Theta, *zero);
      const bool spurious = std::abs(model::overshooting_odd<double>(f.data, t(0), t(1))[0].C) < 1e-6;
      const bool open = std::any_of(list.unresolved.begin(), list.unresolved.end(), [&](const auto& u) {
        return !(abs(u.where.at(0).value - Ball(t(0))) - Ball(1e-3)).is_positive();
      });
      const bool listed = std::any_of(list.orbits.begin(), list.orbits.end(), [&](const auto& orbit) {
        return (abs(orbit.value("tau") - Ball(t(0))) - Ball(1e-6)).is_negative() &&
               (abs(orbit.value("tau1") - Ball(t(1))) - Ball(1e-6)).is_negative();
      });
      CHECK((listed || open || spurious || value.norm() > 1e-12));
    }
  }
}

TEST_CASE("a record says which belt its orbits need, and which datum") {
  Family other = overshooting();
  other.name = "other";
  other.belt = -1;
  other.why_no_phi = "phi is a result";
  other.why_datum = "other orbits need ur";
  const ExactParameters a = O();
  OrbitQuestion q{&other, {{a.chi}, {a.eta}, {a.us}, {a.V}, {a.omega}, {a.p}}, {}, Range{Rational(1)}};
  CHECK_THROWS_WITH_AS(require_answerable(q), doctest::Contains("V < 0 for other orbits"), DomainError);
  // Of a box all members.
  q.parameters.V = {Rational(-1), Rational(1)};
  CHECK_THROWS_WITH_AS(require_answerable(q), doctest::Contains("V = 0"), DomainError);
  q.parameters.V = {Rational(-1), Rational(1, 2)};
  require_answerable(q);
  q.ur.reset();
  CHECK_THROWS_WITH_AS(require_answerable(q), "other orbits need ur", UsageError);
  q.phi = Range{};
  CHECK_THROWS_WITH_AS(require_answerable(q), "phi is a result", UsageError);
}
