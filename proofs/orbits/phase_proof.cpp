#include "proofs/orbits/phase_proof.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// f(s) = V as it is, or -f(s) = -V.
Theorem turned(bool same, const Theorem& equation, const Term& s, const model::Wave<Symbolic>& wave,
               const Term& V) {
  return same ? equation
              : Theorem::combination(
                    equal(value(model::affine<Symbolic>(-1, wave, 0), s), (-Symbolic(V)).term),
                    {{equation, -1}});
}

}  // namespace

Theorem equation(const Phases& phases, std::size_t i) {
  return Theorem::assume(equal(phases.equations().at(i), 0));
}

Theorem as(const Formula& inequality, const Theorem& theorem) {
  return Theorem::order(inequality, {Positive{{theorem}}});
}

std::vector<Multiple> ends_at_ur(const Phases& phases, std::size_t k, int sign) {
  if (!phases.question().ur) {
    return {};
  }
  return {{equation(phases, phases.fitting(k) + 4), sign}};
}

Theorem PhaseProof::meets_belt_at_start() const {
  const std::size_t before = (k_ + phases_.count() - 1) % phases_.count();
  const Formula goal = equal(speed(0), Term(phases_.question().data.V));
  std::vector<Multiple> because{{equation(phases_, phases_.fitting(before) + 3), -1}};
  if (phases_.crossing(before)) {
    because.push_back({equation(phases_, *phases_.crossing(before))});
  }
  return Theorem::combination(goal, because);
}
Theorem PhaseProof::meets_belt_at_end() const {
  const Formula goal = equal(speed(phases_.duration(k_)), Term(phases_.question().data.V));
  return Theorem::combination(
      goal, {{equation(phases_, phases_.crossing(k_) ? *phases_.crossing(k_) : phases_.fitting(k_) + 3)}});
}
Term PhaseProof::speed(const Term& s) const {
  return value(model::derivative(phases_.waves(k_).x2), s);
}

// From a theorem on the time s since the phase began to its form at the time t: with a <= t or a < t for 0
// <= s or 0 < s, and the like for the end.
Theorem PhaseProof::at_time(const Variable& s, const Variable& t, const Theorem& theorem,
                            const Formula& inside) const {
  const Term since = Term(t) - phases_.start(k_);
  const Theorem here = Theorem::assume(inside);
  return settled_by(Theorem::instantiate(theorem, {{s, since}}),
                    [&](const Formula& one) -> std::optional<Theorem> {
                      if (!one.variables().contains(t)) {
                        return std::nullopt;
                      }
                      const auto after = attempt([&] { return as(one, part(here, 0)); });
                      return after ? after : as(one, part(here, 1));
                    });
}

Theorem PhaseProof::obeys(const Variable& t, const Formula& rate) const {
  const Theorem slope = Theorem::differentiate(rate.parts()[0], rate.parts()[1]);
  std::vector<Multiple> because;
  if (phases_.question().phases[k_] != PhaseKind::stick) {
    const Term since = Term(t) - phases_.start(k_);
    for (std::size_t j = 0; j < 2; ++j) {
      const Term share = Term(Rational(1 / phases_.question().data.chi)) * phases_.mode(k_, j, since);
      because.push_back({equation(phases_, j), matrix(4, 1, {0, 0, 0, share})});
    }
    // (7) is known at the value of omega.
    const Rational& omega = phases_.question().data.omega;
    const Term more = -((Term(phases_.omega()) + Term(omega)) * phases_.load(k_, since));
    because.push_back({Theorem::assume(equal(phases_.omega(), omega)),
                       matrix(4, 1, {0, 0, Term(phases_.Q()[0]) * more, Term(phases_.Q()[1]) * more})});
  }
  return tactics::by_rewriting(
      slope, Theorem::combination(equal(slope.conclusion().parts()[2], rate.parts()[2]), because));
}

Theorem PhaseProof::beside_belt(const Variable& t, const Formula& inside, const Formula& goal) const {
  const bool below = phases_.question().phases[k_] == PhaseKind::slip;
  const Variable s{"s"};
  const model::Wave<Symbolic> speed_wave = model::derivative(phases_.waves(k_).x2);
  const Term V = phases_.question().data.V;
  const Symbolic sign = below ? 1 : -1;
  const Below question{model::affine<Symbolic>(sign, speed_wave, 0), (sign * Symbolic(V)).term,
                       phases_.duration(k_), turned(below, meets_belt_at_start(), 0, speed_wave, V),
                       turned(below, meets_belt_at_end(), phases_.duration(k_), speed_wave, V)};
  return as(goal, at_time(s, t, stays_below(question, s, ranges_), inside));
}
Theorem PhaseProof::held(const Variable& t, const Formula& inside, const Formula& goal,
                         bool slips_next) const {
  const Variable s{"s"};
  const model::Wave<Symbolic>& r = phases_.waves(k_).r;
  const auto bounded = [&](int sign) {  // sign r < ur
    const model::Wave<Symbolic> wave = model::affine<Symbolic>(sign, r, 0);
    Below question{wave, ur_, phases_.duration(k_), {}, {}};
    if ((sign > 0) == slips_next) {
      question.meets_at_end =
          Theorem::combination(equal(value(wave, phases_.duration(k_)), ur_), ends_at_ur(phases_, k_, sign));
    }
    return at_time(s, t, stays_below(question, s, ranges_), inside);
  };
  return both({Theorem::combination(goal.parts()[0]), as(goal.parts()[1], bounded(-1)),
               as(goal.parts()[2], bounded(1))});
}

}  // namespace stickslip::proofs::orbits
