#include "proofs/orbits/all_zeros.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/transformed.hpp"
#include "proofs/orbits/enclosed_matrix.hpp"
#include "proofs/tactics/closed.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

class Zeros {
 public:
  Zeros(const Differentiable& f, const std::vector<Term>& others, const Variable& t, const Interval& ends,
        const Ranges& ranges)
      : f_(f), others_(others), t_(t), ends_(ends), ranges_(ranges), rate_(f.rate) {
    const std::vector<Variable>& parameters = f.value.parameters();
    Substitution values;
    for (std::size_t i = 0; i < others.size(); ++i) {
      values.emplace(parameters.at(i), others[i]);
    }
    values.emplace(parameters.back(), s_);
    rate_ = Theorem::instantiate(rate_, values);
  }

  AllZeros operator()(std::vector<Rational> nearly) {
    if (nearly.empty()) {
      throw KernelError("there are no zeros to enclose");
    }
    std::sort(nearly.begin(), nearly.end());
    for (std::size_t k = 0; k < nearly.size(); ++k) {
      enclose(nearly[k], {fmt::format("{}_{}", t_.name, k + 1)});
    }
    const auto cases = transformed(zeros_, [&](const Zero& zero) { return equal(t_, zero.said.x); });
    const Formula goal = cases.size() == 1 ? cases.front() : any(cases);
    // From one end to the other.
    std::optional<Theorem> so_far;
    Rational reached = ends_.first;
    for (std::size_t k = 0; k < zeros_.size(); ++k) {
      const Rational lower = k == 0 ? ends_.first : (nearly[k - 1] + nearly[k]) / 2,
                     upper = k + 1 == zeros_.size() ? ends_.second : (nearly[k] + nearly[k + 1]) / 2;
      const Near near = about(zeros_[k], lower, upper);
      append(so_far, reached, near.from, goal);
      const Theorem here = Theorem::consequence({near.is_it}, goal);
      so_far = so_far ? either_side(*so_far, here, t_, near.from) : here;
      reached = near.to;
    }
    append(so_far, reached, ends_.second, goal);
    return {transformed(zeros_, [](const Zero& zero) { return zero.said; }), *so_far};
  }

 private:
  struct Zero {
    EnclosedZero said;
    bool rises;
  };
  struct Near {
    Rational from, to;
    Theorem is_it;  // from <= t, t <= to, f(t) = 0 ⊢ t is the zero
  };

  [[nodiscard]] Term with(const Definition& definition, const Term& x) const {
    std::vector<Term> arguments = others_;
    arguments.push_back(x);
    return definition(arguments);
  }
  [[nodiscard]] Term value(const Term& x) const { return with(f_.value, x); }
  [[nodiscard]] Term slope(const Term& x) const { return with(f_.slope, x); }
  [[nodiscard]] Term function(bool rises) const { return lambda(s_, rises ? value(s_) : -value(s_)); }
  [[nodiscard]] Theorem discharged(const Theorem& theorem) const {
    return without_divisors(theorem, ranges_);
  }

  // By the intermediate value, between decimals of nine places.
  void enclose(const Rational& nearly, const Variable& x) {
    constexpr long unit = 1000000000;
    const Rational a = rounded_down(nearly, unit) - Rational(1, unit), b = a + Rational(3, unit);
    const bool rises = holds(less(value(a), 0), ranges_);
    const Term f = function(rises);
    const Theorem found = Theorem::intermediate_value(
        discharged(Theorem::continuity(f, a, b)), sign(less(apply(f, a), 0), ranges_),
        sign(less(0, apply(f, b)), ranges_), sign(less(a, b), ranges_));
    const Theorem there = Theorem::assume(opened(found.conclusion(), x));
    const Theorem vanishes = part(there, 1);
    const Theorem says =
        both({Theorem::consequence({there}, less(a, x)), Theorem::consequence({there}, less(x, b)),
              rises ? vanishes : Theorem::combination(equal(value(x), 0), {{vanishes, -1}})});
    zeros_.push_back(
        {{x, {a, b}, says.conclusion(), Theorem::choose(found, x, tactics::there_are({x}, says))}, rises});
  }

  // As far about the zero as the slope keeps its sign, of a quarter, an eighth, … to both sides.
  [[nodiscard]] Near about(const Zero& zero, const Rational& lower, const Rational& upper) const {
    const auto& [a, b] = zero.said.bounds;
    for (Rational reach(1, 4); reach > Rational(1, 1L << 20); reach = reach / 2) {
      const Rational from = std::max(lower, rounded_down(a - reach, 1L << 22)),
                     to = std::min(upper, rounded_down(b + reach, 1L << 22));
      const Variable c{"c"};
      Ranges here = ranges_;
      here[c] = {from, to};
      const auto keeps =
          attempt([&] { return in_pieces(zero.rises ? less(0, slope(c)) : less(slope(c), 0), c, here); });
      if (keeps) {
        return {from, to, is_zero(zero, from, to, c, *keeps)};
      }
    }
    throw KernelError("there may be other zeros of " + f_.value.name() + " near this one");
  }

  [[nodiscard]] Theorem is_zero(const Zero& zero, const Rational& from, const Rational& to, const Variable& c,
                                const Theorem& keeps) const {
    const Variable& x = zero.said.x;
    Theorem result =
        Theorem::consequence({not_before(t_, x, zero.rises, from, to, c, keeps),
                              not_before(x, t_, zero.rises, from, to, c, keeps), Theorem::trichotomy(t_, x)},
                             equal(t_, x));
    const Theorem says = Theorem::assume(zero.said.says);
    const auto& [a, b] = zero.said.bounds;
    for (const Theorem& known :
         {Theorem::order(at_most(from, x), {{{part(says, 0)}}, Positive{{}, a - from}}),
          Theorem::order(at_most(x, to), {{{part(says, 1)}}, Positive{{}, to - b}}), part(says, 2)}) {
      result = Theorem::cut(known, result);
    }
    return result;
  }

  // from <= x, y <= to, f(x) = 0, f(y) = 0 ⊢ not x < y: else the slope would be zero between them.
  [[nodiscard]] Theorem not_before(const Variable& x, const Variable& y, bool rises, const Rational& from,
                                   const Rational& to, const Variable& c, const Theorem& keeps) const {
    const Theorem before = Theorem::assume(less(x, y));
    const Term f = function(true);
    const Theorem mean = Theorem::mean_value(discharged(Theorem::continuity(f, x, y)),
                                             for_every(s_, between(x, s_, y), discharged(rate_)), before);
    const Theorem there = Theorem::assume(opened(mean.conclusion(), c));
    const Theorem where = part(there, 0);
    Theorem falls = keeps;
    falls = Theorem::cut(
        Theorem::order(at_most(from, c), {{{part(where, 0)}}, {{Theorem::assume(at_most(from, x))}}}), falls);
    falls = Theorem::cut(
        Theorem::order(at_most(c, to), {{{part(where, 1)}}, {{Theorem::assume(at_most(y, to))}}}), falls);
    const int direction = rises ? 1 : -1;
    const Theorem contradiction = Theorem::order(less(0, 0), {{{falls, before}}},
                                                 {{part(there, 1), direction},
                                                  {Theorem::assume(equal(value(y), 0)), -direction},
                                                  {Theorem::assume(equal(value(x), 0)), direction}});
    return impossible(before.conclusion(), Theorem::choose(mean, c, contradiction));
  }

  // from <= t, t <= to, f(t) = 0 ⊢ the goal, as f(t) is not zero there.
  void append(std::optional<Theorem>& so_far, const Rational& from, const Rational& to,
              const Formula& goal) const {
    if (from >= to) {
      return;
    }
    Ranges here = ranges_;
    here[t_] = {from, to};
    const Theorem vanishes = Theorem::assume(equal(value(t_), 0));
    const Theorem away = in_pieces(t_, here, [&](const Ranges& piece) {
      return Theorem::consequence({different(away_from_zero(piece)), vanishes}, goal);
    });
    so_far = so_far ? either_side(*so_far, away, t_, from) : away;
  }

  // That the function is above zero, or that it is below.
  [[nodiscard]] Theorem away_from_zero(const Ranges& piece) const {
    const auto above = attempt([&] { return sign(less(0, value(t_)), piece); });
    return above ? *above : sign(less(value(t_), 0), piece);
  }

  const Differentiable& f_;
  const std::vector<Term>& others_;
  const Variable& t_;
  Interval ends_;
  const Ranges& ranges_;
  const Variable s_{"s"};
  Theorem rate_;  // at s
  std::vector<Zero> zeros_;
};

}  // namespace

Differentiable differentiable(const Definition& value) {
  const std::vector<Variable>& parameters = value.parameters();
  const Variable& t = parameters.back();
  const Term f = lambda(t, value({parameters.begin(), parameters.end()}));
  const Theorem found = Theorem::differentiate(f, t);
  const Term slope = defined(value.name() + "_slope", found.conclusion().parts()[2], parameters);
  return {value, slope.definition(), Theorem::convert(found, derivative(f, t, slope), {slope.definition()})};
}

Theorem within_bounds(const EnclosedZero& zero, Theorem theorem) {
  const Theorem there = Theorem::assume(zero.says);
  const auto& [lower, upper] = zero.bounds;
  theorem = Theorem::cut(Theorem::order(at_most(lower, zero.x), {{{part(there, 0)}}}), theorem);
  return Theorem::cut(Theorem::order(at_most(zero.x, upper), {{{part(there, 1)}}}), theorem);
}

Theorem there_are(const std::vector<EnclosedZero>& zeros, Theorem theorem) {
  for (auto zero = zeros.rbegin(); zero != zeros.rend(); ++zero) {
    theorem = tactics::there_are({zero->x}, theorem);
  }
  for (const EnclosedZero& zero : zeros) {
    theorem = Theorem::choose(zero.exists, zero.x, theorem);
  }
  return theorem;
}

AllZeros all_zeros(const Differentiable& f, const std::vector<Term>& others, const Variable& t,
                   const Interval& ends, const Ranges& ranges, const std::vector<Rational>& nearly) {
  return Zeros(f, others, t, ends, ranges)(nearly);
}

namespace {

// The equation in the entries of the unknown column, from the whole system.
Theorem row(const Formula& equation, const std::vector<Term>& terms, const Theorem& vanishes,
            const Substitution& entries) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (equation == equal(substitute(terms[i], entries), 0)) {
      return Theorem::combination(equation, {{vanishes, unit(1, static_cast<int>(terms.size()), i)}});
    }
  }
  throw KernelError("this is none of the equations: " + to_string(equation));
}

// The unknowns as entries of one column.
struct Column {
  Variable Y;
  Substitution entries;

  explicit Column(const std::vector<Variable>& unknowns)
      : Y{"Y", real_matrix(static_cast<int>(unknowns.size()), 1)} {
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      entries.emplace(unknowns[i], entry(Y, static_cast<int>(i)));
    }
  }
  [[nodiscard]] Term system(const std::vector<Term>& terms) const {
    return substitute(matrix(Y.type.rows, 1, terms), entries);
  }
};

}  // namespace

Theorem exactly_one_zero(const std::vector<Variable>& unknowns, const std::vector<Term>& terms,
                         const Box& box, const Substitution& at_value) {
  const Column column(unknowns);
  return Theorem::one_zero(column.Y, substitute(column.system(terms), at_value), box);
}

Theorem with_zero(const Theorem& theorem, const std::vector<Variable>& unknowns,
                  const std::vector<Term>& terms, const Box& box, const Substitution& at_value) {
  const Column column(unknowns);
  const Variable& Y = column.Y;
  const Substitution& entries = column.entries;
  const Term system = column.system(terms);  // with the letters of at_value; then at their values
  const Theorem existence = part(exactly_one_zero(unknowns, terms, box, at_value), 0);
  const Theorem found = Theorem::assume(all({inside(Y, box), equal(system, zero(Y.type))}));
  const Theorem of_column =
      settled_by(Theorem::instantiate(theorem, entries), [&](const Formula& one) -> std::optional<Theorem> {
        return !one.variables().contains(Y) ? std::nullopt
               : one.kind() == Kind::equal  ? std::optional(row(one, terms, part(found, 1), entries))
                                            : std::optional(Theorem::consequence({found}, one));
      });
  return Theorem::choose(existence, Y,
                         settled_by(Theorem::instantiate(of_column, at_value), [](const Formula& one) {
                           return one.variables().empty() ? std::optional(certainly(one)) : std::nullopt;
                         }));
}

Theorem of_orbit(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  std::vector<Formula> existences{orbit.conclusion()};
  std::vector<Variable> names;
  while (existences.back().kind() == Kind::exists) {
    names.push_back({existences.back().name(), existences.back().binds()});
    existences.push_back(opened(existences.back(), names.back()));
  }
  Theorem result = more(Theorem::assume(existences.back()));
  std::vector<Variable> spoken_of;
  std::ranges::copy_if(names, std::back_inserter(spoken_of),
                       [&](const Variable& one) { return result.conclusion().variables().contains(one); });
  result = tactics::there_are(spoken_of, result);
  for (std::size_t i = names.size(); i-- > 0;) {
    result = Theorem::choose(i == 0 ? orbit : Theorem::assume(existences[i]), names[i], result);
  }
  return result;
}

Theorem orbit_with(const Theorem& orbit, const std::function<Theorem(const Theorem&)>& more) {
  return of_orbit(orbit, [&](const Theorem& body) { return tactics::both({body, more(body)}); });
}

}  // namespace stickslip::proofs::orbits
