// Appendix 3: the twenty coefficients (47)-(51), each against the one that the flows give.
#include "model/appendix3.hpp"

#include <fmt/format.h>

#include "proofs/methods/derivation.hpp"
#include "proofs/pascal2012/overshooting.hpp"
#include "proofs/pascal2012/paper.hpp"
#include "proofs/tactics/model_terms.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

namespace {

using namespace overshooting;

const Entries H_{"H"}, h_{"h"}, Ht{"Htilde"}, G{"Gamma"};

// One coefficient of equation i, "47.a": printed as `value`.
Claim printed_coefficient(char letter, int equation_number, const Term& value) {
  const std::map<char, std::string> names{
      {'a', "$z_1(0)$"}, {'b', "$z_2(0)$"}, {'c', "$z_1'(0)$"}, {'d', "no unknown"}};
  static const std::array<const char *, 5> said{
      "$z_1$ at $tau + tau_1$ of slip and overshoot less that of the stick",
      "$z_2$ at $tau + tau_1$ of slip and overshoot less that of the stick",
      "$z_1'$ at $tau + tau_1$ of slip and overshoot less that of the stick", "$z_2'(tau) - V$",
      "$z_2'(tau + tau_1) - V$"};
  return {.id = fmt::format("{}.{}", 46 + equation_number, letter),
          .kind = Kind::step,
          .printed = {equation(coefficient(letter, equation_number), value)},
          .words = fmt::format("what stands beside {} in {}", names.at(letter),
                               said.at(static_cast<std::size_t>(equation_number - 1))),
          .prove = by_normal_form()};
}

// What -F_0 contributes: -(x1 q1 + x2 q2) cos(phi), and (x3 q1 + x4 q2) sin(phi) with omega before or behind.
Term place_part(const Term& x1, const Term& x2) {
  return -((x1 * q1 + x2 * q2) * cos(phi));
}
Term before(const Term& x3, const Term& x4) {
  return omega * (x3 * q1 + x4 * q2) * sin(phi);
}
Term behind(const Term& x3, const Term& x4) {
  return (x3 * q1 + x4 * q2) * omega * sin(phi);
}

Term matrix_of(const Entries& entry) {
  std::vector<Term> all;
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) {
      all.push_back(entry(i, j));
    }
  }
  return block(4, all);
}

std::vector<Claim> components() {
  return {
      printed_coefficient('a', 1, Ht(1, 1) - G(1, 1)),
      printed_coefficient('b', 1, Ht(1, 2) - G(1, 2)),
      printed_coefficient('c', 1, Ht(1, 3) - G(1, 3)),
      printed_coefficient('d', 1,
                          place_part(Ht(1, 1), Ht(1, 2)) + before(Ht(1, 3), Ht(1, 4)) + q1 * cos(phiC) +
                              2 * (h_(1, 1) - 1) * d01 + 2 * h_(1, 2) * d02 + (Ht(1, 4) + G(1, 4)) * V),
      printed_coefficient('a', 2, Ht(2, 1)),
      printed_coefficient('b', 2, Ht(2, 2) - 1),
      printed_coefficient('c', 2, Ht(2, 3)),
      printed_coefficient('d', 2,
                          place_part(Ht(2, 1), Ht(2, 2)) + before(Ht(2, 3), Ht(2, 4)) + q2 * cos(phiC) +
                              2 * h_(2, 1) * d01 + 2 * (h_(2, 2) - 1) * d02 + (Ht(2, 4) + T) * V),
      printed_coefficient('a', 3, Ht(3, 1) + G(3, 1)),
      printed_coefficient('b', 3, Ht(3, 2) + G(3, 2)),
      printed_coefficient('c', 3, Ht(1, 1) - G(1, 1)),
      printed_coefficient('d', 3,
                          place_part(Ht(3, 1), Ht(3, 2)) + before(Ht(1, 1), Ht(1, 2)) -
                              omega * q1 * sin(phiC) + 2 * h_(3, 1) * d01 + 2 * h_(3, 2) * d02 +
                              (Ht(1, 2) - G(1, 2)) * V),
  };
}

std::vector<Claim> speeds() {
  return {
      printed_coefficient('a', 4, H_(4, 1)),
      printed_coefficient('b', 4, H_(4, 2)),
      printed_coefficient('c', 4, H_(2, 1)),
      printed_coefficient('d', 4,
                          (H_(2, 2) - 1) * V - q2 * omega * sin(phiB) + place_part(H_(4, 1), H_(4, 2)) +
                              behind(H_(2, 1), H_(2, 2))),
      printed_coefficient('a', 5, Ht(4, 1)),
      printed_coefficient('b', 5, Ht(4, 2)),
      printed_coefficient('c', 5, Ht(2, 1)),
      printed_coefficient('d', 5,
                          (Ht(2, 2) - 1) * V - q2 * omega * sin(phiC) + place_part(Ht(4, 1), Ht(4, 2)) +
                              behind(Ht(2, 1), Ht(2, 2)) + 2 * (h_(4, 1) * d01 + h_(4, 2) * d02)),
  };
}

// model/appendix3.hpp says the same as the twenty claims.
std::vector<Equal> computed(Derivation& derivation) {
  using tactics::Symbolic;
  const auto s = [](const char * name) { return Symbolic(kernel::Variable{name}); };
  const auto letters = model::appendix3_letters<Symbolic>(
      s("chi"), {s("omega1"), s("omega2"), s("lambda1"), s("lambda2")}, {s("q1"), s("q2")},
      {s("d01"), s("d02")}, s("omega"), s("V"), s("phi"), s("tau"), s("tau1"), s("T"));
  const auto k = model::appendix3<Symbolic>(letters, model::Reading::printed);
  const std::map<char, decltype(k.a)> columns{{'a', k.a}, {'b', k.b}, {'c', k.c}, {'d', k.d}};
  std::vector<Equal> result;
  for (const std::vector<Claim>& claims : {components(), speeds()}) {
    for (const Claim& claim : claims) {
      const Statement& printed = claim.printed.front();
      const std::string& name = printed.left.name();  // "a_1"
      const Symbolic& value = columns.at(name.front())[static_cast<std::size_t>(name.back() - '1')];
      result.push_back({value.term, derivation.read(printed.right)});
    }
  }
  return result;
}

Claim formulas() {
  return {.id = "51.formulas",
          .kind = Kind::identity,
          .origin = Origin::auxiliary,
          .words = "the program computes with the printed coefficients, but for the sign in $c_1$",
          .prove = [](Prover& prover, const Claim& claim) {
            return compared(
                "the formulas that the program computes with and the printed ones have the same normal form",
                prover, claim, computed);
          }};
}

}  // namespace

std::vector<Claim> appendix3() {
  return joined({components(),
                 speeds(),
                 {{.id = "51.phi",
                   .kind = Kind::definition,
                   .printed = {equation(phiB, omega * tau + phi), equation(phiC, phiB + omega * tau1)},
                   .words = "the load's phase at $tau$ and at $tau + tau_1$",
                   .prove = by_normal_form()},
                  {.id = "51.entries",
                   .kind = Kind::definition,
                   .printed = {equation(matrix_of(H_), H(tau)), equation(matrix_of(h_), H(tau1)),
                               equation(matrix_of(Ht), H(tau + tau1))},
                   .words = "the entries of $H$ at $tau$, $tau_1$ and $tau + tau_1$",
                   .prove = by_normal_form()},
                  formulas()}});
}

}  // namespace stickslip::proofs::pascal2012
