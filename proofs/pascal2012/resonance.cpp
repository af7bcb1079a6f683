// Orbits that never stick and are not symmetric. Where the first natural frequency is twice the load's, x2'
// of the first mode, epsilon cos(omega_1 t), vanishes at 0 and at tau = pi/omega, and the mode has the load's
// period: it may be added to the motion of (33), as long as x2' keeps its sign on both slips. Other
// resonances follow.

#include <fmt/format.h>

#include "model/nonsticking.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace numeric::motion;
using namespace symbols;

namespace {

constexpr long bits = 192;
const Rational largest_epsilon(1, 20);

const kernel::Variable epsilon{"epsilon"};
const Rational first_frequency(7, 10), second_frequency(13, 10);

struct Data {
  ExactParameters a;
  Rational ur;
};
// With omega = omega_1/2, exactly.
Data data() {
  return {{model::chi_from_frequencies<Rational>(first_frequency, second_frequency),
           model::eta_from_frequencies<Rational>(first_frequency, second_frequency), Rational(1, 10),
           Rational(0), first_frequency / 2, Rational(3)},
          Rational(3, 25)};
}

orbits::Question two_slips(const Data& data) {
  return {.data = data.a,
          .phases = {PhaseKind::slip, PhaseKind::overshoot},
          .durations = {"tau", "tau1"},
          .ur = data.ur};
}

Outcome at_the_data(const std::string& route) {
  return {.route = route, .at = coordinates(data().a, data().ur)};
}

// (35), cos(phi) > 0, nearly.
Ball load_phase() {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(data().a));
  const model::HalfPeriod<Ball> h =
      model::half_period<Ball>(o.data.chi, o.modes, o.d0, o.data.omega, Ball::pi());
  const Ball sin_phi = -h.friction_speed / (o.Q(1) * o.data.omega);
  Ball phi;
  arb_asin(phi.raw(), sin_phi.raw(), WorkingPrecision::bits());
  return phi;
}

// The motion of (33) with (35), plus the mode: amplitudes of its phases, each from its beginning.
class WithMode {
 public:
  // Ranges of epsilon ⊢ there are phi and the motion, an orbit, with tau = pi/omega and x1(0) +
  // x1(tau) = 2 epsilon.
  [[nodiscard]] kernel::Theorem theorem(const orbits::Ranges& ranges) const {
    const WorkingPrecision precision(bits);
    const Rational near = orbits::near(load_phase()), apart(1, 64);
    const kernel::Substitution numbers{{omega_, question_.data.omega}, {omega2_, second_frequency}};
    const kernel::Definition speed("speed_at_start", {phi_}, substitute(speed_at_start(), numbers));
    const orbits::AllZeros found =
        orbits::all_zeros(orbits::differentiable(speed), {}, phi_, {near - apart, near + apart}, {}, {near});
    const orbits::EnclosedZero& zero = found.zeros.front();
    const kernel::Theorem rests = kernel::Theorem::convert(
        tactics::part(kernel::Theorem::assume(zero.says), 2), equal(speed.unfolded({zero.x}), 0), {speed});
    orbits::ClosedForm known{values_, numbers, ranges,
                             equal(substitute(speed_at_start(), {{phi_, zero.x}}), 0)};
    known.values.emplace(phi_, zero.x);
    known.parameters.emplace(zero.x, zero.bounds);
    const kernel::Variable tau{"tau"};
    const kernel::Term start = orbits::Names::state(0, 0), end = orbits::Names::state(0, tau);
    const kernel::Theorem orbit =
        orbits::orbit_theorem(question_, known,
                              {equal(tau, substitute(values_.at(tau), numbers)),
                               equal(entry(start, 0) + entry(end, 0), kernel::Term(2) * epsilon)});
    return kernel::Theorem::choose(zero.exists, zero.x,
                                   orbits::within_bounds(zero, kernel::Theorem::cut(rests, orbit)));
  }

  WithMode() {
    values_ = {{{"omega1"}, kernel::Term(2) * omega_}, {{"tau"}, kernel::pi() / omega_}};
    for (const int j : {0, 1}) {
      const kernel::Term rest = rest_(j).term, swing = j == 0 ? kernel::Term(0) : tangent() * rest,
                         mode = j == 0 ? kernel::Term(epsilon) : 0;
      values_.emplace(kernel::Variable{fmt::format("A{}_1", j + 1)}, mode - rest);
      values_.emplace(kernel::Variable{fmt::format("B{}_1", j + 1)}, -swing);
      values_.emplace(kernel::Variable{fmt::format("A{}_2", j + 1)}, mode + rest);
      values_.emplace(kernel::Variable{fmt::format("B{}_2", j + 1)}, swing);
    }
  }

 private:
  // tan(omega2 pi/(2 omega)), that of omega1 is zero: in letters, for as numbers both would make one phase.
  [[nodiscard]] kernel::Term tangent() const {
    return kernel::tan(omega2_ * kernel::pi() / (kernel::Term(2) * omega_));
  }
  // -x2'(0), which (35) says is zero.
  [[nodiscard]] kernel::Term speed_at_start() const {
    return kernel::Term(orbits::Phases(question_).Q()[1]) * omega_ * kernel::sin(phi_) +
           modes_.lambda2.term * omega2_ * rest_(1).term * tangent();
  }

  orbits::Question question_ = two_slips(data());
  kernel::Variable phi_{"phi"}, omega_{"omega"}, omega2_{"omega2"};
  using Symbolic = tactics::Symbolic;
  Symbolic chi_ = kernel::Term(data().a.chi);
  model::Modes<Symbolic> modes_ = model::modes_of<Symbolic>(chi_, kernel::Term(2) * omega_, omega2_);
  model::Vector2<Symbolic> rest_ =
      model::modal_rest<Symbolic>(modes_, model::d0<Symbolic>(chi_, kernel::Term(data().a.us)));
  kernel::Substitution values_;
};

// For all epsilon.
kernel::Theorem all_obey() {
  const orbits::Ranges ranges{{epsilon, {-largest_epsilon, largest_epsilon}}};
  const WithMode motion;
  return orbits::for_all_in(
      orbits::in_pieces(epsilon, ranges, [&](const orbits::Ranges& here) { return motion.theorem(here); }),
      {epsilon}, ranges);
}

// At the largest: X(tau) is not -X(0).
kernel::Theorem not_symmetric(const kernel::Theorem& orbits) {
  using kernel::Theorem;
  Theorem here = Theorem::specialize(orbits, largest_epsilon);
  here = tactics::detach(here, tactics::certainly(here.conclusion().parts()[0]));
  return orbits::orbit_with(here, [](const Theorem& orbit) {
    const kernel::Term start = orbits::Names::state(0, 0),
                       end = orbits::Names::state(0, kernel::Variable{"tau"});
    const kernel::Formula opposite = equal(end, -start);
    const Theorem apart = Theorem::consequence({orbit}, orbit.conclusion().parts().back());
    const kernel::Term none = 2 * kernel::Term(largest_epsilon);
    const Theorem level = Theorem::combination(
        equal(none, 0), {{apart, -1}, {Theorem::assume(opposite), kernel::matrix(1, 4, {1, 0, 0, 0})}});
    return Theorem::consequence({Theorem::discharge(level, opposite), tactics::certainly(differ(none, 0))},
                                negation(opposite));
  });
}

Outcome family_of_orbits(Prover&, const Claim&) {
  return proved_by(
      at_the_data("in closed form the motions solve all equations at the ends of both slips, by normal form; "
                  "(25), (26) and the sign of $x2'$ for all times and all $epsilon$, by signs in balls"),
      {"33.even", "33.even.speed", "33.even.start"}, all_obey);
}

Outcome not_always_symmetric(Prover& prover, const Claim&) {
  const WorkingPrecision precision(bits);
  return proved_by(at_the_data("$x_1(tau)$ is not $-x_1(0)$ on the orbit with $epsilon = 1/20$"),
                   {"33.even.orbits", "33.even.places"},
                   [&] { return not_symmetric(prover.theorem("33.even.orbits")); });
}

// ---- The same on a belt that moves, with slips of half a period each: x2' of the first mode, V cos(omega_1
// t), is V at 0, at tau = pi/omega and at Theta. Added to an orbit for a belt at rest it makes one for this
// belt.

// omega_1 = 1/2 and omega_2 = 3/2 are even multiples of omega = 1/4: then (33) and (35) have tan(omega_j
// pi/(2 omega)) = 0 and phi = 0, and all is rational.
const Data of_moving_belt{
    {Rational(5, 8), Rational(12, 5), Rational(1, 10), Rational(1, 10), Rational(1, 4), Rational(3)},
    Rational(3, 25)};
const Rational omega1_there(1, 2), omega2_there(3, 2), lambda1_there(6, 5);

kernel::Theorem orbit_on_moving_belt() {
  const ExactParameters& a = of_moving_belt.a;
  // The amplitudes of both modes in x1: the place of rest is left, and the belt's velocity met.
  const Rational rest1 = 3 * a.us, rest2 = -a.us / 3, mode = a.V / (omega1_there * lambda1_there);
  const orbits::Question question = two_slips(of_moving_belt);
  const kernel::Substitution exactly{{{"omega1"}, omega1_there},
                                     {{"omega2"}, omega2_there},
                                     {{"tau"}, kernel::Term(4) * kernel::pi()},
                                     {{"phi"}, 0},
                                     {{"A1_1"}, Rational(-rest1)},
                                     {{"B1_1"}, mode},
                                     {{"A2_1"}, Rational(-rest2)},
                                     {{"B2_1"}, 0},
                                     {{"A1_2"}, rest1},
                                     {{"B1_2"}, mode},
                                     {{"A2_2"}, rest2},
                                     {{"B2_2"}, 0}};
  const kernel::Theorem nothing_between = kernel::Theorem::reflexive(0);
  const kernel::Theorem orbit =
      orbits::orbit_theorem(question, {exactly, {{{"omega"}, a.omega}}, {}, nothing_between.conclusion()},
                            {equal(kernel::Variable{"tau"}, kernel::Term(4) * kernel::pi())});
  return orbits::one_motion(kernel::Theorem::cut(nothing_between, orbit), question);
}

Outcome only_at_rest_by_halves(Prover&, const Claim&) {
  Outcome outcome;
  outcome.route =
      "a counterexample in closed form, where $omega_1 = 2 omega$: the orbit for a belt at rest, and a free "
      "motion of the first mode with $x2' = V cos(omega_1 t)$, which has the load's period; its speed "
      "against "
      "the belt's by signs in balls, and by mean values at the ends";
  outcome.verdict = differs_at(coordinates(of_moving_belt.a, of_moving_belt.ur), Ball(of_moving_belt.a.V),
                               Ball(0), "the velocity of the belt, $V$,", "what the paper asks for");
  prove(outcome, orbit_on_moving_belt);
  return outcome;
}

// ---- Where a natural frequency is an odd multiple of the load's, no motion of two slips of half a period
// each closes: half a period later the mode is the opposite one, and the friction has moved its place of
// rest.

using kernel::Theorem;
using namespace symbols::vocabulary;

const Term first_row = block(1, {1, 0}), second_row = block(1, {0, 1});
// The two terms of the first of (30) in modal coordinates.
const Term modal_speed = inverse(Lambda) * (zdotB - Q * omega * sin(phi)), modal_rest = inverse(Lambda) * d0;

struct Mode {
  Term frequency, row;
  int sign;  // of its place of rest
};
Term turned(const Mode& mode) {
  return 1 + cos(mode.frequency * tau);
}

// 1 + cos(omega_j tau) = 0 gives 0 < 0: then sin(omega_j tau) = 0, and by 31.modes twice the mode's place of
// rest, which 31.rest gives a sign, is zero.
Theorem absurd(Derivation& derivation, const Mode& mode) {
  const auto read = [&](const Term& term) { return derivation.read(term); };
  const kernel::Term s = read(sin(mode.frequency * tau)), c = read(cos(mode.frequency * tau));
  const Theorem opposite = Theorem::assume(equal(read(turned(mode)), 0));
  const Theorem square = Theorem::combination(equal(s * s, 0), {{opposite, 1 - c}});
  const Theorem level = Theorem::consequence({square, tactics::zero_product(s, s)}, equal(s, 0));
  const Term other = mode.sign > 0 ? omega2 : omega1;
  const Term rest = us / (1 - chi) / (power(omega2, 2) - power(omega1, 2)) * power(other, 2);
  const Rational sign(mode.sign);
  return derivation.order(kernel::less(0, 0), {kernel::Positive{{derivation.positive(read(rest))}, 2}},
                          {{derivation.premise(from("31.modes"), mode.sign > 0 ? 0 : 1), sign},
                           {level, read(-mode.sign / mode.frequency * (mode.row * modal_speed))},
                           {opposite, read(-mode.sign * (mode.row * modal_rest))},
                           {derivation.premise(from("31.rest")), read(2 * mode.sign * mode.row)}});
}

Theorem never_closes(Derivation& derivation, std::size_t) {
  const Mode first{omega1, first_row, 1}, second{omega2, second_row, -1};
  std::vector<Theorem> cases{
      derivation.premise(assuming("31.odd")),
      tactics::zero_product(derivation.read(turned(first)), derivation.read(turned(second)))};
  for (const Mode& mode : {first, second}) {
    cases.push_back(Theorem::discharge(absurd(derivation, mode), equal(derivation.read(turned(mode)), 0)));
  }
  return Theorem::consequence(cases, kernel::less(0, 0));
}

}  // namespace

Proofs resonances() {
  return {{"33.even.orbits", family_of_orbits},
          {"7.exception", not_always_symmetric},
          {"7.only.half", only_at_rest_by_halves},
          {"31.odd", by_kernel("31.modes and 31.rest, in each of both cases", never_closes)}};
}

}  // namespace stickslip::proofs::pascal2012
