// Section 5, (21)-(23): the closing conditions as linear equations, and what is left for tau and tau_1.
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/overshooting.hpp"
#include "proofs/symbols/meaning.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace overshooting;

using Assumptions = std::vector<Assumption>;

std::string id_of(int equation_number, char letter) {
  return std::to_string(46 + equation_number) + "." + letter;
}

// What equation i of (21) adds to the closing gap i, times a factor: (a_i - its value) z10 + …
std::vector<Multiple> coefficients_of(int i, const Term& factor) {
  return {{from(id_of(i, 'a')), 0, factor * z10},
          {from(id_of(i, 'b')), 0, factor * z20},
          {from(id_of(i, 'c')), 0, factor * zdot10},
          {from(id_of(i, 'd')), 0, factor}};
}

std::vector<Multiple> sum_of(std::vector<Multiple> a, const std::vector<Multiple>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string line(int i) {
  return "21." + std::to_string(i);
}

Assumption assumed_line(int i) {
  return {line(i), equation(closing_form(i), 0)};
}

// The gap i by equation i of (21).
std::vector<Multiple> gap_from_line(int i, const Term& factor) {
  return sum_of({{assuming(line(i)), 0, factor}}, coefficients_of(i, -factor));
}

std::vector<Claim> linear_equations() {
  std::vector<std::vector<Multiple>> forward;
  std::vector<Multiple> state{{from("20.slips")}};
  std::vector<Statement> lines;
  for (int i = 1; i <= 5; ++i) {
    lines.push_back(equation(closing_form(i), 0));
    const Multiple gap = i <= 3   ? Multiple{from("21.gap"), 0, row(i)}
                         : i == 4 ? Multiple{from("18.speed")}
                                  : Multiple{from("19.speed")};
    forward.push_back(sum_of({gap}, coefficients_of(i, 1)));
    if (i != 4) {
      state = sum_of(state, gap_from_line(i, place(i == 5 ? 4 : i)));
    }
  }
  const Term speed_C = scalar("zdot2C");
  Assumptions slips_and_lines = both_slips;
  slips_and_lines.insert(slips_and_lines.end(), {starts_with_belt, assumed_line(1), assumed_line(2),
                                                 assumed_line(3), assumed_line(4), assumed_line(5)});
  return {
      {.id = "21",
       .kind = Kind::step,
       .printed = lines,
       .words = "five linear equations for $z_1(0)$, $z_2(0)$, $z_1'(0)$: three components of (20), and $z2' "
                "= V$ at $tau$ (18) and at $tau + tau_1$ (19); $z2' = V$ at 0 is put in",
       .assumptions = whole_and({starts_with_belt, meets_belt, lands_on_belt}),
       .prove = by_combination(forward)},
      {.id = "21.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {equation(ZC, Gamma(-T) * Z0), equation(scalar("zdot2B"), V), equation(speed_C, V)},
       .words = "conversely the five equations give the state at $tau + tau_1$ that closes the motion, all "
                "four components of (20), and $z2' = V$ at $tau$ and $tau + tau_1$",
       .assumptions = slips_and_lines,
       .prove = by_combination({state, sum_of({{from("56.B"), 0, row(4)}}, gap_from_line(4, 1)),
                                sum_of({{from("20.slips"), 0, row(4)}}, gap_from_line(5, 1))})},
  };
}

// The cofactor of the coefficient in equation j, column k of (a, b, c).
Term cofactor(int j, int k) {
  const std::string columns = "abc";
  const auto at = [&](int row_step, int column_step) {
    return coefficient(columns[static_cast<std::size_t>((k - 1 + column_step) % 3)],
                       (j - 1 + row_step) % 3 + 1);
  };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}

// Delta times unknown k, less Delta_k, is this sum of the equations; times a factor.
std::vector<Multiple> by_cramer(int k, const Term& factor) {
  std::vector<Multiple> result;
  for (int j = 1; j <= 3; ++j) {
    result.push_back({assuming(line(j)), 0, factor * cofactor(j, k)});
  }
  return result;
}

Statement compatible(int i) {
  return equation(coefficient('a', i) * Delta1 + coefficient('b', i) * Delta2 + coefficient('c', i) * Delta3 +
                      coefficient('d', i) * Delta,
                  0);
}

// F_k from equation k + 3 and, by Cramer's rule, the first three.
std::vector<Multiple> necessary(int i) {
  std::vector<Multiple> result{{assuming(line(i)), 0, Delta}};
  for (int k = 1; k <= 3; ++k) {
    result = sum_of(result, by_cramer(k, -coefficient("abc"[k - 1], i)));
  }
  return result;
}

std::vector<Claim> solution() {
  const Assumption regular{"22.regular", {Delta, 0, Relation::not_equal}};
  const Assumptions solved{{"22.z10", equation(z10, Delta1 / Delta)},
                           {"22.z20", equation(z20, Delta2 / Delta)},
                           {"22.zdot10", equation(zdot10, Delta3 / Delta)},
                           regular};
  Assumptions compatible_too = solved;
  compatible_too.push_back({"23.1", compatible(4)});
  compatible_too.push_back({"23.2", compatible(5)});
  return {
      {.id = "22.Delta",
       .kind = Kind::definition,
       .printed = {equation(Delta, determinant_of_columns({"a", "b", "c"})),
                   equation(Delta1, determinant_of_columns({"-d", "b", "c"})),
                   equation(Delta2, determinant_of_columns({"d", "a", "c"})),
                   equation(Delta3, determinant_of_columns({"d", "b", "a"}))},
       .words = "the determinants of the first three equations",
       .prove = by_normal_form()},
      {.id = "22",
       .kind = Kind::step,
       .printed = {equation(z10, Delta1 / Delta), equation(z20, Delta2 / Delta),
                   equation(zdot10, Delta3 / Delta)},
       .words = "Cramer's rule for the first three equations",
       .assumptions = {assumed_line(1), assumed_line(2), assumed_line(3), regular},
       .prove = by_combination({by_cramer(1, 1 / Delta), by_cramer(2, 1 / Delta), by_cramer(3, 1 / Delta)})},
      {.id = "22.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {equation(closing_form(1), 0), equation(closing_form(2), 0), equation(closing_form(3), 0)},
       .words = "conversely (22) solves them",
       .assumptions = solved,
       .prove = by_normal_form()},
      {.id = "23",
       .kind = Kind::step,
       .printed = {compatible(4), compatible(5)},
       .words = "$F_1 = 0$ and $F_2 = 0$ are necessary for all five equations to have a solution, also where "
                "$Delta$ is zero",
       .assumptions = {assumed_line(1), assumed_line(2), assumed_line(3), assumed_line(4), assumed_line(5)},
       .prove = by_combination({necessary(4), necessary(5)})},
      {.id = "23.back",
       .kind = Kind::step,
       .origin = Origin::converse,
       .printed = {equation(closing_form(4), 0), equation(closing_form(5), 0)},
       .words = "conversely (22) and (23) solve the other two equations, if $Delta$ is not zero",
       .assumptions = compatible_too,
       .prove = by_combination({{{assuming("23.1"), 0, 1 / Delta}}, {{assuming("23.2"), 0, 1 / Delta}}})},
  };
}

// Where (22) and (23) say nothing.
std::vector<Claim> exceptions() {
  std::vector<Premise> coefficients;
  for (int i = 1; i <= 3; ++i) {
    for (const char letter : {'a', 'b', 'c'}) {
      coefficients.push_back(from(id_of(i, letter)));
    }
  }
  const Term half = (tau + tau1) / 2;
  const Term gap = 2 * omega1 * even_determinant / (lambda1 - lambda2);
  const Term sin2 = sin(omega2 * half), cos2 = omega2 * cos(omega2 * half);
  return {
      {.id = "22.square",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(determinant_of_columns({"a", "b", "c"}),
                            -8 * power(even_determinant, 2) / power(lambda1 - lambda2, 2))},
       .words = "$Delta$ depends on $tau + tau_1$ alone and is a negative square: it touches zero and never "
                "changes sign",
       .assumptions = {starts_with_belt},
       .prove = by_putting_in(coefficients)},
      {.id = "22.null",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation((H(tau + tau1) - Gamma(-T)) * even_state,
                            gap * column({sin2, lambda2 * sin2, cos2, lambda2 * cos2}))},
       .words = "where that square is zero, a state without $z2'$, even about the middle of the stick, "
                "solves equations 1, 2, 3 and 5 of (21) without their $d_i$: $F_2$ is zero along the whole "
                "line $tau + tau_1$ = constant, and zeros of $F_1$ on it need not be orbits (23.spurious)",
       .prove = by_normal_form()},
      {.id = "23.tau",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(row(4) * (H(0) * (Z0 - F0) + F(0)) - V, 0)},
       .words = "at $tau = 0$ equation 4 of (21) is empty, $F_1 = 0$ for every $tau_1$: zeros of (23) there "
                "are no orbits",
       .assumptions = {starts_with_belt},
       .prove = by_normal_form()},
      {.id = "23.tau1",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(row(4) * (H(tau) * (Z0 - F0) + 2 * L(0) * d0 + F(tau)), row(4) * after_slip)},
       .words = "at $tau_1 = 0$ equations 4 and 5 of (21) are one, $F_1 = F_2$: zeros of (23) there are "
                "motions without an overshoot",
       .prove = by_normal_form()},
  };
}

}  // namespace

std::vector<Claim> section5_linear() {
  return joined({linear_equations(), solution(), exceptions()});
}

}  // namespace stickslip::proofs::pascal2012
