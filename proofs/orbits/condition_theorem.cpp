#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;
using numeric::motion::Quantity;
using numeric::motion::Requirement;

namespace {

// What follows from the body of an orbit theorem, by its names. The load's frequency is a letter until the
// end, as in Phases.
class Condition : private Names {
 public:
  explicit Condition(const Question& question) : Names(question), q_(question) {}

  [[nodiscard]] Theorem operator()(const Requirement& requirement, const Theorem& body) const {
    return settled_by(Theorem::instantiate(proved(requirement), {{omega(), q_.data.omega}}),
                      [&](const Formula& one) {
                        return is_divisor(one) ? certainly(one) : Theorem::consequence({body}, one);
                      });
  }

 private:
  [[nodiscard]] Theorem proved(const Requirement& requirement) const {
    const std::size_t k = requirement.phase;
    switch (requirement.quantity) {
      case Quantity::duration:
        return said(less(0, Variable{q_.durations.at(k)}));
      case Quantity::slipping_friction:
        return said(less(0, us()));
      case Quantity::friction_step:
        return said(less(us(), ur()));
      case Quantity::below_belt:
      case Quantity::above_belt:
      case Quantity::below_ur:
      case Quantity::above_minus_ur:
        return requirement.along ? along(requirement.quantity, k) : sticks(requirement.quantity, k);
      case Quantity::falls_behind:
        return falls_behind(k);
      case Quantity::beyond_ur:
        return crosses(k, less(load(k) + eta() * (ur() - us()), spring(k)));
      case Quantity::beyond_minus_ur:
        return crosses(k, less(spring(k), load(k) - eta() * (ur() + us())));
    }
    throw KernelError("a condition without a statement");
  }

  [[nodiscard]] std::size_t count() const { return q_.phases.size(); }
  [[nodiscard]] std::size_t before(std::size_t k) const { return (k + count() - 1) % count(); }
  // p cos(omega t + phi), as phase k begins.
  [[nodiscard]] Term load(std::size_t k) const { return load_at(start(k)); }
  [[nodiscard]] Term load_at(const Term& t) const {
    return (Symbolic(q_.data.p) * cos(Symbolic(omega()) * Symbolic(t) + Symbolic(phi()))).term;
  }
  // chi eta (z2 - z1), as phase k begins.
  [[nodiscard]] Term spring(std::size_t k) const {
    const Rational d1 = q_.data.us / (1 - q_.data.chi), d2 = d1 / q_.data.chi;
    const Term x = state(k, start(k));
    return chi() * eta() * ((entry(x, 1) - d2) - (entry(x, 0) - d1));
  }

  // To be found in the body.
  [[nodiscard]] Theorem said(const Formula& formula) const { return Theorem::assume(formula); }
  // The friction at rest at the end of phase k, as it is said; with its definition looked into.
  [[nodiscard]] Theorem looked_into(const Theorem& theorem) const {
    return Theorem::convert(theorem, unfold(theorem.conclusion(), {friction()}), {friction()});
  }
  [[nodiscard]] Term friction_after(std::size_t k) const { return friction_at(k, end(k)); }
  // The state in which phase k begins is the one in which the phase before ends: as a multiple of entry i.
  [[nodiscard]] Multiple carried(std::size_t k, std::size_t i, const Term& factor) const {
    std::vector<Term> row(4, 0);
    row[i] = factor;
    return {said(equal(state(before(k), end(before(k))), state(k, start(k)))), matrix(1, 4, row)};
  }
  [[nodiscard]] Theorem with_belt(std::size_t k) const {
    return said(equal(entry(state(k, start(k)), 3), q_.data.V));
  }

  // What a phase of this kind is, looked into.
  [[nodiscard]] Theorem phase(std::size_t k) const {
    const Formula formula = Names::phase(k);
    const Definitions opened = definitions(k);
    return Theorem::convert(said(formula), unfold(formula, opened), opened);
  }
  // -ur < r and r < ur at a time of the stick.
  [[nodiscard]] Theorem bounded(std::size_t k, const Term& t, const Theorem& since, const Theorem& until,
                                bool above) const {
    if (q_.phases.at(k) != PhaseKind::stick) {
      throw KernelError("the friction at rest is bounded in a stick only");
    }
    return part(at(part(phase(k), 2), t, both({since, until})), above ? 2 : 1);
  }

  // At all times between the phase's ends.
  [[nodiscard]] Theorem along(Quantity quantity, std::size_t k) const {
    const Variable t{"t"};
    const Formula during = between(start(k), t, end(k));
    const Theorem here = Theorem::assume(during);
    if (quantity == Quantity::below_belt || quantity == Quantity::above_belt) {
      const Term speed = entry(state(k, t), 3), V = q_.data.V;
      const Formula side = quantity == Quantity::below_belt ? less(speed, V) : less(V, speed);
      return for_every(t, during, Theorem::consequence({at(part(phase(k), 1), t, here)}, side));
    }
    const bool above = quantity == Quantity::below_ur;
    const Theorem since = Theorem::order(at_most(start(k), t), {Positive{{part(here, 0)}}});
    const Term x = state(k, t);
    const Term force = chi() * eta() * (entry(x, 1) - entry(x, 0)) - load_at(t);
    const Term bound = eta() * ur();
    return for_every(t, during,
                     Theorem::order(above ? less(force, bound) : less(-bound, force),
                                    {Positive{{bounded(k, t, since, part(here, 1), above)}, q_.data.eta}}));
  }
  // (14), (19).
  [[nodiscard]] Theorem sticks(Quantity quantity, std::size_t k) const {
    const bool above = quantity == Quantity::below_ur;
    const Theorem since = Theorem::order(at_most(start(k), start(k)), {});
    Theorem lasts = said(less(0, Variable{q_.durations.at(k)}));
    std::vector<Multiple> because;
    if (k + 1 == count()) {
      because = {{period_is_sum(), -1}};
    }
    lasts = Theorem::order(less(start(k), end(k)), {Positive{{lasts}}}, because);
    const Term middle = spring(k) - load(k);
    return Theorem::order(
        above ? less(middle, eta() * (ur() - us())) : less(-(eta() * (ur() + us())), middle),
        {Positive{{bounded(k, start(k), since, lasts, above)}, q_.data.eta}});
  }
  [[nodiscard]] Theorem period_is_sum() const { return said(equal(start(count()), end(count() - 1))); }
  // (12).
  [[nodiscard]] Theorem falls_behind(std::size_t k) const {
    const Theorem leaves = looked_into(said(equal(friction_after(before(k)), ur())));
    const Term ce = chi() * eta();
    const Theorem balance = Theorem::combination(equal(spring(k), load(k) + eta() * (ur() - us())),
                                                 {{leaves, eta()}, carried(k, 0, ce), carried(k, 1, -ce)});
    // x2'' = eta us - chi eta (x2 - x1) + p cos(omega t + phi), by (2).
    const Term x = state(k, start(k));
    const Term acceleration = eta() * us() - ce * (entry(x, 1) - entry(x, 0)) + load(k);
    const Theorem falls =
        Theorem::order(less(acceleration, 0), {Positive{{said(less(us(), ur()))}, q_.data.eta}}, {{balance}});
    return both({with_belt(k), balance, falls});
  }
  // (18), (25), (26).
  [[nodiscard]] Theorem crosses(std::size_t k, const Formula& goal) const {
    const Term r = friction_after(before(k));
    const bool below = q_.phases.at(k) == PhaseKind::slip;
    const Theorem known = looked_into(said(below ? less(ur(), r) : less(r, -ur())));
    const Term ce = chi() * eta(), sign = below ? Term(1) : Term(-1);
    return both({with_belt(k), Theorem::order(goal, {Positive{{known}, q_.data.eta}},
                                              {carried(k, 0, sign * ce), carried(k, 1, -(sign * ce))})});
  }

  const Question& q_;
};

// In what the orbit theorem bounds.
Term named_value(const Question& question, const std::string& name) {
  const model::Parameters<Rational>& a = question.data;
  if (name == "Theta") {
    return Term(2 * question.period) * pi() / Term(a.omega);
  }
  const Term start = apply(Variable{"X1", motion_type}, 0);
  if (name == "ur_max") {
    const Term phi = question.phi ? Term(*question.phi) : Term(Variable{"phi"});
    return friction()({start, 0, a.chi, a.eta, a.omega, a.p, phi});
  }
  static const std::vector<std::string> entries{"10", "20", "dot10"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (name.substr(1) == entries[i]) {
      const Rational d01 = a.us / (1 - a.chi);
      const Term place = entry(start, static_cast<int>(i));
      return name[0] != 'z' || i == 2 ? place : place - Term(i == 0 ? d01 : Rational(d01 / a.chi));
    }
  }
  return Variable{name, real_number};
}

// Decided by these bounds.
Theorem decided(const Formula& inequality, const Theorem& orbit) {
  const Formula opened = unfold(inequality, {friction()});
  Formula here = opened;
  Letters letters;
  for (const auto& [term, known] : bounds_said(parts_of(orbit))) {
    const Variable letter{"value " + std::to_string(letters.size())};
    letters.emplace(letter, known);
    here = replaced(here, term, letter);
  }
  return Theorem::convert(settled(sign(here, ranges_of(letters)), letters), inequality, {friction()});
}

}  // namespace

Theorem condition_theorem(const Theorem& orbit, const Question& question, const Requirement& requirement) {
  return orbit_with(orbit, [&](const Theorem& body) { return Condition(question)(requirement, body); });
}

Theorem value_theorem(const Theorem& orbit, const Question& question, const std::string& name,
                      const Rational& lower, const Rational& upper, bool outside) {
  const Term value = named_value(question, name);
  return orbit_with(orbit, [&](const Theorem& body) {
    if (!outside) {
      return both({decided(at_most(lower, value), body), decided(at_most(value, upper), body)});
    }
    const auto above = attempt([&] { return decided(less(upper, value), body); });
    return above ? *above : decided(less(value, lower), body);
  });
}

}  // namespace stickslip::proofs::orbits
