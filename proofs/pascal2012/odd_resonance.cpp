// Where a natural frequency is an odd multiple of the load's, no motion of two slips of half a period each
// closes: half a period later the mode is the opposite one, and the friction has moved its place of rest.
#include "proofs/methods/derivation.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;
using kernel::Formula;
using kernel::Theorem;

namespace {

using namespace symbols::vocabulary;

const Term first_row = block(1, {1, 0}), second_row = block(1, {0, 1});
// The two terms of the first of (30) in modal coordinates.
const Term modal_speed = inverse(Lambda) * (zdotB - Q * omega * sin(phi)), modal_rest = inverse(Lambda) * d0;

struct Mode {
  Term frequency, row;
  int sign;  // of its place of rest
};
Term turned(const Mode& mode) {
  return 1 + cos(mode.frequency * tau);
}

// 1 + cos(omega_j tau) = 0 gives 0 < 0: then sin(omega_j tau) = 0, and by 31.modes twice the mode's place of
// rest, which 31.rest gives a sign, is zero.
Theorem absurd(Derivation& derivation, const Mode& mode) {
  const auto read = [&](const Term& term) { return derivation.read(term); };
  const kernel::Term s = read(sin(mode.frequency * tau)), c = read(cos(mode.frequency * tau));
  const Theorem opposite = Theorem::assume(equal(read(turned(mode)), 0));
  const Theorem square = Theorem::combination(equal(s * s, 0), {{opposite, 1 - c}});
  const Theorem level = Theorem::consequence({square, tactics::zero_product(s, s)}, equal(s, 0));
  const Term other = mode.sign > 0 ? omega2 : omega1;
  const Term rest = us / (1 - chi) / (power(omega2, 2) - power(omega1, 2)) * power(other, 2);
  const Rational sign(mode.sign);
  return derivation.order(kernel::less(0, 0), {kernel::Positive{{derivation.positive(read(rest))}, 2}},
                          {{derivation.premise(from("31.modes"), mode.sign > 0 ? 0 : 1), sign},
                           {level, read(-mode.sign / mode.frequency * (mode.row * modal_speed))},
                           {opposite, read(-mode.sign * (mode.row * modal_rest))},
                           {derivation.premise(from("31.rest")), read(2 * mode.sign * mode.row)}});
}

Theorem never_closes(Derivation& derivation, std::size_t) {
  const Mode first{omega1, first_row, 1}, second{omega2, second_row, -1};
  std::vector<Theorem> cases{
      derivation.premise(assuming("31.odd")),
      tactics::zero_product(derivation.read(turned(first)), derivation.read(turned(second)))};
  for (const Mode& mode : {first, second}) {
    cases.push_back(Theorem::discharge(absurd(derivation, mode), equal(derivation.read(turned(mode)), 0)));
  }
  return Theorem::consequence(cases, kernel::less(0, 0));
}

}  // namespace

Proofs odd_resonance() {
  return {{"31.odd", by_kernel("31.modes and 31.rest, in each of both cases", never_closes)}};
}

}  // namespace stickslip::proofs::pascal2012
