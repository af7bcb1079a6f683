#include "proofs/tactics/roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::proofs::tactics {

using namespace kernel;

namespace {

Term squared(const Term& x) {
  return power(x, 2);
}

Rational rational(long double value) {
  const auto first = static_cast<double>(value);
  return Rational(first) + Rational(static_cast<double>(value - static_cast<long double>(first)));
}

}  // namespace

long double nearly_root(long double square) {
  constexpr long double rounding = 1e-15L;
  return std::sqrt(-rounding < square && square < 0 ? 0 : square);
}

bool Roots::know(const Term& term) const {
  return std::ranges::all_of(term.variables(), [this](const Variable& x) { return contains(x); });
}

long double Roots::near(const Term& square) const {
  const long double result = nearly_root(estimated(square, midpoints_));
  if (!std::isfinite(result)) {
    throw KernelError("there is no root of " + to_string(square));
  }
  return result;
}

std::optional<Rational> Roots::rational_root(const Term& square) const {
  constexpr int largest_denominator = 1000;
  constexpr long double largest = 1e9L, fault = 1e-12L;
  const long double wanted = near(square);
  for (int below = 1; below <= largest_denominator && wanted < largest; ++below) {
    Rational guess(std::lround(wanted * static_cast<long double>(below)), below);
    guess.canonicalize();
    if (std::abs(static_cast<long double>(guess.get_d()) - wanted) < fault * (1 + wanted) &&
        attempt([&] { return certainly(equal(squared(Term(guess)), square), known_); })) {
      return guess;
    }
  }
  return std::nullopt;
}

Roots::Bounds Roots::bounded(const Theorem& square, const Theorem& not_negative, const Rational& lower,
                             const Rational& upper) const {
  const Term x = square.conclusion().parts()[0].parts()[0], a = square.conclusion().parts()[1];
  const Theorem above = certainly(less(squared(lower), a), known_),
                below = certainly(less(a, squared(upper)), known_);
  const Theorem least =
      below_by_squares(Theorem::order(less(squared(lower), squared(x)), {Positive{{above}}}, {{square}}),
                       not_negative, lower, x);
  const Theorem greatest =
      below_by_squares(Theorem::order(less(squared(x), squared(upper)), {Positive{{below}}}, {{square, -1}}),
                       certainly(at_most(0, upper)), x, upper);
  return {Variable{x.name()},
          {Theorem::order(at_most(lower, x), {Positive{{least}}}),
           Theorem::order(at_most(x, upper), {Positive{{greatest}}})}};
}

void Roots::add(const Theorem& square, const Theorem& not_negative) {
  constexpr std::array relative_widths{0x1p-60L, 0x1p-50L, 0x1p-36L, 0x1p-20L};
  const Term &x = square.conclusion().parts()[0].parts()[0], &a = square.conclusion().parts()[1];
  const auto take = [&](const Bounds& bounds, const Rational& lower, const Rational& middle,
                        const Rational& upper) {
    bounds_.push_back(bounds);
    known_.ranges.emplace(bounds.root, Interval{lower, upper});
    known_.squares.push_back(square);
    midpoints_.emplace(bounds.root, middle);
  };
  if (const auto zero = attempt([&] { return certainly(equal(a, 0), known_); })) {
    const Theorem squares =
        Theorem::order(at_most(squared(x), squared(Term(0))), {}, {{square, -1}, {*zero, -1}});
    take({Variable{x.name()},
          {Theorem::order(at_most(0, x), {Positive{{not_negative}}}),
           at_most_by_squares(squares, certainly(at_most(0, 0)), x, 0)}},
         0, 0, 0);
    return;
  }
  const long double middle = near(a);
  for (const long double width : relative_widths) {
    const Rational lower = rational(middle * (1 - width)), upper = rational(middle * (1 + width));
    if (const auto found = attempt([&] { return bounded(square, not_negative, lower, upper); })) {
      take(*found, lower, rational(middle), upper);
      return;
    }
  }
  throw KernelError("no range of a root is found: " + to_string(square.conclusion()));
}

Theorem Roots::without_range(const Variable& x, const Theorem& theorem) const {
  const auto bounds = std::ranges::find(bounds_, x, &Bounds::root);
  return bounds == bounds_.end() ? theorem : cut_all(bounds->ends, theorem);
}

Theorem Roots::without_ranges(Theorem theorem) const {
  for (auto one = bounds_.rbegin(); one != bounds_.rend(); ++one) {
    theorem = cut_all(one->ends, theorem);
  }
  return theorem;
}

}  // namespace stickslip::proofs::tactics
