// LaTeX of a derived expression and of one's own.
#include <iostream>

#include <stickslip/symbolic/algebra/symbols.hpp>
#include <stickslip/symbolic/objects/objects.hpp>
#include <stickslip/symbolic/typeset/latex.hpp>

int main() {
  using namespace stickslip::symbolic;
  std::cout << objects::displayed(*objects::find_object("H2"), objects::Unknowns::chi);

  const GiNaC::ex omega = algebra::symbol("omega"), tau = algebra::symbol("tau");
  std::cout << typeset::latex(sin(omega * tau / 2) / (1 - pow(omega, 2))) << '\n';
}
