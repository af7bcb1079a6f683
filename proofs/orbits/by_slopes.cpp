#include "proofs/orbits/enclosed_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace stickslip::proofs::orbits {

using namespace kernel;
using namespace tactics;

namespace {

constexpr int places = 40;

// A definition applied that stands in no other.
std::optional<Term> definition_in(const Term& term) {
  if (term.kind() == Kind::defined) {
    return term;
  }
  for (const Term& part : term.parts()) {
    if (const auto found = definition_in(part)) {
      return found;
    }
  }
  return std::nullopt;
}

class Parts {
 public:
  explicit Parts(const Ranges& ranges) : ranges_(ranges) {}

  Theorem sign(const Formula& relation) {
    Definitions opened;
    const Formula here = lettered(relation, opened);
    return Theorem::convert(settled(Theorem::sign(here, ranges_in(here, ranges_), matrix_bits), letters_),
                            relation, opened);
  }

  Known bounds(const Term& number) {
    Definitions opened;
    return bounds_of(number, lettered(number, opened), opened);
  }

 private:
  // With a letter for each number that a definition stands for; those of matrices are looked into.
  Term lettered(Term term, Definitions& opened) {
    while (const auto applied = definition_in(term)) {
      if (applied->type().is_scalar()) {
        term = replaced(term, *applied, letter(*applied));
      } else {
        opened.insert(applied->definition());
        term = unfold(term, {applied->definition()});
      }
    }
    return term;
  }

  Term letter(const Term& lettered_application) {
    const Term applied = substitute(lettered_application, values_);
    if (const auto known = names_.find(applied); known != names_.end()) {
      return known->second;
    }
    Definitions opened{applied.definition()};
    const Term body = lettered(applied.definition().unfolded(applied.parts()), opened);
    const Known known = bounds_of(applied, body, opened);
    const Variable name{fmt::format("part {}", names_.size() + 1)};
    letters_.emplace(name, known);
    ranges_.emplace(name, known.range);
    names_.emplace(applied, name);
    values_.emplace(name, applied);
    return name;
  }

  // Of a number, in letters once these definitions are opened.
  [[nodiscard]] Known bounds_of(const Term& number, const Term& in_letters, const Definitions& opened) const {
    const Known one = bounded(in_letters, ranges_, places);
    const auto said = [&](const Formula& inequality, const Theorem& theorem) {
      return Theorem::convert(settled(theorem, letters_), inequality, opened);
    };
    return {number, one.range, said(at_most(one.range.first, number), one.lower),
            said(at_most(number, one.range.second), one.upper)};
  }

  Ranges ranges_;  // of the variables, and of the letters
  Letters letters_;
  std::map<Term, Variable> names_;
  Substitution values_;  // of the letters
};

// The numbers in a term that definitions stand for and that depend on t, none within another.
void collect(const Term& term, const Variable& t, std::vector<Term>& found) {
  if (!term.variables().contains(t) || std::ranges::find(found, term) != found.end()) {
    return;
  }
  if (term.kind() == Kind::defined && term.type().is_scalar() && term.is_closed()) {
    found.push_back(term);
    return;
  }
  for (const Term& part : term.parts()) {
    collect(part, t, found);
  }
}

// The derivatives of functions of t.
struct Derivatives {
  Variable t;

  // What is supposed of a part with that number, whose slope is a letter; and what that stands for.
  static Variable slope(std::size_t part) { return {fmt::format("slope{}", part)}; }
  [[nodiscard]] Formula supposed(const Variable& f, std::size_t part) const {
    return derivative(f, t, slope(part));
  }
  static void add(Substitution& values, std::size_t part, const Theorem& known) {
    values.emplace(slope(part), known.conclusion().parts()[2]);
  }
  [[nodiscard]] Theorem of(const Term& f, const std::vector<Theorem>& supposed) const {
    return Theorem::differentiate(f, t, supposed);
  }
  // The slope as a definition NAME_by_t of all that the number depends on.
  [[nodiscard]] Theorem said(const Term& number, const Theorem& known) const {
    const Term slope = defined(number.definition().name() + "_by_" + t.name, known.conclusion().parts()[2],
                               {number.variables().begin(), number.variables().end()});
    return Theorem::convert(known, derivative(lambda(t, number), t, slope),
                            {number.definition(), slope.definition()});
  }
};

// That functions of t are continuous between two ends.
struct Continuity {
  Variable t, from, to;

  [[nodiscard]] Formula supposed(const Variable& f, std::size_t) const { return continuous(f, from, to); }
  static void add(Substitution&, std::size_t, const Theorem&) {}
  [[nodiscard]] Theorem of(const Term& f, const std::vector<Theorem>& supposed) const {
    return Theorem::continuity(f, from, to, supposed);
  }
  [[nodiscard]] Theorem said(const Term& number, const Theorem& known) const {
    return Theorem::convert(known, continuous(lambda(t, number), from, to), {number.definition()});
  }
};

// What is so of a number that a definition stands for, by what is so of the numbers in its body: each has a
// theorem of its own, so that no term is longer than one of them.
template <class Rule>
class ByParts {
 public:
  explicit ByParts(Rule rule) : rule_(std::move(rule)) {}

  // From what is divided by.
  const Theorem& operator()(const Term& number) {
    if (const auto known = known_.find(number); known != known_.end()) {
      return known->second;
    }
    const Theorem body = of(number.definition().unfolded(number.parts()));
    return known_.emplace(number, rule_.said(number, body)).first->second;
  }

 private:
  // A function of t that is a variable stands for each number.
  Theorem of(const Term& term) {
    const Variable& t = rule_.t;
    std::vector<Term> numbers;
    collect(term, t, numbers);
    Term lettered = term;
    std::vector<Theorem> supposed;
    Substitution values;
    for (const Term& number : numbers) {
      const std::size_t part = supposed.size() + 1;
      const Variable letter{fmt::format("part{}", part), function_of_time()};
      lettered = replaced(lettered, number, apply(letter, t));
      supposed.push_back(Theorem::assume(rule_.supposed(letter, part)));
      values.emplace(letter, lambda(t, number));
      rule_.add(values, part, (*this)(number));
    }
    Theorem result = Theorem::instantiate(rule_.of(lambda(t, lettered), supposed), values);
    for (const Term& number : numbers) {
      result = Theorem::cut((*this)(number), result);
    }
    return result;
  }

  Rule rule_;
  std::map<Term, Theorem> known_;
};

// A function of x, and what the mean value theorem needs to know of it.
class Varying {
 public:
  Varying(const Term& f, const Variable& x, const Ranges& ranges)
      : f_(f),
        x_(x),
        ranges_(ranges),
        rate_(ByParts(Derivatives{x})(f)),
        continuity_(ByParts(Continuity{x, from_, to_})(f)) {}

  [[nodiscard]] Rational middle() const { return (lower() + upper()) / 2; }

  // Bounds of f from those of f at the middle m, other variables having values: |f(x) - f(m)| <= K |x - m|,
  // K a bound of the slope.
  [[nodiscard]] Known from(const Known& there, const Substitution& values) const {
    const Rational m = middle();
    Ranges here = ranges_;
    here[c_] = ranges_.at(x_);
    const Known slope = bounded_by_parts(at(rate_.conclusion().parts()[2], c_, values), here);
    const Rational least = slope.range.first.value(), most = slope.range.second.value(),
                   K = std::max(Rational(-least), most) + Rational(1, 1L << 30),
                   reach = K * (upper() - lower()) / 2;
    const Term value = at(f_, x_, values);
    const Interval range{there.range.first.value() - reach, there.range.second.value() + reach};
    const Formula above = at_most(range.first, value), below = at_most(value, range.second);
    std::vector<Theorem> cases{Theorem::trichotomy(x_, m)};
    for (const bool before : {true, false}) {
      const Theorem order = Theorem::assume(before ? less(x_, m) : less(m, x_)),
                    end = Theorem::assume(before ? at_most(lower(), x_) : at_most(x_, upper())),
                    mean = chord(before ? Term(x_) : Term(m), before ? Term(m) : Term(x_), order, values),
                    known = Theorem::assume(opened(mean.conclusion(), c_));
      // f(m) - f(x) is the slope times m - x, f(x) - f(m) is it times x - m: at most K of that, at least -K.
      const auto side = [&](const Formula& goal, const Theorem& from, bool falling) {
        const Theorem bound = within(falling ? slope.lower : slope.upper, known, end, before);
        const Rational rest = falling ? Rational(K + least) : Rational(K - most);
        return Theorem::order(goal, {{{bound, order}}, {{order}, rest}, {{end}, K}, {{from}}},
                              {{part(known, 1), falling ? 1 : -1}});
      };
      const Theorem sides = both({side(above, there.lower, !before), side(below, there.upper, before)});
      cases.push_back(Theorem::discharge(Theorem::choose(mean, c_, sides), order.conclusion()));
    }
    const Theorem same = symmetric(Theorem::assume(equal(x_, m)));
    const Variable place{"place"};
    const Term f = at(f_, place, values);
    const auto moved = [&](const Formula& goal, const Theorem& from) {
      return Theorem::replace(same, place, replaced(goal, value, f),
                              Theorem::order(replaced(goal, value, there.value), {{{from}}, {{}, reach}}));
    };
    cases.push_back(
        Theorem::discharge(both({moved(above, there.lower), moved(below, there.upper)}), equal(x_, m)));
    const Theorem result = Theorem::consequence(cases, all({above, below}));
    return {value, range, part(result, 0), part(result, 1)};
  }

 private:
  [[nodiscard]] Rational lower() const { return ranges_.at(x_).first.value(); }
  [[nodiscard]] Rational upper() const { return ranges_.at(x_).second.value(); }
  [[nodiscard]] Term at(const Term& number, const Term& x, Substitution values) const {
    values.insert_or_assign(x_, x);
    return substitute(number, values);
  }
  // There is c between the ends with f(b) - f(a) = f'(c) (b - a).
  [[nodiscard]] Theorem chord(const Term& a, const Term& b, const Theorem& order, Substitution values) const {
    const Variable s{"s"};
    const Theorem rate =
        without_divisors(Theorem::instantiate(Theorem::instantiate(rate_, values), {{x_, s}}), ranges_);
    values.insert({{from_, a}, {to_, b}});
    return Theorem::mean_value(without_divisors(Theorem::instantiate(continuity_, values), ranges_),
                               for_every(s, between(a, s, b), rate), order);
  }
  // What is so of c in the range, for c between x and m.
  [[nodiscard]] Theorem within(const Theorem& bound, const Theorem& known, const Theorem& end,
                               bool before) const {
    const Theorem where = part(known, 0), from = part(where, 0), to = part(where, 1);
    const Rational half = (upper() - lower()) / 2;
    const Theorem first = Theorem::order(at_most(lower(), c_),
                                         {{{from}}, before ? Positive{{end}} : Positive{{}, half}}),
                  last = Theorem::order(at_most(c_, upper()),
                                        {{{to}}, before ? Positive{{}, half} : Positive{{end}}});
    return Theorem::cut(first, Theorem::cut(last, bound));
  }

  Term f_;
  Variable x_, c_{"c"}, from_{"from"}, to_{"to"};
  const Ranges& ranges_;
  Theorem rate_, continuity_;  // its derivative at x; that it is continuous between any two ends
};

}  // namespace

Theorem sign_by_parts(const Formula& relation, const Ranges& ranges) {
  return Parts(ranges).sign(relation);
}

Known bounded_by_parts(const Term& number, const Ranges& ranges) {
  return Parts(ranges).bounds(number);
}

Theorem for_all_in(const Theorem& theorem, const std::vector<Variable>& variables, const Ranges& ranges) {
  Theorem result = theorem;
  for (auto x = variables.rbegin(); x != variables.rend(); ++x) {
    const auto& [lower, upper] = ranges.at(*x);
    const Formula here = within(lower, *x, upper);
    result = for_every(*x, here, cut_all(parts_of(Theorem::assume(here)), result));
  }
  return result;
}

Known bounded_by_slopes(const Term& number, const std::vector<Variable>& along, const Ranges& ranges) {
  for (const Variable& x : along) {
    if (number.kind() != Kind::defined || !number.type().is_scalar() || !number.variables().contains(x)) {
      throw KernelError("no definition stands for a number that depends on " + x.name);
    }
  }
  std::vector<Varying> functions;
  std::vector<Substitution> values{{}};
  for (const Variable& x : along) {
    functions.emplace_back(number, x, ranges);
    values.push_back(values.back());
    values.back().emplace(x, functions.back().middle());
  }
  Known known = bounded_by_parts(substitute(number, values.back()), ranges);
  for (std::size_t i = along.size(); i-- > 0;) {
    known = functions[i].from(known, values[i]);
  }
  return known;
}

}  // namespace stickslip::proofs::orbits
