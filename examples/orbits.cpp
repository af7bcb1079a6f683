// All non-sticking orbits of a machine on a moving belt, each proved to exist.
#include <iostream>

#include <stickslip/numeric/orbits.hpp>

int main() {
  using namespace stickslip;
  numeric::OrbitQuestion question;
  question.family = &numeric::family_named("nonsticking");
  const auto number = [](const char * text) { return Range{parse_rational(text)}; };
  question.parameters = {.chi = number("0.3"),
                         .eta = number("4"),
                         .us = number("0.1"),
                         .V = number("0.1"),
                         .omega = number("0.6"),
                         .p = number("1")};

  const numeric::OrbitList list = numeric::list_orbits(question);
  std::cout << (list.complete() ? "no orbit is missing" : "something is unresolved") << '\n';
  for (const numeric::Orbit& orbit : list.orbits) {
    std::cout << "tau = " << to_string(orbit.tau()) << ", u_r up to " << to_string(orbit.ur_max(), 6)
              << ", all conditions: " << to_string(orbit.admissible.truth);
    if (orbit.stability) {
      std::cout << ", " << to_string(orbit.stability->kind);
    }
    std::cout << '\n';
  }
}
