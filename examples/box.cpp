// An orbit for a whole range of stiffnesses: one proof for all members of the box.
#include <iostream>

#include <stickslip/numeric/orbits.hpp>

int main() {
  using namespace stickslip;
  numeric::OrbitQuestion question;
  question.family = &numeric::family_named("nonsticking");
  question.parameters = {.chi = parse_range("chi", "0.3+-1e-4"),
                         .eta = parse_range("eta", "4"),
                         .us = parse_range("us", "0.1"),
                         .V = parse_range("V", "0.1"),
                         .omega = parse_range("omega", "0.6"),
                         .p = parse_range("p", "1")};
  question.ur = parse_range("ur", "0.2");

  const numeric::OrbitList list = numeric::list_orbits(question);
  for (const numeric::Orbit& orbit : list.orbits) {
    std::cout << "for all chi in [0.2999, 0.3001]: tau = " << to_string(orbit.tau(), 8)
              << ", all conditions: " << to_string(orbit.admissible.truth) << '\n';
  }
  for (const numeric::Unresolved& part : list.unresolved) {
    std::cout << "unresolved: " << part.reason << '\n';
  }
}
