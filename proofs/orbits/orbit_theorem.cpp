#include "proofs/orbits/orbit_theorem.hpp"

#include <algorithm>

#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/tactics/closed.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// The equation of this number, assumed.
Theorem equation(const Phases& phases, std::size_t i) {
  return Theorem::assume(equal(phases.equations().at(i), 0));
}

// The theorem's inequality in another form of its sides.
Theorem as(const Formula& inequality, const Theorem& theorem) {
  return Theorem::order(inequality, {Positive{{theorem}}});
}

// That the wave is the bound at the end of a stick, the friction r or -r and ur: by the equation that says so
// where ur is given.
std::vector<Multiple> ends_at_ur(const Phases& phases, std::size_t k, int sign) {
  if (!phases.question().ur) {
    return {};
  }
  return {{equation(phases, phases.fitting(k) + 4), sign}};
}

// f(s) = V as it is, or -f(s) = -V.
Theorem turned(bool same, const Theorem& equation, const Term& s, const model::Wave<Symbolic>& wave,
               const Term& V) {
  return same ? equation
              : Theorem::combination(
                    equal(value(model::affine<Symbolic>(-1, wave, 0), s), (-Symbolic(V)).term),
                    {{equation, -1}});
}

// What is true of one phase in closed form. The theorems' hypotheses are that equations of Phases hold, and
// the ranges of the unknowns.
class PhaseProof {
 public:
  // Refers to phases and ranges. ur is its value in the unknowns.
  PhaseProof(const Phases& phases, const Ranges& ranges, std::size_t k, const Term& ur)
      : phases_(phases), ranges_(ranges), k_(k), ur_(ur) {}

  // x2' = V at the beginning of a phase that slips.
  [[nodiscard]] Theorem meets_belt_at_start() const {
    const std::size_t before = (k_ + phases_.count() - 1) % phases_.count();
    const Formula goal = equal(speed(0), Term(phases_.question().data.V));
    std::vector<Multiple> because{{equation(phases_, phases_.fitting(before) + 3), -1}};
    if (phases_.crossing(before)) {
      because.push_back({equation(phases_, *phases_.crossing(before))});
    }
    return Theorem::combination(goal, because);
  }

  // ⊢ the derivative at t, by (2) or (9).
  [[nodiscard]] Theorem obeys(const Variable& t, const Formula& rate) const {
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

  // x2' < V or V < x2' inside.
  [[nodiscard]] Theorem beside_belt(const Variable& t, const Formula& inside, const Formula& goal) const {
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

  // x2' = V, -ur < r, r < ur inside; which of these r reaches at the end.
  [[nodiscard]] Theorem held(const Variable& t, const Formula& inside, const Formula& goal,
                             bool slips_next) const {
    const Variable s{"s"};
    const model::Wave<Symbolic>& r = phases_.waves(k_).r;
    const auto bounded = [&](int sign) {  // sign r < ur
      const model::Wave<Symbolic> wave = model::affine<Symbolic>(sign, r, 0);
      Below question{wave, ur_, phases_.duration(k_), {}, {}};
      if ((sign > 0) == slips_next) {
        question.meets_at_end = Theorem::combination(equal(value(wave, phases_.duration(k_)), ur_),
                                                     ends_at_ur(phases_, k_, sign));
      }
      return at_time(s, t, stays_below(question, s, ranges_), inside);
    };
    return both({Theorem::combination(goal.parts()[0]), as(goal.parts()[1], bounded(-1)),
                 as(goal.parts()[2], bounded(1))});
  }

 private:
  [[nodiscard]] Theorem meets_belt_at_end() const {
    const Formula goal = equal(speed(phases_.duration(k_)), Term(phases_.question().data.V));
    return Theorem::combination(
        goal, {{equation(phases_, phases_.crossing(k_) ? *phases_.crossing(k_) : phases_.fitting(k_) + 3)}});
  }
  [[nodiscard]] Term speed(const Term& s) const { return value(model::derivative(phases_.waves(k_).x2), s); }

  // From a theorem on the time s since the phase began to its form at the time t: with a <= t or a < t for 0
  // <= s or 0 < s, and the like for the end.
  [[nodiscard]] Theorem at_time(const Variable& s, const Variable& t, const Theorem& theorem,
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

  const Phases& phases_;
  const Ranges& ranges_;
  std::size_t k_;
  Term ur_;
};

// Everything in the unknowns as variables: theorems whose hypotheses are their ranges and that the equations
// hold.
class Orbit {
 public:
  Orbit(const Question& question, const numeric::motion::Motion& nearly)
      : phases_(question), names_(phases_.question()) {
    const std::vector<Rational> centre = phases_.near(nearly);
    const Rational radius(1, 1L << 34);
    for (std::size_t i = 0; i < centre.size(); ++i) {
      box_.emplace_back(centre[i] - radius, centre[i] + radius);
      ranges_.emplace(phases_.unknowns()[i], box_.back());
    }
    know_omega();
  }
  Orbit(const Question& question, const ClosedForm& known)
      : phases_(question), names_(phases_.question()), known_(known) {
    for (const Variable& unknown : phases_.unknowns()) {
      ranges_.emplace(unknown, enclosure(substitute(substitute(unknown, known.values), known.numbers),
                                         known.parameters, Rational(1, 1L << 34)));
    }
    know_omega();
  }

  Theorem operator()() {
    say_all();
    return with_zero(exists(), phases_.unknowns(), phases_.equations(), box_, at_value());
  }
  Theorem in_closed_form(const std::vector<Formula>& also) {
    say_all();
    for (const Formula& equation : also) {
      say(equation, Theorem::assume(substitute(equation, values_)));
    }
    Theorem result = solved(Theorem::instantiate(exists(), known_->values), known_->between);
    result =
        solved(Theorem::instantiate(result, known_->numbers), substitute(known_->between, known_->numbers));
    return settled_by(result, [&](const Formula& one) -> std::optional<Theorem> {
      if (one.variables().empty()) {
        return certainly(one);
      }
      if (one.kind() == Kind::at_most && !is_range(one, known_->parameters)) {
        return orbits::sign(one, known_->parameters);
      }
      if (one.kind() == Kind::equal && one != substitute(known_->between, known_->numbers)) {
        throw KernelError("the closed form does not solve " + to_string(one));
      }
      return std::nullopt;
    });
  }
  [[nodiscard]] Theorem unique() const {
    return exactly_one_zero(phases_.unknowns(), phases_.equations(), box_, at_value());
  }

 private:
  void know_omega() {
    const Rational& omega = phases_.question().data.omega;
    ranges_.emplace(phases_.omega(), Interval{omega, omega});
  }
  // The theorem less its equations, as far as they hold identically or by the one between the parameters.
  [[nodiscard]] static Theorem solved(const Theorem& theorem, const Formula& between) {
    return settled_by(theorem, [&](const Formula& one) -> std::optional<Theorem> {
      for (const int factor : {0, 1, -1}) {
        if (one.kind() != Kind::equal || one == between) {
          break;
        }
        const std::vector<Multiple> because(factor == 0 ? 0 : 1, {Theorem::assume(between), factor});
        if (const auto holds = attempt([&] { return Theorem::combination(one, because); })) {
          return holds;
        }
      }
      return std::nullopt;
    });
  }

  void say_all() {
    // The values of what is said to exist.
    const Question& q = phases_.question();
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      declare({q.durations.at(k)}, phases_.duration(k));
    }
    if (names_.phi().kind() == Kind::variable) {
      declare({"phi"}, phases_.phi());
    }
    if (!q.ur) {
      const auto stick = std::ranges::find(q.phases, PhaseKind::stick);
      if (stick == q.phases.end()) {
        throw KernelError("of an orbit that never sticks ur is a datum");
      }
      const auto k = static_cast<std::size_t>(stick - q.phases.begin());
      const Term r = value(phases_.waves(k).r, phases_.duration(k));
      declare({"ur"}, next_kind(k) == PhaseKind::slip ? r : -r);
    }
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      const Variable t{"t"};
      declare(Names::motion(k), lambda(t, phases_.state(k, Term(t) - phases_.start(k))));
    }
    // What is said of them, each with its theorem.
    numbers();
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      phase(k);
      transition(k);
    }
  }

  [[nodiscard]] Substitution at_value() const { return {{phases_.omega(), phases_.question().data.omega}}; }
  void declare(const Variable& variable, const Term& value) {
    named_.push_back(variable);
    values_.emplace(variable, value);
  }
  [[nodiscard]] PhaseKind kind(std::size_t k) const { return phases_.question().phases.at(k); }
  [[nodiscard]] std::size_t next(std::size_t k) const { return (k + 1) % phases_.count(); }
  [[nodiscard]] PhaseKind next_kind(std::size_t k) const { return kind(next(k)); }

  void say(const Formula& formula, const Theorem& theorem) {
    said_.push_back(formula);
    proved_.push_back(theorem);
  }
  // A formula in the names, and its form in the unknowns with these definitions looked into.
  void say(const Formula& formula, const Theorem& unfolded, const Definitions& definitions) {
    say(formula, Theorem::convert(unfolded, substitute(formula, values_), definitions));
  }

  [[nodiscard]] Theorem sign(const Formula& inequality) const {
    return orbits::sign(inequality, ranges_, matrix_bits);
  }

  // An inequality of numbers, in the names, by signs in balls.
  void holds(const Formula& inequality) { say(inequality, sign(substitute(inequality, values_))); }
  // What lies between which decimals, in the names.
  void bound(const Term& term) {
    if (known_) {
      return;
    }
    const auto [lower, upper] = decimals(substitute(term, values_));
    holds(less(lower, term));
    holds(less(term, upper));
  }

  // The ranges of the numbers, to nine decimals; that each phase lasts, for one that lasts less than no time
  // would obey anything; what the durations sum up to; 0 < us < ur.
  void numbers() {
    for (const Variable& variable : named_) {
      if (variable.type == real_number) {
        bound(variable);
      }
    }
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      for (int i = 0; i < (k > 0 && kind(k) == PhaseKind::stick ? 0 : 3); ++i) {
        bound(entry(Names::state(k, names_.start(k)), i));
      }
    }
    for (const std::string& name : phases_.question().durations) {
      holds(less(0, Variable{name}));
    }
    const Formula whole = equal(names_.start(phases_.count()), phases_.period());
    say(whole, Theorem::combination(substitute(whole, values_)));
    if (phases_.question().lag) {
      const Formula lag = equal(names_.phi(), substitute(phases_.phi(), {}));
      say(lag, Theorem::reflexive(phases_.phi()));
    }
    holds(less(0, names_.us()));
    holds(less(names_.us(), names_.ur()));
  }

  // Decimals of nine places below and above.
  [[nodiscard]] std::pair<Term, Term> decimals(const Term& term) const {
    constexpr long unit = 1000000000;
    const Interval bounds = enclosure(term, ranges_, Rational(1, unit * 4));
    return {rounded_down(bounds.first, unit),
            Rational(rounded_down(bounds.second, unit) + Rational(1, unit))};
  }

  void phase(std::size_t k) {
    const bool stick = kind(k) == PhaseKind::stick, slips_next = next_kind(k) == PhaseKind::slip;
    const Formula formula = names_.phase(k);
    const Definitions definitions = names_.definitions(k);
    const Formula unfolded = unfold(substitute(formula, values_), definitions);
    const Formula& smooth = unfolded.parts()[0];
    std::vector<Theorem> parts{Theorem::continuity(smooth.parts()[0], smooth.parts()[1], smooth.parts()[2])};
    const Variable t{"t"};
    const Formula open = opened(unfolded.parts()[1], t);
    const Formula &inside = open.parts()[0], &said = open.parts()[1];
    const PhaseProof proof(phases_, ranges_, k, substitute(names_.ur(), values_));
    const Theorem moves = proof.obeys(t, stick ? said : said.parts()[0]);
    if (stick) {
      parts.push_back(for_every(t, inside, moves));
      const Formula shut = opened(unfolded.parts()[2], t);
      parts.push_back(
          for_every(t, shut.parts()[0], proof.held(t, shut.parts()[0], shut.parts()[1], slips_next)));
    } else {
      parts.push_back(for_every(t, inside, both({moves, proof.beside_belt(t, inside, said.parts()[1])})));
    }
    say(formula, both(parts), definitions);
    const Formula meets = equal(entry(Names::state(k, names_.start(k)), 3), names_.V());
    std::vector<Multiple> because;
    if (!stick) {
      because.push_back({proof.meets_belt_at_start()});
    }
    say(meets, Theorem::combination(substitute(meets, values_), because));
  }

  // Where phase k ends and the next begins.
  void transition(std::size_t k) {
    const Term end = names_.end(k);
    const bool last = k + 1 == phases_.count();
    const Formula fits = equal(Names::state(k, end), Names::state(next(k), last ? Term(0) : end));
    std::vector<Multiple> because;
    for (std::size_t i = 0; i < 4; ++i) {
      because.push_back({equation(phases_, phases_.fitting(k) + i), unit(4, 1, i)});
    }
    say(fits, Theorem::combination(substitute(fits, values_), because));
    const Term r = names_.friction_at(k, end), ur = names_.ur();
    const Term here = value(phases_.waves(k).r, phases_.duration(k)), largest = substitute(ur, values_);
    const bool slips_next = next_kind(k) == PhaseKind::slip;
    if (kind(k) == PhaseKind::stick) {
      const Formula leaves = equal(r, slips_next ? ur : -ur);
      say(leaves,
          Theorem::combination(unfold(substitute(leaves, values_), {friction()}), ends_at_ur(phases_, k, 1)),
          {friction()});
    } else if (next_kind(k) != PhaseKind::stick) {
      const Formula crosses = slips_next ? less(ur, r) : less(r, -ur);
      const Theorem decided = sign(slips_next ? less(largest, here) : less(here, -largest));
      say(crosses, as(unfold(substitute(crosses, values_), {friction()}), decided), {friction()});
    }
  }

  // there are …: all that is said, by the values.
  [[nodiscard]] Theorem exists() const {
    return tactics::there_are(named_, all(said_), values_, both(proved_));
  }

  Phases phases_;
  Names names_;  // of the question that phases_ keeps
  std::optional<ClosedForm> known_ = {};
  Box box_;
  Ranges ranges_;
  std::vector<Variable> named_;
  Substitution values_;
  std::vector<Formula> said_;
  std::vector<Theorem> proved_;
};

}  // namespace

Theorem orbit_theorem(const Question& question, const numeric::motion::Motion& nearly) {
  return Orbit(question, nearly)();
}

Theorem orbit_theorem(const Question& question, const ClosedForm& known, const std::vector<Formula>& also) {
  return Orbit(question, known).in_closed_form(also);
}

Theorem locally_unique(const Question& question, const numeric::motion::Motion& nearly) {
  return Orbit(question, nearly).unique();
}

}  // namespace stickslip::proofs::orbits
