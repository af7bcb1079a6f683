#include "den_hartog.hpp"

namespace den_hartog {

namespace tactics = stickslip::proofs::tactics;
using namespace kernel;

namespace {

const Term C = cos(half), S = sin(half);

// The motion is symmetric: half a period later it is at -X, at rest.
Formula returns() {
  return equal(position(half), -Term(X));
}
Formula rests() {
  return equal(velocity(half), 0);
}
// What follows: X = q cos(phi), and (1 + C) omega q sin(phi) = -f S.
Formula in_phase() {
  return equal(X, q * cos(phi));
}
Formula out_of_phase() {
  return equal((1 + C) * omega * q * sin(phi), -Term(f) * S);
}
Formula amplitude() {
  return equal(power(X, 2), power(q, 2) - power(Term(f) * S / (Term(omega) * (1 + C)), 2));
}

// With A = X - f - q cos(phi) and B = omega q sin(phi) the two say A (1 + C) + B S = -2 f and B (1 + C) = A
// S; (1 + C) times the first and S times the second give 2 (1 + C) (A + f) = 0.
std::vector<Theorem> greatest_distance() {
  const Term factor = 1 / (2 * (1 + C));
  return {tactics::by_combination(
      in_phase(), {{Theorem::assume(returns()), factor * (1 + C)}, {Theorem::assume(rests()), -factor * S}})};
}
std::vector<Theorem> sine() {
  return {tactics::by_combination(out_of_phase(),
                                  {{Theorem::assume(rests())}, {Theorem::assume(in_phase()), S}})};
}
// q² cos² + q² sin² = q².
std::vector<Theorem> amplitudes() {
  const Term b = Term(omega) * (1 + C), u = b * q * sin(phi), v = -Term(f) * S;
  return {tactics::by_combination(amplitude(), {{Theorem::assume(in_phase()), Term(X) + q * cos(phi)},
                                                {Theorem::assume(out_of_phase()), -(u + v) / power(b, 2)}})};
}
std::vector<Theorem> lag() {
  return {tactics::by_combination(equal((1 + C) * omega * sin(phi) * X, -Term(f) * S * cos(phi)),
                                  {{Theorem::assume(in_phase()), (1 + C) * omega * sin(phi)},
                                   {Theorem::assume(out_of_phase()), cos(phi)}})};
}
// The converse: such a motion is symmetric.
std::vector<Theorem> sufficient() {
  const Theorem cosine = Theorem::assume(in_phase()), sine = Theorem::assume(out_of_phase());
  return {tactics::by_combination(returns(), {{cosine, 1 + C}, {sine, S / (1 + C)}}),
          tactics::by_combination(rests(), {{cosine, -S}, {sine}})};
}
// Where omega = 1/3, 1 + cos(pi/omega) = 0: a symmetric motion without stops has no friction.
std::vector<Theorem> third() {
  const Substitution at{{omega, stickslip::Rational(1, 3)}};
  return {tactics::by_combination(equal(f, 0),
                                  {{Theorem::assume(substitute(returns(), at)), stickslip::Rational(1, 2)}})};
}
// Without friction the amplitude is that of the forced motion.
std::vector<Theorem> frictionless() {
  const Substitution none{{f, 0}};
  return {tactics::by_combination(equal(power(X, 2), power(q, 2)),
                                  {{Theorem::assume(substitute(amplitude(), none))}})};
}

}  // namespace

std::vector<methods::Claim> closing() {
  return {
      claim("closing.cosine", "a symmetric motion has $X = q cos(phi)$", greatest_distance),
      claim("closing.sine", "and $(1 + cos(pi/omega)) omega q sin(phi) = -f sin(pi/omega)$", sine),
      claim("closing.amplitude", "$X^2 = q^2 - (f sin(pi/omega)/(omega (1 + cos(pi/omega))))^2$", amplitudes),
      claim("closing.lag", "the lag, without $q$", lag),
      claim("closing.sufficient", "these two equations give the symmetric motion back", sufficient,
            methods::Origin::converse),
      claim("closing.third", "at $omega = 1/3$ only a motion without friction is symmetric", third,
            methods::Origin::new_result),
      claim("closing.frictionless", "without friction, $X^2 = q^2$", frictionless)};
}

}  // namespace den_hartog
