#include "numeric/families/overshooting.hpp"

#include "core/domain.hpp"
#include "core/error.hpp"
#include "numeric/families/through_phases/through_phases.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace scalars;
using namespace zeros;

namespace {

Found search_overshooting(const Given<Rational>& given) {
  const ExactParameters& a = given.data;
  require_stick_slip_domain(a);
  const bool phi_given = given.phi.has_value();
  if (!phi_given) {
    require(a.p != 0, "p", a.p, "p > 0 when ur is given and the load's phase is unknown");
    require(*given.ur > 0, "ur", *given.ur, "ur > 0");
  }
  const FoundOf<Isolated> found = closed_through({given, overshooting().phases});
  Found list{{}, found.unresolved, {}, found.cells};
  for (const Isolated& zero : found.candidates) {
    list.candidates.push_back({zero, OvershootingClosing{phi_given, !phi_given}, 0, phi_given ? -1 : 5});
  }
  return list;
}

}  // namespace

Vector OvershootingClosing::unknowns(const Motion& motion) const {
  if (motion.phases.size() != 3) {
    throw InternalError("an overshooting motion of other phases than a slip, an overshoot and a stick");
  }
  const model::Parameters<Ball>& a = motion.oscillator.data;
  const Phase& slip = motion.phases[0];
  const Ball half_T = motion.phases[2].duration / Ball(2);
  const Ball u = slip.Z(0) - a.chi * slip.Z(1);
  const Ball v = slip.Z(2) - a.chi * a.V;
  const auto [sine, cosine] = sin_cos(half_T);
  Vector x(takes_phi ? 5 : 6);
  x.head<5>() << slip.duration, motion.phases[1].duration, slip.Z(1) - a.V * half_T, u * sine + v * cosine,
      u * cosine - v * sine;
  if (!takes_phi) {
    x(5) = slip.load;
  }
  return x;
}

const Family& overshooting() {
  static const Family family{
      .name = "overshooting",
      .title = "Overshooting orbits: slip to $tau$, overshoot to $tau + tau1$, stick to $Theta$",
      .phases = {PhaseKind::slip, PhaseKind::overshoot, PhaseKind::stick},
      .durations = {"tau", "tau1", "T"},
      .requirements = joined(
          {sound_data({"tau", "tau1", "T"}),
           slip_after_stick(),
           {{"18", "$z2'(tau) = V$, $chi eta (z2B - z1B) - p cos(omega tau + phi) + eta (ur + us) < 0$",
             Quantity::beyond_minus_ur, 1},
            overshoots(1, "$z2' > V$ for $tau < t < tau + tau1$")},
           sticks_at("19", 2, "(tau + tau1)"),
           {{"11.upper",
             "$chi eta (x2 - x1) - p cos(omega t + phi) < eta ur$ for $tau + tau1 < t < Theta$",
             Quantity::below_ur,
             2,
             true,
             {false, true}},
            {"11.lower", "$chi eta (x2 - x1) - p cos(omega t + phi) > -eta ur$ for $tau + tau1 < t < Theta$",
             Quantity::above_minus_ur, 2, true}}}),
      .why_no_phi = "",
      .why_no_ur = "",
      .why_datum =
          "overshooting orbits need exactly one of phi and ur: with phi, ur is a result; with ur, phi is",
      .searched =
          [](const OrbitQuestion& q) {
            return std::string("$tau >= 0$, $tau1 >= 0$, $tau + tau1 <= Theta$ ") +
                   (q.phi ? "at this $phi$" : "for every $phi$ that gives this $ur$");
          },
      .search = search_overshooting,
      .strips = overshooting_strips,
      .judges = &atlas::overshooting_judges,
      .belt = 1,
      // a, C, D: the odd rows, which come first, are free of a and D, the even ones of C.
      .growths = {{{2, 4}, {3}, {0, 1}}, {{3}, {2, 4}, {2, 3}}, {{2, 3, 4}, {}, {}}},
      .first_singular = 2,
      .is_singular_with_m1 = true};
  return family;
}

}  // namespace stickslip::numeric::families
