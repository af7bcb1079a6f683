#include <algorithm>

#include "numeric/zeros/search.hpp"
#include "proofs/kernel/entrywise.hpp"

namespace stickslip::proofs::kernel {

using namespace numeric::zeros;

namespace {

// Terms in balls, or in jets of balls: the entries contain the exact values (and partial derivatives) for all
// values of the variables in theirs. A divisor whose ball contains zero gives what is not finite, or
// KernelError if `strict`.
template <class T>
struct Balls {
  using Number = T;
  std::map<Variable, std::vector<T>> values;
  bool strict;

  [[nodiscard]] static T number(const Rational& value) { return T(Ball(value)); }
  [[nodiscard]] static T pi() { return T(Ball::pi()); }
  [[nodiscard]] T reciprocal(const T& value) const {
    require(!strict || is_nonzero(value), "a divisor may be zero");
    return T(Ball(1)) / value;
  }
  [[nodiscard]] static T cosine(const Term& argument, auto& entries) { return cos(entries(argument)[0]); }
  [[nodiscard]] static T sine(const Term& argument, auto& entries) { return sin(entries(argument)[0]); }
  [[nodiscard]] std::vector<T> atom(const Term& term, auto& entries) const {
    if (term.kind() == Kind::defined) {
      return entries(term.definition().unfolded(term.parts()));
    }
    const auto value = values.find({term.name(), term.type()});
    require(term.kind() == Kind::variable && value != values.end(), to_string(term) + " has no value");
    return value->second;
  }
};

template <class T>
std::vector<T> evaluated(const Term& term, const std::map<Variable, std::vector<T>>& values, bool strict) {
  return Entrywise<Balls<T>>({values, strict})(term);
}

Term number(const Rational& value) {
  return value;
}

std::vector<Term> flattened(const Box& box) {
  std::vector<Term> ends;
  for (const Interval& side : box) {
    ends.push_back(number(side.first));
    ends.push_back(number(side.second));
  }
  return ends;
}

void check(const Interval& side) {
  require(side.first <= side.second, "an interval's lower end is above the upper one");
  require(abs(side.first) < 1000000000 && abs(side.second) < 1000000000, "an interval's ends are below 10^9");
}

void check(const Box& box, const Variable& X) {
  require(X.type == real_matrix(static_cast<int>(box.size()), 1),
          "a box has as many sides as the column entries");
  std::for_each(box.begin(), box.end(), [](const Interval& side) { check(side); });
}

// f as a function of the column X, for Krawczyk's test and the search.
template <int N>
struct System {
  Variable X;
  Term f;
  bool strict;

  template <class T>
  Eigen::Matrix<T, N, 1> operator()(const Eigen::Matrix<T, N, 1>& x) const {
    const std::vector<T> values = evaluated<T>(f, {{X, std::vector<T>(x.begin(), x.end())}}, strict);
    Eigen::Matrix<T, N, 1> result;
    std::copy(values.begin(), values.end(), result.begin());
    return result;
  }
};

bool lies_in(const Ball& ball, const Interval& side) {
  return ball.is_finite() && (ball - Ball(side.first)).is_positive() &&
         (Ball(side.second) - ball).is_positive();
}

template <int N>
bool lies_in(const numeric::zeros::Box<N>& balls, const Box& box) {
  for (int i = 0; i < N; ++i) {
    if (!lies_in(balls(i), box[static_cast<std::size_t>(i)])) {
      return false;
    }
  }
  return true;
}

template <int N>
bool has_one_zero(const Variable& X, const Term& f, const Box& box) {
  numeric::zeros::Box<N> balls;
  for (int i = 0; i < N; ++i) {
    const Interval& side = box[static_cast<std::size_t>(i)];
    balls(i) = Ball::from_interval(side.first, side.second);
  }
  const ZeroProof<N> proof = krawczyk_test<N>(System<N>{X, f, true}, balls);
  return proof.verdict.truth == Truth::proved && lies_in<N>(proof.box, box);
}

// The domain in doubles, a little larger.
template <int N>
Cell<N> cell(const Box& box) {
  Cell<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const Ball side = Ball::from_interval(box[i].first, box[i].second);
    result.lower[i] = arf_get_d(arb_midref(side.lower().raw()), ARF_RND_FLOOR);
    result.upper[i] = arf_get_d(arb_midref(side.upper().raw()), ARF_RND_CEIL);
  }
  return result;
}

template <int N>
bool holds_all_zeros(const Variable& X, const Term& f, const Box& box, const std::vector<Box>& boxes) {
  using F = System<N>;
  const F system{X, f, false};
  const SearchResult<N> found =
      search<N>(cell<N>(box), KrawczykContractor<N, F>{system}, KrawczykDecider<N, F>{system});
  return found.complete() &&
         std::all_of(found.zeros.begin(), found.zeros.end(), [&](const FoundZero<N>& zero) {
           const numeric::zeros::Box<N> narrow = refine<N>([&] { return system; }, zero.zero, 60);
           return std::any_of(boxes.begin(), boxes.end(),
                              [&](const Box& one) { return lies_in<N>(narrow, one); });
         });
}

void check_system(const Variable& X, const Term& f, const Box& box) {
  check(box, X);
  require(box.size() <= 4, "a system has at most 4 unknowns");
  require(f.is_closed() && f.type().is_numeric() && f.type().rows == X.type.rows && f.type().columns == 1,
          "a system has as many equations as unknowns");
  require(std::all_of(f.variables().begin(), f.variables().end(), [&](const Variable& v) { return v == X; }),
          "a system has no variable but its unknown");
}

// Every member of the polynomial with these coefficients, from c0 up, has all zeros inside the unit circle:
// |c0| < |cn|, and so has the polynomial (cn p - c0 p*)/z, where p* is p with the coefficients turned round.
bool passes_jury(std::vector<Ball> c) {
  while (c.size() > 1) {
    const Ball first = c.front(), last = c.back();
    if (!(last * last - first * first).is_positive()) {
      return false;
    }
    std::vector<Ball> next;
    for (std::size_t k = 1; k < c.size(); ++k) {
      next.push_back(last * c[k] - first * c[c.size() - 1 - k]);
    }
    c = std::move(next);
  }
  return true;
}

}  // namespace

Formula inside(const Term& x, const Box& box) {
  std::vector<Formula> parts;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const Term side = entry(x, static_cast<int>(i));
    parts.push_back(within(number(box[i].first), side, number(box[i].second)));
  }
  return all(parts);
}

Formula exactly_one(const Variable& x, const Box& box, const Formula& a) {
  const Variable y = fresh(x.type, {x, a});
  const Formula here = all({inside(x, box), a});
  const Formula there = substitute(here, {{x, y}});
  return all({exists(x, here), for_all(x, for_all(y, implies(all({here, there}), equal(x, y))))});
}

Theorem Theorem::sign(const Formula& relation, const std::map<Variable, Interval>& ranges, long bits) {
  const bool differs = relation.kind() == Kind::negation && relation.parts()[0].kind() == Kind::equal;
  require(differs || relation.kind() == Kind::less || relation.kind() == Kind::at_most,
          "the sign rule is of <, <= and of two numbers that differ");
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
  const Formula& compared = differs ? relation.parts()[0] : relation;
  require(compared.parts()[0].type().is_scalar() && compared.parts()[1].type().is_scalar(),
          "only numbers have signs");
  Step step{.rule = "sign", .data = {relation, bits}};
  Formulas hypotheses;
  std::map<Variable, std::vector<Ball>> values;
  const WorkingPrecision scope(bits);
  for (const auto& [variable, range] : ranges) {
    require(variable.type.is_scalar(), "only numbers have ranges");
    check(range);
    values[variable] = {Ball::from_interval(range.first, range.second)};
    hypotheses.insert(at_most(number(range.first), variable));
    hypotheses.insert(at_most(variable, number(range.second)));
    step.data.insert(step.data.end(), {variable, number(range.first), number(range.second)});
  }
  const Ball difference = evaluated<Ball>(compared.parts()[1] - compared.parts()[0], values, true)[0];
  require(differs ? difference.is_nonzero() : difference.is_positive(), "the balls do not decide the sign");
  return {step, hypotheses, relation};
}

Theorem Theorem::one_zero(const Variable& X, const Term& f, const Box& box, long bits) {
  check_system(X, f, box);
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
  const WorkingPrecision scope(bits);
  const std::size_t n = box.size();
  require(n == 1   ? has_one_zero<1>(X, f, box)
          : n == 2 ? has_one_zero<2>(X, f, box)
          : n == 3 ? has_one_zero<3>(X, f, box)
                   : has_one_zero<4>(X, f, box),
          "Krawczyk's test does not prove that the box holds exactly one zero");
  Step step{.rule = "one_zero", .data = {X, f, bits}};
  const std::vector<Term> ends = flattened(box);
  step.data.insert(step.data.end(), ends.begin(), ends.end());
  return {step, {}, exactly_one(X, box, equal(f, zero(X.type)))};
}

Theorem Theorem::every_zero(const Variable& X, const Term& f, const Box& box, const std::vector<Box>& boxes) {
  check_system(X, f, box);
  std::vector<Formula> cases;
  Step step{.rule = "every_zero", .data = {X, f}};
  std::vector<Term> ends = flattened(box);
  for (const Box& one : boxes) {
    check(one, X);
    cases.push_back(inside(X, one));
    const std::vector<Term> more = flattened(one);
    ends.insert(ends.end(), more.begin(), more.end());
  }
  step.data.insert(step.data.end(), ends.begin(), ends.end());
  const std::size_t n = box.size();
  require(n == 1   ? holds_all_zeros<1>(X, f, box, boxes)
          : n == 2 ? holds_all_zeros<2>(X, f, box, boxes)
          : n == 3 ? holds_all_zeros<3>(X, f, box, boxes)
                   : holds_all_zeros<4>(X, f, box, boxes),
          "the search does not prove that the boxes hold every zero");
  return {step, {}, for_all(X, implies(all({inside(X, box), equal(f, zero(X.type))}), any(cases)))};
}

Theorem Theorem::jury(const Term& coefficients, long bits) {
  const Formula conclusion = inside_unit_circle(coefficients);
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
  const WorkingPrecision scope(bits);
  require(passes_jury(evaluated<Ball>(coefficients, {}, true)), "Jury's test does not prove it");
  return {{.rule = "jury", .data = {coefficients, bits}}, {}, conclusion};
}

}  // namespace stickslip::proofs::kernel
