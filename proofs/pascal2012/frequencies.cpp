// (39) has solutions for all 0 < chi < 1 and eta > 0: what is proved for all 0 < omega_1 < 1 < omega_2 is
// proved for all of them. The quantities of (3), and the unit of time.
#include <algorithm>

#include "proofs/kernel/theorem.hpp"
#include "proofs/methods/derivation.hpp"
#include "proofs/methods/implications.hpp"
#include "proofs/methods/prover.hpp"
#include "proofs/methods/reading.hpp"
#include "proofs/orbits/all_zeros.hpp"
#include "proofs/pascal2012/claims.hpp"
#include "proofs/pascal2012/examples/example_orbit.hpp"
#include "proofs/symbols/vocabulary.hpp"
#include "proofs/tactics/tactics.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace kernel;
using namespace tactics;
using kernel::Multiple;
using kernel::Positive;

namespace {

const Variable chi{"chi"}, eta{"eta"}, root{"r"}, omega1{"omega1"}, omega2{"omega2"}, k1{"k1"}, k2{"k2"},
    m1{"m1"}, Omega{"Omega"}, other{"Omega'"};

// A number x with 0 ≤ x and x² = a, 0 < a; and the theorem that there is one.
struct Root {
  Variable name;
  Theorem existence, not_negative, square;
};
Root root_of(const Variable& name, const Term& a, const Theorem& positive) {
  const Theorem existence =
      detach(Theorem::square_root(a), Theorem::order(at_most(0, a), {Positive{{positive}}}));
  const Theorem here = Theorem::assume(opened(existence.conclusion(), name));
  return {name, existence, part(here, 0), part(here, 1)};
}

Term squares_less_one() {
  return power(omega1, 2) + power(omega2, 2) - 1;
}
Term product_of_squares() {
  return power(omega1, 2) * power(omega2, 2);
}
Domain domain() {
  return {above(0, omega1), below(omega1, 1), above(1, omega2)};
}

// What the model's chi and eta are, from omega1² + omega2² - 1 = chi eta and omega1² omega2² = chi eta (1 -
// chi), and the domain.
Theorem of_model(const Term& at_chi, const Term& at_eta, const Theorem& of_sum, const Theorem& of_product) {
  const Term D = squares_less_one(), W = product_of_squares(), product = at_chi * at_eta;
  Reader read;
  const auto is = [&](const symbols::Term& symbol, const Term& value, const std::vector<Multiple>& because) {
    const Formula meant = equal(read(symbol), value);
    return nonzero(Theorem::combination(meant, because, openings({meant}).all()), domain());
  };
  return both({is(symbols::vocabulary::chi, at_chi, {{of_sum, (1 - at_chi) / D}, {of_product, -1 / D}}),
               is(symbols::vocabulary::eta, at_eta,
                  {{of_sum, (D + product - at_eta) / (D - W)}, {of_product, at_eta / (D - W)}})});
}

// The frequencies at chi, eta, as the roots of s⁴ - (1 + chi eta) s² + chi eta (1 - chi): their squares are
// half of 1 + chi eta ∓ r, r² the discriminant. {0 < chi, chi < 1, 0 < eta} ⊢ there are 0 < omega1 < 1 <
// omega2 of which chi and eta are what the model has.
Theorem frequencies_exist() {
  const Theorem chi_positive = above(0, chi), chi_below = below(chi, 1), eta_positive = above(0, eta);
  const Term product = Term(chi) * eta, sum = 1 + product, rest = 1 - product;
  const Term last = product * (1 - Term(chi)), discriminant = power(sum, 2) - 4 * last;
  const Positive apart{{chi_positive, chi_positive, eta_positive}, 4};  // the discriminant less rest²
  const Root r =
      root_of(root, discriminant, Theorem::order(less(0, discriminant), {apart, Positive{{}, 1, rest}}));

  // |1 - chi eta| < r < 1 + chi eta.
  const auto below_r = [&](const Term& a) {
    return below_by_squares(Theorem::order(less(power(a, 2), power(root, 2)), {apart}, {{r.square}}),
                            r.not_negative, a, root);
  };
  const Theorem above_rest = below_r(rest), above_minus_rest = below_r(-rest);
  const Theorem sum_positive =
      Theorem::order(at_most(0, sum), {Positive{{}}, Positive{{chi_positive, eta_positive}}});
  const Theorem below_sum = below_by_squares(
      Theorem::order(less(power(root, 2), power(sum, 2)),
                     {Positive{{chi_positive, eta_positive, chi_below}, 4}}, {{r.square, -1}}),
      sum_positive, root, sum);

  const Rational half(1, 2);
  const Term first = Term(half) * (sum - root), second = Term(half) * (sum + root);
  const Theorem first_positive = Theorem::order(less(0, first), {Positive{{below_sum}, half}});
  const Theorem first_below = Theorem::order(less(first, 1), {Positive{{above_minus_rest}, half}});
  const Theorem second_above = Theorem::order(less(1, second), {Positive{{above_rest}, half}});
  const Root x = root_of(omega1, first, first_positive),
             y = root_of(omega2, second,
                         Theorem::order(less(0, second), {Positive{{second_above}}, Positive{{}}}));
  const Theorem one = Theorem::order(at_most(0, 1), {Positive{{}}});
  const Theorem x_positive = below_by_squares(
      Theorem::order(less(power(0, 2), power(omega1, 2)), {Positive{{first_positive}}}, {{x.square}}),
      x.not_negative, 0, omega1);
  const Theorem x_below = below_by_squares(
      Theorem::order(less(power(omega1, 2), power(1, 2)), {Positive{{first_below}}}, {{x.square, -1}}), one,
      omega1, 1);
  const Theorem y_above = below_by_squares(
      Theorem::order(less(power(1, 2), power(omega2, 2)), {Positive{{second_above}}}, {{y.square}}),
      y.not_negative, 1, omega2);

  // By Vieta.
  const Theorem of_sum = Theorem::combination(equal(squares_less_one(), product), {{x.square}, {y.square}});
  const Theorem of_product = Theorem::combination(
      equal(product_of_squares(), last),
      {{x.square, power(omega2, 2)}, {y.square, first}, {r.square, Term(Rational(-1, 4))}});
  const Theorem data = cut_all({x_positive, x_below, y_above}, of_model(chi, eta, of_sum, of_product));
  const Theorem known = both({x_positive, x_below, y_above, part(data, 0), part(data, 1)});
  Theorem result = there_are({omega1, omega2}, known);
  for (const Root& number : {y, x, r}) {
    result = Theorem::choose(number.existence, number.name, result);
  }
  return result;
}

// Theorems of others, with the frequencies that chi and eta have.
Outcome said_of_data(Prover& prover, const Claim&) {
  static const std::vector<std::string> ids{"33.V",        "37.sharp",  "A5.theorem",
                                            "A5.symmetry", "A5.unique", "A5.longer"};
  Outcome outcome{.verdict = Verdict::proved(),
                  .route = "what is proved for all frequencies is so for those of 39.frequencies",
                  .uses = {ids.begin(), ids.end()},
                  .by_kernel = true};
  outcome.uses.insert("39.frequencies");
  try {
    const Theorem exist = prover.theorem("39.frequencies");
    for (const std::string& id : ids) {
      const Theorem closed = closed_but_frequencies(prover.theorem(id));
      outcome.theorems.push_back(
          orbits::orbit_with(exist, [&](const Theorem& there) { return cut_all(parts_of(there), closed); }));
    }
    return outcome;
  } catch (const KernelError& error) {
    return {.verdict = Verdict::undecided(error.what())};
  }
}

// ---- The quantities of (3).

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

Theorem closed_but_frequencies(Theorem theorem) {
  const auto is_frequency = [](const Variable& x) { return x == omega1 || x == omega2; };
  std::vector<Formula> supposed;
  for (const Formula& one : theorem.hypotheses()) {
    if (!std::ranges::all_of(one.variables(), is_frequency)) {
      supposed.push_back(one);
    }
  }
  const Formula together = all(supposed);
  theorem = Theorem::discharge(cut_all(parts_of(Theorem::assume(together)), theorem), together);
  const Variables variables = theorem.conclusion().variables();
  for (const Variable& one : variables) {
    if (!is_frequency(one)) {
      theorem = Theorem::generalize(theorem, one);
    }
  }
  return theorem;
}

Theorem at_frequencies(const Rational& at_chi, const Rational& at_eta,
                       const std::function<Theorem(const orbits::Ranges&)>& more) {
  if (at_chi <= 0 || at_chi >= 1 || at_eta <= 0) {
    throw KernelError("chi is between 0 and 1, and eta is positive");
  }
  const WorkingPrecision precision(128);
  const model::Modes<Ball> modes = model::modes<Ball>(Ball(at_chi), Ball(at_eta));
  const Rational radius(1, 1L << 44);
  const std::vector<Variable> unknowns{omega1, omega2};
  Box box;
  orbits::Ranges ranges;
  for (const Ball& value : {modes.omega1, modes.omega2}) {
    const Rational centre = orbits::near(value);
    ranges.emplace(unknowns.at(box.size()), Interval{centre - radius, centre + radius});
    box.emplace_back(centre - radius, centre + radius);
  }
  const Rational product = at_chi * at_eta, last = product * (1 - at_chi);
  const std::vector<Term> equations{squares_less_one() - Term(product), product_of_squares() - Term(last)};
  const auto from = [&](std::size_t i, const Formula& equation) {
    return Theorem::combination(equation, {{Theorem::assume(equal(equations[i], 0))}});
  };
  const Theorem data = of_model(at_chi, at_eta, from(0, equal(squares_less_one(), product)),
                                from(1, equal(product_of_squares(), last)));
  std::vector<Theorem> parts;
  for (const Theorem& side : domain()) {
    const Formula& inequality = side.conclusion();
    const Variable& which = inequality.variables().contains(omega1) ? omega1 : omega2;
    parts.push_back(Theorem::sign(inequality, {{which, ranges.at(which)}}));
  }
  const Theorem here = cut_all(parts, data), of_chi = part(here, 0), of_eta = part(here, 1);
  parts.insert(parts.end(), {of_chi, of_eta, cut_all({of_chi, of_eta}, more(ranges))});
  const Theorem known = both(parts);
  return orbits::with_zero(there_are(unknowns, known), unknowns, equations, box);
}

Proofs frequencies() {
  return {
      {"39.frequencies", by_theorem("their squares are half of $1 + chi eta$ less and more the root of the "
                                    "discriminant, which lies between $|1 - chi eta|$ and $1 + chi eta$",
                                    frequencies_exist)},
      {"39.data", said_of_data},
      {"3.exist",
       [](methods::Prover& prover, const methods::Claim&) {
         return proved_by({.route = "39.frequencies at these ratios, and a square root"}, {"39.frequencies"},
                          [&] { return quantities_exist(prover.theorem("39.frequencies")); });
       }},
      {"3.Omega",
       by_theorem("a positive number has a root, and positive numbers are ordered as their squares",
                  one_unit)},
      {"3.rates", by_theorem("the chain rule, twice", rates)}};
}

}  // namespace stickslip::proofs::pascal2012
