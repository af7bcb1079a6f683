// Decides identities for all parameters, by normal form: one that holds and one that does not.
#include <iostream>

#include <stickslip/symbolic/algebra/decide.hpp>
#include <stickslip/symbolic/algebra/symbols.hpp>
#include <stickslip/symbolic/typeset/latex.hpp>

int main() {
  using namespace stickslip::symbolic;
  const GiNaC::ex omega1 = algebra::symbol("omega1"), omega2 = algebra::symbol("omega2");
  const GiNaC::ex chi = algebra::symbol("chi"), eta = algebra::symbol("eta");

  // The product of the squared natural frequencies of (39).
  const auto decide = [&](const GiNaC::ex& product) {
    const algebra::Decision decision = algebra::decide_equal(pow(omega1, 2) * pow(omega2, 2), product);
    std::cout << typeset::text(product) << ": " << to_string(decision.verdict.truth) << '\n';
    if (decision.verdict.witness) {
      for (const stickslip::Coordinate& coordinate : decision.verdict.witness->point) {
        std::cout << "  at " << coordinate.name << " = " << coordinate.value << '\n';
      }
    }
  };
  decide(chi * eta * (1 - chi));
  decide(chi * eta);
}
