// Appendix 5 on a moving belt: off resonance, of two slips per period the one below the belt's velocity lasts
// longer than half a period. For with q = omega tau/2 A5.turn says omega (z2B - z20) cos(q) = 2 V sin(q),
// A5.falls says z2B - z20 < V tau, and sin(q) > q cos(q); so cos(q) >= 0 would give 2 V sin(q) <= 2 V q
// cos(q).
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/symbols/vocabulary.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;
using kernel::Multiple;
using kernel::Positive;
using kernel::Theorem;

namespace {

using namespace symbols::vocabulary;

const Term quarter = omega * tau / 2;

// q cos(q) < sin(q): f = sin(t) - t cos(t) has the derivative t sin(t), so f(q) - f(0) = c sin(c) q.
Theorem slope_of_chord(Derivation& derivation, std::size_t which) {
  const kernel::Variable t{"t"}, c{"c"};
  const kernel::Formula goal = derivation.printed(which);
  const kernel::Term q = derivation.read(s);
  const Theorem positive = derivation.premise(assuming("s.positive")),
                below_pi = derivation.premise(assuming("s.pi"));
  const kernel::Term f = kernel::lambda(t, kernel::sin(t) - t * kernel::cos(t));
  const Theorem slope = Theorem::differentiate(f, t);
  const Theorem same = derivation.combination(equal(slope.conclusion().parts()[2], t * kernel::sin(t)));
  const Theorem mean = Theorem::mean_value(
      Theorem::continuity(f, 0, q),
      tactics::for_every(t, kernel::between(0, t, q), tactics::by_rewriting(slope, same)), positive);
  const Theorem there = Theorem::assume(kernel::opened(mean.conclusion(), c));
  const Theorem inside = tactics::part(there, 0), c_positive = tactics::part(inside, 0);
  const Theorem c_below = derivation.order(kernel::less(c, kernel::pi()),
                                           {Positive{{tactics::part(inside, 1)}}, Positive{{below_pi}}});
  const Theorem sine = tactics::detach(Theorem::sine_is_positive(c), tactics::both({c_positive, c_below}));
  return Theorem::choose(
      mean, c,
      derivation.order(goal, {Positive{{positive, c_positive, sine}}}, {Multiple{tactics::part(there, 1)}}));
}

// Theta/2 < tau, as each of the other cases gives 0 < 0.
Theorem longer_than_half(Derivation& derivation, std::size_t which) {
  const kernel::Formula goal = derivation.printed(which), absurd = kernel::less(0, 0);
  const kernel::Term half_period = goal.parts()[0], slip = goal.parts()[1], w = derivation.read(omega),
                     q = derivation.read(quarter), turn = kernel::pi() / 2;
  const auto assumed = [&](const char * id) { return derivation.premise(assuming(id)); };
  const Theorem moves = assumed("A5.V.sign"), load = assumed("28.period"), both = assumed("56.tau1"),
                falls_short = derivation.premise(from("A5.falls")),
                balance = derivation.premise(from("A5.turn")), frequency = derivation.positive(w),
                started = derivation.follows(kernel::less(0, q)),
                half_turn = Theorem::sign(kernel::less(0, kernel::pi()));
  const Theorem ended = derivation.order(kernel::less(q, kernel::pi()),
                                         {Positive{{frequency, assumed("tau1.positive")}, Rational(1, 2)}},
                                         {Multiple{load, -w / 2}, Multiple{both, w / 2}});
  const Theorem chord =
      Theorem::cut(started, Theorem::cut(ended, derivation.premise(from("A5.tan").at("s", quarter))));
  // tau < Theta/2: q < pi/2, and cos(q) > 0.
  const kernel::Formula shorter = kernel::less(slip, half_period);
  const Theorem gap = derivation.order(kernel::less(0, turn - q),
                                       {Positive{{frequency, Theorem::assume(shorter)}, Rational(1, 2)}},
                                       {Multiple{load, -w / 4}});
  const Theorem within = derivation.order(kernel::less(turn - q, kernel::pi()),
                                          {Positive{{started}}, Positive{{half_turn}, Rational(1, 2)}});
  const Theorem cosine = derivation.order(
      kernel::less(0, kernel::cos(q)),
      {Positive{{tactics::detach(Theorem::sine_is_positive(turn - q), tactics::both({gap, within}))}}});
  const Theorem not_shorter = tactics::impossible(
      shorter,
      derivation.order(absurd, {Positive{{frequency, cosine, falls_short}}, Positive{{moves, chord}, 2}},
                       {Multiple{balance}}));
  // tau = Theta/2: q = pi/2, and A5.turn says 0 = 2 V.
  const kernel::Formula as_long = equal(half_period, slip);
  const Theorem quarter_turn = derivation.combination(
      equal(q, turn), {Multiple{Theorem::assume(as_long), -w / 2}, Multiple{load, w / 4}});
  const Theorem not_as_long = tactics::impossible(
      as_long, derivation.order(absurd, {Positive{{moves}, 2}},
                                {Multiple{tactics::by_rewriting(balance, quarter_turn)}}));
  return Theorem::consequence({not_shorter, not_as_long, Theorem::trichotomy(half_period, slip)}, goal);
}

}  // namespace

Proofs longer_slip() {
  return {
      {"A5.tan", by_kernel("mean value theorem", slope_of_chord)},
      {"A5.longer", by_kernel("each other case contradicts A5.turn, A5.falls and A5.tan", longer_than_half)}};
}

}  // namespace stickslip::proofs::pascal2012
