#include <stickslip/core/decimal.hpp>

#include "den_hartog.hpp"

namespace den_hartog {

namespace tactics = stickslip::proofs::tactics;
using namespace kernel;

namespace {

using stickslip::parse_rational;

// omega = 1/2: the half period is 2 pi, sin(pi/omega) = 0, so phi = 0 and X = q = 4 a/3.
Term velocity_at_half() {
  return substitute(velocity(t), {{omega, stickslip::Rational(1, 2)}, {phi, 0}, {X, Term(a) * 4 / 3}});
}
Term limit() {
  return 2 * (Term(f) * cos(Term(t) / 2) - Term(a) / 3);
}

std::vector<Theorem> factors() {
  return {tactics::by_normal_form(equal(velocity_at_half(), sin(Term(t) / 2) * limit()), {})};
}

// 0 < t < 2 pi and 3 f < a, 0 < f: then f cos(t/2) <= f < a/3, so the velocity is below 0 all the way.
std::vector<Theorem> no_stop() {
  const Theorem later = Theorem::assume(less(0, t)), before = Theorem::assume(less(t, 2 * pi()));
  const Theorem in_half =
      tactics::both({Theorem::order(less(0, Term(t) / 2), {{{later}, stickslip::Rational(1, 2)}}),
                     Theorem::order(less(Term(t) / 2, pi()), {{{before}, stickslip::Rational(1, 2)}})});
  const Theorem sine = tactics::detach(Theorem::sine_is_positive(Term(t) / 2), in_half);
  // 2 f (1 - cos(t/2)) = 4 f sin²(t/4) >= 0.
  const Theorem loaded = Theorem::assume(less(3 * Term(f), a)), friction = Theorem::assume(less(0, f));
  const Theorem slower = Theorem::order(
      less(limit(), 0), {{{loaded}, stickslip::Rational(2, 3)}, {{friction}, 4, sin(Term(t) / 4)}});
  const Theorem moves = Theorem::order(less(sin(Term(t) / 2) * limit(), 0), {{{sine, slower}}});
  const Variable value{"value"};
  return {Theorem::replace(tactics::symmetric(factors().front()), value, less(value, 0), moves)};
}

// omega = 3/4, a = 1, f = 1/5: X^2 between two decimals.
std::vector<Theorem> figure() {
  const Term C = cos(half), S = sin(half);
  const Term square =
      substitute(power(q, 2) - power(Term(f) * S / (Term(omega) * (1 + C)), 2),
                 {{omega, stickslip::Rational(3, 4)}, {a, 1}, {f, stickslip::Rational(1, 5)}});
  return {Theorem::sign(less(parse_rational("5.011"), square)),
          Theorem::sign(less(square, parse_rational("5.012")))};
}

// Without the omega of the denominator it would be another number.
std::vector<Theorem> other_figure() {
  const Term C = cos(half), S = sin(half);
  const Term square =
      substitute(power(q, 2) - power(Term(f) * S / (1 + C), 2),
                 {{omega, stickslip::Rational(3, 4)}, {a, 1}, {f, stickslip::Rational(1, 5)}});
  return {Theorem::sign(less(parse_rational("5.1"), square))};
}

}  // namespace

std::vector<methods::Claim> numbers() {
  using methods::Origin;
  return {claim("half.velocity", "at $omega = 1/2$ the velocity is $sin(t/2)$ times $2 (f cos(t/2) - a/3)$",
                factors, Origin::auxiliary),
          claim("half.moves", "there, for $0 < 3 f < a$, the mass does not stop between its turns", no_stop),
          claim("figure.amplitude", "$omega = 3/4$, $a = 1$, $f = 1/5$: $5.011 < X^2 < 5.012$", figure,
                Origin::auxiliary),
          claim("figure.omega", "without $omega$ in the denominator it would be above 5.1", other_figure,
                Origin::auxiliary)};
}

}  // namespace den_hartog
