// All non-sticking orbits of a machine on a moving belt, each proved to exist.
#include <iostream>

#include <stickslip/numeric/orbits.hpp>

int main() {
  using namespace stickslip;
  numeric::OrbitQuestion question;
  question.family = &numeric::family_named("nonsticking");
  question.parameters = {.chi = parse_range("chi", "0.3"),
                         .eta = parse_range("eta", "4"),
                         .us = parse_range("us", "0.1"),
                         .V = parse_range("V", "0.1"),
                         .omega = parse_range("omega", "0.6"),
                         .p = parse_range("p", "1")};
  const numeric::OrbitList list = numeric::list_orbits(question);
  std::cout << (list.complete() ? "no orbit is missing" : "something is unresolved") << '\n';
  for (const numeric::Orbit& orbit : list.orbits) {
    std::cout << "tau = " << to_string(orbit.tau()) << ", u_r up to " << to_string(orbit.ur_max(), 6)
              << ", all conditions: " << to_string(orbit.admissible.truth) << '\n';
  }
}
