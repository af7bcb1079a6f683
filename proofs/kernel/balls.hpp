// Terms in balls: what the rules about numbers share. Of the kernel only.
#pragma once

#include <algorithm>

#include "core/ball.hpp"
#include "proofs/kernel/entrywise.hpp"

namespace stickslip::proofs::kernel {

// Terms in balls, or in jets of balls: the entries contain the exact values (and partial derivatives) for all
// values of the variables in theirs. Throws KernelError where a divisor's ball contains zero.
template <class T>
struct Balls {
  using Number = T;
  std::map<Variable, std::vector<T>> values;

  [[nodiscard]] static T number(const Rational& value) { return T(Ball(value)); }
  [[nodiscard]] static T pi() { return T(Ball::pi()); }
  [[nodiscard]] T reciprocal(const T& value) const {
    require(is_nonzero(value), "a divisor may be zero");
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
std::vector<T> evaluated(const Term& term, const std::map<Variable, std::vector<T>>& values) {
  return Entrywise<Balls<T>>({values})(term);
}

inline Term number(const Rational& value) {
  return value;
}

inline std::vector<Term> flattened(const Box& box) {
  std::vector<Term> ends;
  for (const Interval& side : box) {
    ends.push_back(number(side.first));
    ends.push_back(number(side.second));
  }
  return ends;
}

inline void check(const Interval& side) {
  require(side.first <= side.second, "an interval's lower end is above the upper one");
  require(abs(side.first) < 1000000000 && abs(side.second) < 1000000000, "an interval's ends are below 10^9");
}

inline void check(const Box& box, const Variable& X) {
  require(X.type == real_matrix(static_cast<int>(box.size()), 1),
          "a box has as many sides as the column entries");
  std::for_each(box.begin(), box.end(), [](const Interval& side) { check(side); });
}

}  // namespace stickslip::proofs::kernel
