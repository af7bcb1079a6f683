// Terms in balls: what the rules about numbers share. Of the kernel only.
#pragma once

#include <algorithm>

#include "core/ball_arithmetic.hpp"
#include "proofs/kernel/entrywise.hpp"

namespace stickslip::proofs::kernel {

// The entries contain the exact values for all values of the variables in theirs. Throws KernelError where a
// divisor's ball contains zero.
struct Balls {
  using Number = Ball;
  using Values = std::map<Variable, std::vector<Ball>, Before>;
  Values values;

  [[nodiscard]] static Ball number(const Rational& value) { return Ball(value); }
  [[nodiscard]] static Ball pi() { return Ball::pi(); }
  [[nodiscard]] static Ball reciprocal(const Ball& value) {
    require(value.is_nonzero(), "a divisor may be zero");
    return Ball(1) / value;
  }
  [[nodiscard]] static Ball cosine(const Term& argument, auto& entries) { return cos(entries(argument)[0]); }
  [[nodiscard]] static Ball sine(const Term& argument, auto& entries) { return sin(entries(argument)[0]); }
  [[nodiscard]] static Ball exponential(const Term& argument, auto& entries) {
    return exp(entries(argument)[0]);
  }
  [[nodiscard]] std::vector<Ball> atom(const Term& term, auto& entries) const {
    if (term.kind() == Kind::defined) {
      return entries(term.definition().unfolded(term.parts()));
    }
    const auto value = values.find({term.name(), term.type()});
    require(term.kind() == Kind::variable && value != values.end(),
            "a number has no value: it is no variable, or has no range");
    return value->second;
  }
};
using InBalls = Entrywise<Balls>;

inline Ball ball(const Interval& side) {
  require(side.first <= side.second, "an interval's lower end is above the upper one");
  require(abs(side.first.value()) < 1000000000 && abs(side.second.value()) < 1000000000,
          "an interval's ends are below 10^9");
  return Ball::from_interval(side.first, side.second);
}

inline void require_precision(long bits) {
  require(bits >= 2 && bits <= 100000, "the precision is 2 to 100000 bits");
}

}  // namespace stickslip::proofs::kernel
