// Stability: the multipliers of the return map, from what an orbit's theorem says of its states and times.
//
// The solutions of the equations of variation are in closed form in omega1, omega2 of (39) and in 1/omega1,
// 1/omega2 and 1/(lambda2 - lambda1), which are letters of a system of their own. Then matrices are enclosed
// entry by entry: of each phase with the event after it, of their products, and the characteristic
// polynomial's coefficients (enclosed_matrix.hpp). So no term grows with the number of phases.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "proofs/orbits/all_zeros.hpp"
#include "proofs/orbits/along.hpp"
#include "proofs/orbits/definitions.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/orbits/orbit_theorem.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

// enclosed(M) ⊢ the zeros of M's characteristic polynomial lie inside the unit circle, or one of them is real
// and larger than 1.
Theorem judged(const Variable& M, const std::vector<Interval>& bounds) {
  const Letters entries = entries_of(M, bounds);
  const Ranges ranges = ranges_of(entries);
  const std::vector<Term> coefficients = characteristic().unfolded({M}).parts();
  std::vector<Term> letters;
  Letters values;
  for (std::size_t i = 0; i + 1 < coefficients.size(); ++i) {
    Term lettered = coefficients[i];
    for (const auto& [name, known] : entries) {
      lettered = replaced(lettered, known.value, name);
    }
    Known one = bounded(lettered, ranges);
    one = {coefficients[i], one.range, settled(one.lower, entries), settled(one.upper, entries)};
    const Variable c{fmt::format("c{}", i)};
    letters.emplace_back(c);
    values.emplace(c, one);
  }
  letters.emplace_back(1);
  const Term column = matrix(matrix_rows + 1, 1, letters);
  const Ranges here = ranges_of(values);
  const auto finished = [&](const Theorem& theorem, const Formula& said, const Definitions& opened) {
    return Theorem::convert(settled(theorem, values), said, opened);
  };
  try {
    return finished(Theorem::jury(column, here, matrix_bits), inside_unit_circle(characteristic()({M})),
                    {characteristic()});
  } catch (const KernelError&) {
    const Variable mu{"mu"};
    const Term f = lambda(mu, polynomial_at().unfolded({column, mu}));
    Rational end = 2;
    const auto is = [&](const Formula& relation) { return Theorem::sign(relation, here, matrix_bits); };
    const Theorem start = is(less(apply(f, 1), 0));
    while (end < 1 << 20) {
      try {
        const Theorem there = Theorem::intermediate_value(
            Theorem::continuity(f, 1, end), start, is(less(0, apply(f, end))), Theorem::sign(less(1, end)));
        const Formula found = opened(there.conclusion(), mu);
        const Formula claim = all({less(1, mu), equal(polynomial_at()({characteristic()({M}), mu}), 0)});
        const Formula shown = unfold(claim, {characteristic(), polynomial_at()});
        Theorem result = settled(Theorem::assume(found), values);
        result = Theorem::consequence({result}, shown);
        result = Theorem::convert(result, claim, {characteristic(), polynomial_at()});
        return Theorem::choose(settled(there, values), mu, tactics::there_are({mu}, result));
      } catch (const KernelError&) {
        end *= 2;
      }
    }
    throw;
  }
}

class Multipliers {
 public:
  Multipliers(const Question& question, const Theorem& body)
      : q_(question), body_(body), said_(bounds_said(parts_of(body))), names_(question), phases_(question) {
    for (std::size_t k = 0; k < count(); ++k) {
      require_phase(k);
    }
    add_frequencies();
    for (const std::string& name : q_.durations) {
      add_known(Variable{name}, Variable{name});
    }
    if (names_.phi().kind() == Kind::variable) {
      add_known(Variable{"phi"}, names_.phi());
    }
  }

  Theorem operator()() {
    std::vector<Matrix> steps;
    std::vector<Formula> said;
    std::vector<Theorem> proved;
    Term named = 0;
    std::vector<Variable> names;
    Substitution values;
    for (std::size_t k = 0; k < count(); ++k) {
      const Variable Y{fmt::format("Y{}", k + 1), variation_type}, d{q_.durations.at(k)};
      const Term flow = flow_of(k);
      names.push_back(Y);
      values.emplace(Y, flow);
      said.push_back(varies(k, Y));
      proved.push_back(varies_proved(k, flow));
      const Event event = event_after(k);
      steps.push_back(stepped(event, apply(flow, d)));
      const Term step = event.matrix() * apply(Y, d);
      named = k == 0 ? step : step * named;
    }
    Matrix M = steps[0];
    for (std::size_t k = 1; k < count(); ++k) {
      M = product(steps[k], M);
    }
    const Variable name{"M", real_matrix(matrix_rows, matrix_rows)};
    const Theorem verdict = judged(name, M.bounds);
    names.push_back(name);
    values.emplace(name, M.value);
    said.insert(said.end(), {equal(name, named), verdict.conclusion()});
    proved.insert(proved.end(), {Theorem::reflexive(M.value),
                                 Theorem::cut(M.known, Theorem::instantiate(verdict, {{name, M.value}}))});
    return with_zero(settled(tactics::there_are(names, all(said), values, both(proved)), known_), letters_,
                     system_, box_);
  }

 private:
  [[nodiscard]] std::size_t count() const { return q_.phases.size(); }
  [[nodiscard]] bool sticks(std::size_t k) const { return q_.phases.at(k) == PhaseKind::stick; }

  // The orbit's theorem says that phase k is of this kind, of this oscillator.
  void require_phase(std::size_t k) const {
    const model::Parameters<Rational>& a = q_.data;
    std::vector<Term> data{a.chi, a.eta};
    if (!sticks(k)) {
      data.emplace_back(a.us);
    }
    data.insert(data.end(), {a.V, a.omega, a.p});
    for (const Formula& one : body_.conclusion().parts()) {
      if (one.kind() == Kind::defined && one.definition() == phase_definition(q_.phases[k]) &&
          one.parts()[0] == Term(Names::motion(k)) &&
          std::equal(data.begin(), data.end(), one.parts().begin() + 3)) {
        return;
      }
    }
    throw KernelError(fmt::format("the orbit's theorem says something else of phase {}", k + 1));
  }

  Variable unknown(const std::string& name, long double nearly) {
    const Rational middle(static_cast<long>(std::llround(std::ldexp(nearly, 48))), 1L << 48);
    const Rational radius(1, 1L << 34);
    letters_.push_back({name, real_number});
    box_.emplace_back(middle - radius, middle + radius);
    ranges_.emplace(letters_.back(), box_.back());
    return letters_.back();
  }

  void add_frequencies() {
    const long double chi = q_.data.chi.get_d(), eta = q_.data.eta.get_d();
    const long double b = 1 + chi * eta, root = std::sqrt(b * b - 4 * chi * eta * (1 - chi));
    const std::array<long double, 2> w{std::sqrt((b - root) / 2), std::sqrt((b + root) / 2)};
    for (std::size_t j = 0; j < 2; ++j) {
      omega_.emplace_back(unknown(fmt::format("omega{}", j + 1), w.at(j)));
      system_.push_back(phases_.characteristic(j));
    }
    for (std::size_t j = 0; j < 2; ++j) {
      over_omega_.emplace_back(unknown(fmt::format("over_omega{}", j + 1), 1 / w.at(j)));
      system_.push_back((omega_[j] * over_omega_[j] - 1).term);
      lambda_.push_back(Symbolic(Term(Rational(1 / q_.data.chi))) * (1 - omega_[j] * omega_[j]));
    }
    over_difference_ = unknown("over_difference", chi / (w[0] * w[0] - w[1] * w[1]));
    system_.push_back((over_difference_ * (lambda_[1] - lambda_[0]) - 1).term);
  }

  // What the orbit's theorem bounds.
  void add_known(const Variable& letter, const Term& value) {
    const auto said = said_.find(value);
    if (said == said_.end()) {
      throw KernelError("the orbit's theorem has no bounds of " + to_string(value));
    }
    known_.emplace(letter, said->second);
    ranges_.emplace(letter, said->second.range);
  }

  // ---- The equations of variation.
  [[nodiscard]] Formula varies(std::size_t k, const Term& Y) const {
    std::vector<Term> arguments{Y, Variable{q_.durations.at(k)}, q_.data.chi};
    if (!sticks(k)) {
      arguments.emplace_back(q_.data.eta);
    }
    return variation(q_.phases.at(k))(arguments);
  }

  // Of the mode j, by which row of the state at the beginning x1 is given.
  [[nodiscard]] std::array<Symbolic, matrix_rows> mode(std::size_t j, const Symbolic& c,
                                                       const Symbolic& s) const {
    const Symbolic other = lambda_[1 - j], sign = j == 0 ? 1 : -1;
    const Symbolic g = over_difference_;
    return {g * sign * other * c, -(g * sign * c), g * sign * other * s * over_omega_[j],
            -(g * sign * s * over_omega_[j])};
  }

  // A solution that begins with I, as a function of the time since the phase began.
  [[nodiscard]] Term flow_of(std::size_t k) const {
    const Variable t{"t"};
    if (sticks(k)) {
      return lambda(t, as_term(model::Gamma<Symbolic>(Term(q_.data.chi), Symbolic(t))));
    }
    model::Matrix4<Symbolic> entries;
    for (std::size_t j = 0; j < 2; ++j) {
      const Symbolic angle = omega_[j] * Symbolic(t), c = cos(angle), s = sin(angle);
      const auto x = mode(j, c, s), v = mode(j, -(omega_[j] * s), omega_[j] * c);
      for (int i = 0; i < matrix_rows; ++i) {
        const Symbolic &place = x.at(static_cast<std::size_t>(i)), &speed = v.at(static_cast<std::size_t>(i));
        entries.col(i) += model::Vector4<Symbolic>{place, lambda_[j] * place, speed, lambda_[j] * speed};
      }
    }
    return lambda(t, as_term(entries));
  }

  [[nodiscard]] Theorem vanishes(std::size_t i) const { return Theorem::assume(equal(system_.at(i), 0)); }

  [[nodiscard]] Theorem varies_proved(std::size_t k, const Term& flow) const {
    const Definitions opened_definitions{variation(q_.phases.at(k))};
    const Formula said = varies(k, flow), whole = unfold(said, opened_definitions);
    const Formula& smooth = whole.parts()[0];
    const Variable t{"t"};
    const Formula open = opened(whole.parts()[1], t);
    const Theorem slope = Theorem::differentiate(flow, t);
    std::vector<Multiple> moves, begins;
    if (!sticks(k)) {
      for (std::size_t j = 0; j < 2; ++j) {
        const Symbolic angle = omega_[j] * Symbolic(t);
        std::vector<Term> share(matrix_rows * matrix_rows, 0), start(matrix_rows * matrix_rows, 0);
        const auto x = mode(j, cos(angle), sin(angle));
        const Symbolic over_chi(Term(Rational(1 / q_.data.chi)));
        // omega_j over_omega_j - 1 stands where x' is 1 at the start.
        const Symbolic sign = j == 0 ? 1 : -1, g = over_difference_ * sign, other = lambda_[1 - j];
        for (std::size_t i = 0; i < matrix_rows; ++i) {
          share[12 + i] = (over_chi * x[i]).term;
        }
        start[10] = (g * other).term;
        start[11] = (-g).term;
        start[14] = (g * other * lambda_[j]).term;
        start[15] = (-(g * lambda_[j])).term;
        moves.push_back({vanishes(j), matrix(matrix_rows, matrix_rows, share)});
        begins.push_back({vanishes(2 + j), matrix(matrix_rows, matrix_rows, start)});
      }
      begins.push_back({vanishes(4), identity(matrix_rows)});
    }
    const Theorem rate = by_rewriting(
        slope, Theorem::combination(equal(slope.conclusion().parts()[2], open.parts()[1].parts()[2]), moves));
    return Theorem::convert(
        both({Theorem::continuity(flow, smooth.parts()[1], smooth.parts()[2]),
              for_every(t, open.parts()[0], rate), Theorem::combination(whole.parts()[2], begins)}),
        said, opened_definitions);
  }

  // ---- Events.
  struct Event {
    Definition definition;
    std::vector<Term> arguments;  // numbers, and letters
    Letters letters;              // what they stand for

    [[nodiscard]] Term matrix() const {
      Substitution values;
      for (const auto& [letter, known] : letters) {
        values.emplace(letter, known.value);
      }
      return substitute(definition(arguments), values);
    }
  };
  [[nodiscard]] Event event_after(std::size_t k) const {
    const std::size_t next = (k + 1) % count();
    if (sticks(next)) {
      return {landing(), {}, {}};
    }
    const Term start = names_.start(next), X = Names::state(next, start);
    const std::vector<Term> here{X, start, q_.data.chi, q_.data.eta, q_.data.omega, q_.data.p, names_.phi()};
    const Term r = friction()(here);
    const auto acceleration = [&](PhaseKind kind) {
      const Rational u = kind == PhaseKind::slip ? q_.data.us : Rational(-q_.data.us);
      return Term(q_.data.eta) * (Term(u) - r);
    };
    const Variable before{"before"}, after{"after"}, rate{"rate"};
    const Known then = at_event(acceleration(q_.phases[next]), X);
    if (sticks(k)) {
      return {break_away(),
              {q_.data.chi, after, rate},
              {{after, then}, {rate, at_event(friction_rate()(here), X)}}};
    }
    return {crossing(), {before, after}, {{after, then}, {before, at_event(acceleration(q_.phases[k]), X)}}};
  }

  // The event's matrix times a flow, by the entries of both: those of the event are mostly 0 and 1.
  [[nodiscard]] Matrix stepped(const Event& event, const Term& flow) const {
    const Term opened_event = event.definition.unfolded(event.arguments);
    std::vector<Term> entries;
    constexpr std::size_t n = matrix_rows;
    for (std::size_t i = 0; i < n * n; ++i) {
      Symbolic total;
      for (std::size_t k = 0; k < n; ++k) {
        total += Symbolic(opened_event.parts()[n * (i / n) + k]) * Symbolic(flow.parts()[n * k + i % n]);
      }
      entries.push_back(total.term);
    }
    Theorem same = Theorem::combination(
        equal(matrix(matrix_rows, matrix_rows, entries), event.definition(event.arguments) * flow), {},
        {event.definition});
    Ranges ranges = ranges_;
    ranges.merge(ranges_of(event.letters));
    same = settled_by(same, [&](const Formula& one) { return sign(one, ranges, matrix_bits); });
    return matrix_of(entries, ranges, event.letters, settled(same, event.letters));
  }

  // Bounds of a number of the state X at an event.
  [[nodiscard]] Known at_event(const Term& said, const Term& X) const {
    const Definitions definitions{friction(), friction_rate()};
    Term lettered = unfold(said, definitions);
    Multipliers more = *this;
    for (int i = 0; i < matrix_rows; ++i) {
      const Variable x{fmt::format("x{}", i + 1)};
      if (const Term whole = replaced(lettered, entry(X, i), x); whole != lettered) {
        lettered = whole;
        more.add_known(x, entry(X, i));
      }
    }
    const Known one = bounded(lettered, more.ranges_);
    const auto as_said = [&](const Theorem& theorem, const Formula& formula) {
      return Theorem::convert(settled(theorem, more.known_), formula, definitions);
    };
    return {said, one.range, as_said(one.lower, at_most(one.range.first, said)),
            as_said(one.upper, at_most(said, one.range.second))};
  }

  const Question& q_;
  const Theorem& body_;
  std::map<Term, Known> said_;
  Names names_;
  Phases phases_;
  std::vector<Variable> letters_;
  std::vector<Term> system_;
  Box box_;
  std::vector<Symbolic> omega_, over_omega_, lambda_;
  Symbolic over_difference_;
  Letters known_;  // what the orbit's theorem says
  Ranges ranges_;  // of these, and of the unknowns
};

}  // namespace

Theorem stability_theorem(const Theorem& orbit, const Question& question) {
  return orbit_with(orbit, [&](const Theorem& body) { return Multipliers(question, body)(); });
}

}  // namespace stickslip::proofs::orbits
