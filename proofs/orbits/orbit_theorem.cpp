#include "proofs/orbits/orbit_theorem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proofs/orbits/along.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/with_zero.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// Everything in the unknowns as variables: theorems whose hypotheses are their ranges and that the equations
// hold.
class Orbit {
 public:
  Orbit(const Question& question, const numeric::motion::Motion& nearly) : phases_(question) {
    const std::vector<Rational> centre = phases_.near(nearly);
    const Rational radius(1, 1L << 34);
    for (std::size_t i = 0; i < centre.size(); ++i) {
      box_.emplace_back(centre[i] - radius, centre[i] + radius);
      ranges_.emplace(phases_.unknowns()[i], box_.back());
    }
    const Rational& omega = question.data.omega;
    ranges_.emplace(phases_.omega(), Interval{omega, omega});
  }

  Theorem operator()() {
    // The values of what is said to exist.
    const Question& q = phases_.question();
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      declare({q.durations.at(k)}, phases_.duration(k));
    }
    if (q.lag || !q.phi) {
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
      declare({fmt::format("X{}", k + 1), motion_type},
              lambda(t, phases_.state(k, Term(t) - phases_.start(k))));
    }
    // What is said of them, each with its theorem.
    numbers();
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      phase(k);
      transition(k);
    }
    return with_zero(exists(), phases_.unknowns(), phases_.equations(), box_,
                     {{phases_.omega(), phases_.question().data.omega}});
  }

 private:
  struct Named {
    Variable variable;
    Term value;
  };

  void declare(const Variable& variable, const Term& value) {
    named_.push_back({variable, value});
    values_.emplace(variable, value);
  }
  [[nodiscard]] Term named(const std::string& name) const {
    for (const Named& one : named_) {
      if (one.variable.name == name) {
        return one.variable;
      }
    }
    const Question& q = phases_.question();
    return name == "phi" ? Term(*q.phi) : Term(*q.ur);
  }
  [[nodiscard]] PhaseKind kind(std::size_t k) const { return phases_.question().phases.at(k); }
  [[nodiscard]] std::size_t next(std::size_t k) const { return (k + 1) % phases_.count(); }
  [[nodiscard]] PhaseKind next_kind(std::size_t k) const { return kind(next(k)); }
  // The time at which a phase begins, in what is said.
  [[nodiscard]] Term said_start(std::size_t k) const {
    if (k == phases_.count()) {
      return phases_.period();
    }
    Symbolic sum;
    for (std::size_t i = 0; i < k; ++i) {
      sum += Symbolic(named(phases_.question().durations[i]));
    }
    return sum.term;
  }
  [[nodiscard]] Term data(Rational model::Parameters<Rational>::*member) const {
    return member == &model::Parameters<Rational>::omega ? Term(phases_.omega())
                                                         : Term(phases_.question().data.*member);
  }
  [[nodiscard]] Term said_friction(std::size_t k, const Term& at) const {
    using P = model::Parameters<Rational>;
    return friction()({apply(named(fmt::format("X{}", k + 1)), at), at, data(&P::chi), data(&P::eta),
                       data(&P::omega), data(&P::p), named("phi")});
  }

  void say(const Formula& formula, const Theorem& theorem) {
    said_.push_back(formula);
    proved_.push_back(theorem);
  }
  // A formula in the names, and its form in the unknowns with these definitions looked into.
  void say(const Formula& formula, const Theorem& unfolded, const Definitions& definitions) {
    say(formula, Theorem::convert(unfolded, substitute(formula, values_), definitions));
  }

  // The equation of this number.
  [[nodiscard]] Theorem equation(std::size_t i) const {
    return Theorem::assume(equal(phases_.equations().at(i), 0));
  }
  [[nodiscard]] Theorem sign(const Formula& inequality) const {
    Ranges here;
    for (const auto& [variable, range] : ranges_) {
      if (inequality.variables().contains(variable)) {
        here.emplace(variable, range);
      }
    }
    return Theorem::sign(inequality, here, 96);
  }

  // An inequality of numbers, in the names, by signs in balls.
  void holds(const Formula& inequality) { say(inequality, sign(substitute(inequality, values_))); }
  // What lies between which decimals, in the names.
  void bound(const Term& term) {
    const auto [lower, upper] = decimals(substitute(term, values_));
    holds(less(lower, term));
    holds(less(term, upper));
  }

  // The ranges of the numbers, to nine decimals; that each phase lasts, for one that lasts less than no time
  // would obey anything; what the durations sum up to; 0 < us < ur.
  void numbers() {
    for (const Named& one : named_) {
      if (one.variable.type == real_number) {
        bound(one.variable);
      }
    }
    for (std::size_t k = 0; k < phases_.count(); ++k) {
      for (int i = 0; i < (k > 0 && kind(k) == PhaseKind::stick ? 0 : 3); ++i) {
        bound(entry(apply(named(fmt::format("X{}", k + 1)), said_start(k)), i));
      }
    }
    Symbolic sum;
    for (const std::string& name : phases_.question().durations) {
      holds(less(0, named(name)));
      sum += Symbolic(named(name));
    }
    const Formula whole = equal(sum.term, phases_.period());
    say(whole, Theorem::combination(substitute(whole, values_)));
    if (phases_.question().lag) {
      const Formula lag = equal(named("phi"), substitute(phases_.phi(), {}));
      say(lag, Theorem::reflexive(phases_.phi()));
    }
    const Term us = data(&model::Parameters<Rational>::us);
    holds(less(0, us));
    holds(less(us, named("ur")));
  }

  // Decimals of nine places below and above.
  [[nodiscard]] std::pair<Term, Term> decimals(const Term& term) const {
    mpz_class unit;
    mpz_ui_pow_ui(unit.get_mpz_t(), 10, 9);
    const Interval bounds = enclosure(term, ranges_, Rational(1, unit * 4));
    const auto rounded = [&](const Rational& value, int direction) {
      const Rational scaled = value * unit;
      mpz_class whole;
      mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
      Rational result(whole + (direction > 0 ? 1 : 0), unit);
      result.canonicalize();
      return result;
    };
    return {rounded(bounds.first, -1), rounded(bounds.second, 1)};
  }

  // x2' = V at the beginning and at the end of a phase that slips.
  [[nodiscard]] Theorem meets_belt_at_start(std::size_t k) const {
    const std::size_t before = (k + phases_.count() - 1) % phases_.count();
    const Formula goal = equal(speed(k, 0), data(&model::Parameters<Rational>::V));
    std::vector<Multiple> because{{equation(phases_.fitting(before) + 3), -1}};
    if (phases_.crossing(before)) {
      because.push_back({equation(*phases_.crossing(before))});
    }
    return Theorem::combination(goal, because);
  }
  [[nodiscard]] Theorem meets_belt_at_end(std::size_t k) const {
    const Formula goal = equal(speed(k, phases_.duration(k)), data(&model::Parameters<Rational>::V));
    return Theorem::combination(
        goal, {{equation(phases_.crossing(k) ? *phases_.crossing(k) : phases_.fitting(k) + 3)}});
  }
  [[nodiscard]] Term speed(std::size_t k, const Term& s) const {
    return value(model::derivative(phases_.waves(k).x2), s);
  }

  // From a theorem on the time s since the phase began to its form at the time t: with a <= t or a < t for 0
  // <= s or 0 < s, and the like for the end.
  [[nodiscard]] Theorem at_time(std::size_t k, const Variable& s, const Variable& t, const Theorem& theorem,
                                const Formula& inside) const {
    const Term since = Term(t) - phases_.start(k);
    Theorem result = Theorem::instantiate(theorem, {{s, since}});
    const Theorem here = Theorem::assume(inside);
    const Formulas hypotheses = result.hypotheses();
    for (const Formula& one : hypotheses) {
      if (one.variables().contains(t)) {
        for (std::size_t i : {std::size_t{0}, std::size_t{1}}) {
          try {
            result = Theorem::cut(Theorem::order(one, {Positive{{part(here, i)}}}), result);
            break;
          } catch (const KernelError&) {
            if (i == 1) {
              throw;
            }
          }
        }
      }
    }
    return result;
  }

  // The theorem's inequality in another form of its sides.
  [[nodiscard]] static Theorem as(const Formula& inequality, const Theorem& theorem) {
    return Theorem::order(inequality, {Positive{{theorem}}});
  }

  void phase(std::size_t k) {
    using P = model::Parameters<Rational>;
    const bool stick = kind(k) == PhaseKind::stick;
    const Definition& definition = phase_definition(kind(k));
    std::vector<Term> arguments{named(fmt::format("X{}", k + 1)), said_start(k), said_start(k + 1),
                                data(&P::chi), data(&P::eta)};
    if (!stick) {
      arguments.push_back(data(&P::us));
    }
    arguments.insert(arguments.end(), {data(&P::V), data(&P::omega), data(&P::p), named("phi")});
    if (stick) {
      arguments.push_back(named("ur"));
    }
    const Formula formula = definition(arguments);
    Definitions definitions{definition};
    if (stick) {
      definitions.insert(friction());
    }
    const Formula unfolded = unfold(substitute(formula, values_), definitions);
    const Formula& smooth = unfolded.parts()[0];
    std::vector<Theorem> parts{Theorem::continuity(smooth.parts()[0], smooth.parts()[1], smooth.parts()[2])};
    const Variable t{"t"};
    const Formula open = opened(unfolded.parts()[1], t);
    const Formula &inside = open.parts()[0], &said = open.parts()[1];
    const Theorem moves = obeys(k, t, stick ? said : said.parts()[0]);
    if (stick) {
      parts.push_back(for_every(t, inside, moves));
      const Formula shut = opened(unfolded.parts()[2], t);
      parts.push_back(for_every(t, shut.parts()[0], held(k, t, shut.parts()[0], shut.parts()[1])));
    } else {
      parts.push_back(for_every(t, inside, both({moves, beside_belt(k, t, inside, said.parts()[1])})));
    }
    say(formula, both(parts), definitions);
    const Formula meets =
        equal(entry(apply(named(fmt::format("X{}", k + 1)), said_start(k)), 3), data(&P::V));
    const Formula unnamed = substitute(meets, values_);
    say(meets,
        stick ? Theorem::combination(unnamed) : Theorem::combination(unnamed, {{meets_belt_at_start(k)}}));
  }

  // ⊢ derivative(X, t, …).
  [[nodiscard]] Theorem obeys(std::size_t k, const Variable& t, const Formula& rate) const {
    const Theorem slope = Theorem::differentiate(rate.parts()[0], rate.parts()[1]);
    std::vector<Multiple> because;
    if (kind(k) != PhaseKind::stick) {
      const Term since = Term(t) - phases_.start(k);
      for (std::size_t j = 0; j < 2; ++j) {
        const Term share = Term(Rational(1 / phases_.question().data.chi)) * phases_.mode(k, j, since);
        because.push_back({equation(j), matrix(4, 1, {0, 0, 0, share})});
      }
      // (7) is known at the value of omega.
      const Rational& omega = phases_.question().data.omega;
      const Term more = -((Term(phases_.omega()) + Term(omega)) * phases_.load(k, since));
      because.push_back({Theorem::assume(equal(phases_.omega(), omega)),
                         matrix(4, 1, {0, 0, Term(phases_.Q()[0]) * more, Term(phases_.Q()[1]) * more})});
    }
    return tactics::by_rewriting(
        slope, Theorem::combination(equal(slope.conclusion().parts()[2], rate.parts()[2]), because));
  }

  // x2' < V, V < x2'.
  [[nodiscard]] Theorem beside_belt(std::size_t k, const Variable& t, const Formula& inside,
                                    const Formula& goal) const {
    const bool below = kind(k) == PhaseKind::slip;
    const Variable s{"s"};
    const model::Wave<Symbolic> speed_wave = model::derivative(phases_.waves(k).x2);
    const Term V = data(&model::Parameters<Rational>::V);
    const Symbolic sign = below ? 1 : -1;
    const Below question{model::affine<Symbolic>(sign, speed_wave, 0), (sign * Symbolic(V)).term,
                         phases_.duration(k), turned(below, meets_belt_at_start(k), 0, speed_wave, V),
                         turned(below, meets_belt_at_end(k), phases_.duration(k), speed_wave, V)};
    return as(goal, at_time(k, s, t, stays_below(question, s, ranges_), inside));
  }
  // f(s) = V as it is, or -f(s) = -V.
  [[nodiscard]] static Theorem turned(bool same, const Theorem& equation, const Term& s,
                                      const model::Wave<Symbolic>& wave, const Term& V) {
    return same ? equation
                : Theorem::combination(
                      equal(value(model::affine<Symbolic>(-1, wave, 0), s), (-Symbolic(V)).term),
                      {{equation, -1}});
  }

  // x2' = V, -ur < r, r < ur.
  [[nodiscard]] Theorem held(std::size_t k, const Variable& t, const Formula& inside,
                             const Formula& goal) const {
    const bool slips_next = next_kind(k) == PhaseKind::slip;
    const Variable s{"s"};
    const model::Wave<Symbolic>& r = phases_.waves(k).r;
    const Term ur = phases_.question().ur ? Term(*phases_.question().ur) : values_.at({"ur", real_number});
    const auto bounded = [&](int sign) {  // sign r < ur
      const model::Wave<Symbolic> wave = model::affine<Symbolic>(sign, r, 0);
      Below question{wave, ur, phases_.duration(k), {}, {}};
      if ((sign > 0) == slips_next) {
        const Formula equality = equal(value(wave, phases_.duration(k)), ur);
        std::vector<Multiple> because;
        if (phases_.question().ur) {
          because = {{equation(ends_at_ur(k)), sign}};
        }
        question.meets_at_end = Theorem::combination(equality, because);
      }
      return at_time(k, s, t, stays_below(question, s, ranges_), inside);
    };
    return both({Theorem::combination(goal.parts()[0]), as(goal.parts()[1], bounded(-1)),
                 as(goal.parts()[2], bounded(1))});
  }
  // The equation that r = ur or r = -ur at the end of the stick.
  [[nodiscard]] std::size_t ends_at_ur(std::size_t k) const { return phases_.fitting(k) + 4; }

  // Where phase k ends and the next begins.
  void transition(std::size_t k) {
    const Term end = said_start(k + 1);
    const bool last = k + 1 == phases_.count();
    const Term from = named(fmt::format("X{}", k + 1)), to = named(fmt::format("X{}", next(k) + 1));
    const Formula fits = equal(apply(from, end), apply(to, last ? Term(0) : end));
    std::vector<Multiple> because;
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<Term> unit(4, 0);
      unit[i] = 1;
      because.push_back({equation(phases_.fitting(k) + i), matrix(4, 1, unit)});
    }
    say(fits, Theorem::combination(substitute(fits, values_), because));
    const Term r = said_friction(k, end), ur = named("ur");
    const Term here = value(phases_.waves(k).r, phases_.duration(k)),
               largest =
                   phases_.question().ur ? Term(*phases_.question().ur) : values_.at({"ur", real_number});
    const bool slips_next = next_kind(k) == PhaseKind::slip;
    if (kind(k) == PhaseKind::stick) {
      const Formula leaves = equal(r, slips_next ? ur : -ur);
      std::vector<Multiple> known;
      if (phases_.question().ur) {
        known = {{equation(ends_at_ur(k))}};
      }
      say(leaves, Theorem::combination(unfold(substitute(leaves, values_), {friction()}), known),
          {friction()});
    } else if (next_kind(k) != PhaseKind::stick) {
      const Formula crosses = slips_next ? less(ur, r) : less(r, -ur);
      const Theorem decided = sign(slips_next ? less(largest, here) : less(here, -largest));
      say(crosses, as(unfold(substitute(crosses, values_), {friction()}), decided), {friction()});
    }
  }

  // there are …: all that is said, by the values.
  [[nodiscard]] Theorem exists() const {
    std::vector<Formula> steps{all(said_)};
    for (auto one = named_.rbegin(); one != named_.rend(); ++one) {
      steps.push_back(kernel::exists(one->variable, steps.back()));
    }
    Theorem theorem = both(proved_);
    for (std::size_t bound = 1; bound <= named_.size(); ++bound) {
      const Named& one = named_[named_.size() - bound];
      theorem = Theorem::witness(theorem, substitute(steps[bound], values_), one.value);
    }
    return theorem;
  }

  Phases phases_;
  Box box_;
  Ranges ranges_;
  std::vector<Named> named_;
  Substitution values_;
  std::vector<Formula> said_;
  std::vector<Theorem> proved_;
};

}  // namespace

Theorem orbit_theorem(const Question& question, const numeric::motion::Motion& nearly) {
  return Orbit(question, nearly)();
}

}  // namespace stickslip::proofs::orbits
