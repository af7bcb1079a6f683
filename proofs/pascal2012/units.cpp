// The quantities of (3), and the unit of time.
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/example_orbit.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace kernel;
using namespace tactics;
using kernel::Positive;
using methods::by_theorem;

namespace {

const Variable k1{"k1"}, k2{"k2"}, m1{"m1"}, Omega{"Omega"}, other{"Omega'"}, root{"r"};

Formula is_unit(const Variable& x) {
  return all({less(0, x), equal(power(x, 2), (Term(k1) + k2) / m1)});
}

// x = y, where both are units: if one were below the other, so would be its square.
Theorem same() {
  const Theorem x = Theorem::assume(is_unit(Omega)), y = Theorem::assume(is_unit(other));
  const auto not_below = [](const Theorem& a, const Theorem& b, const Variable& low, const Variable& high) {
    const Theorem wrong = Theorem::assume(less(low, high));
    const Theorem squares =
        Theorem::order(less(0, 0), {Positive{{wrong, wrong}}, Positive{{part(a, 0), wrong}, 2}},
                       {{part(a, 1)}, {part(b, 1), -1}});
    return Theorem::discharge(squares, wrong.conclusion());
  };
  return Theorem::consequence(
      {not_below(x, y, Omega, other), not_below(y, x, other, Omega), Theorem::trichotomy(Omega, other),
       Theorem::trichotomy(0, 0), Theorem::reflexive(0)},
      equal(Omega, other));
}

// {0 < k1, 0 < k2, 0 < m1} ⊢ exactly one Omega > 0 has Omega² = (k1 + k2)/m1.
Theorem one_unit() {
  const Theorem stiff = Theorem::order(less(0, Term(k1) + k2),
                                       {Positive{{above(0, k1)}}, Positive{{above(0, k2)}}}),
                inverse_mass = inverse_is_positive(above(0, m1)), heavy = different(above(0, m1));
  const Term square = (Term(k1) + k2) / m1;
  const Theorem positive =
      Theorem::cut(heavy, Theorem::order(less(0, square), {Positive{{stiff, inverse_mass}}}));
  const Theorem there =
      detach(Theorem::square_root(square),
             Theorem::cut(heavy, Theorem::order(at_most(0, square), {Positive{{positive}}})));
  const Theorem chosen = Theorem::assume(opened(there.conclusion(), Omega));
  const Theorem squares = Theorem::cut(
      heavy, Theorem::order(less(power(0, 2), power(Omega, 2)), {Positive{{positive}}}, {{part(chosen, 1)}}));
  const Theorem unit = both({below_by_squares(squares, part(chosen, 0), 0, Omega), part(chosen, 1)});
  const Theorem exists_one =
      Theorem::choose(there, Omega, Theorem::witness(unit, exists(Omega, is_unit(Omega)), Omega));
  const Formula two = all({is_unit(Omega), is_unit(other)});
  const Theorem equal_ones = cut_all(parts_of(Theorem::assume(two)), Theorem::cut(heavy, same()));
  return both({exists_one,
               Theorem::generalize(Theorem::generalize(Theorem::discharge(equal_ones, two), other), Omega)});
}

// For all functions x, v, a of t: where x' = v and v' = a, the functions of time s with t = Omega s have the
// derivatives Omega v and Omega² a.
Theorem rates() {
  const Variable x{"x", function_of_time()}, v{"v", function_of_time()}, a{"a", function_of_time()}, s{"s"},
      t{"t"};
  const auto is_rate = [&](const Variable& of, const Variable& rate) {
    return for_all(t, derivative(of, t, apply(rate, t)));
  };
  const Term then = Term(Omega) * s;
  // d/ds (factor f(Omega s)) = factor Omega f'(Omega s).
  const auto by_chain_rule = [&](const Variable& f, const Variable& rate, const Term& factor) {
    const auto times = [&](const Term& term) { return factor == Term(1) ? term : factor * term; };
    const Theorem inner = Theorem::specialize(Theorem::assume(is_rate(f, rate)), then);
    const Theorem slope = Theorem::differentiate(lambda(s, times(apply(f, then))), s, {inner});
    const Term value = times(Term(Omega)) * apply(rate, then);
    return tactics::by_rewriting(slope, Theorem::combination(equal(slope.conclusion().parts()[2], value)));
  };
  const Theorem speed = by_chain_rule(x, v, 1), acceleration = by_chain_rule(v, a, Omega);
  const Theorem here = Theorem::generalize(both({speed, acceleration}), s);
  return Theorem::discharge(Theorem::discharge(here, is_rate(v, a)), is_rate(x, v));
}

// What (3) names exists: the frequencies that give these chi and eta, by 39.frequencies, and Omega.
Theorem quantities_exist(const Theorem& frequencies) {
  const Variable m2{"m2"};
  const Term k = Term(k1) + k2;
  const auto positive = [](const Term& a, const std::vector<Positive>& because) {
    return Theorem::order(less(0, a), because);
  };
  const Theorem stiff1 = above(0, k1), stiff2 = above(0, k2), heavy1 = above(0, m1), heavy2 = above(0, m2),
                stiff = positive(k, {{{stiff1}}, {{stiff2}}}), by_k = inverse_is_positive(stiff),
                by_m1 = inverse_is_positive(heavy1), by_m2 = inverse_is_positive(heavy2);
  const Term ratio = k2 / k, masses = Term(m1) / m2, rate = k / m1;
  const Theorem exist = cut_all(
      {positive(ratio, {{{stiff2, by_k}}}), Theorem::order(less(ratio, 1), {Positive{{stiff1, by_k}}}),
       positive(masses, {{{heavy1, by_m2}}})},
      Theorem::instantiate(frequencies, {{{"chi"}, ratio}, {{"eta"}, masses}}));
  const Theorem scale =
      detach(Theorem::square_root(rate), Theorem::order(at_most(0, rate), {Positive{{stiff, by_m1}}}));
  return Theorem::cut(different(stiff), nonzero(both({exist, scale}), {heavy1, heavy2}));
}

}  // namespace

Proofs quantities() {
  return {{"3.exist",
           [](methods::Prover& prover, const methods::Claim&) {
             return proved_by({.route = "39.frequencies at these ratios, and a square root"},
                              {"39.frequencies"},
                              [&] { return quantities_exist(prover.theorem("39.frequencies")); });
           }},
          {"3.Omega",
           by_theorem("a positive number has a root, and positive numbers are ordered as their squares",
                      one_unit)},
          {"3.rates", by_theorem("the chain rule, twice", rates)}};
}

}  // namespace stickslip::proofs::pascal2012
