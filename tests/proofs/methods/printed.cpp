// Kernel terms as they are printed, and what one printed divisor says of another.

#include <doctest/doctest.h>

#include "proofs/methods/reading.hpp"
#include "proofs/tactics/tactics.hpp"

using namespace stickslip;
using namespace stickslip::proofs::methods;

namespace {

struct Letters {
  proofs::kernel::Term x = proofs::kernel::Variable{"x"}, y = proofs::kernel::Variable{"y"},
                       tau = proofs::kernel::Variable{"tau"}, omega = proofs::kernel::Variable{"omega"},
                       omega1 = proofs::kernel::Variable{"omega1"};
};

std::string neat(const proofs::kernel::Term& term) {
  return proofs::symbols::text(neat_term(term));
}

}  // namespace

TEST_CASE("a number is printed as a quotient of sums of monomials, those of low degree first") {
  const auto [x, y, tau, omega, omega1] = Letters();
  CHECK(neat(power(x, 2) * 3 - y + 1) == "1 - y + 3*x^2");
  CHECK(neat(cos(omega1 * proofs::kernel::pi() * inverse(2 * omega))) == "cos(pi*omega1/(2*omega))");
  CHECK(neat((power(x, 2) - power(y, 2)) / (x + y)) == "x - y");
  CHECK(neat(x - x) == "0");
  CHECK(neat(-x / 2) == "-x/2");
  CHECK_THROWS_AS((void)neat(apply(proofs::kernel::Variable{"Y", proofs::kernel::function_of_time(1, 1)}, x)),
                  proofs::symbols::NoValue);
}

TEST_CASE("of f and -f a hypothesis names the one that begins with a plus") {
  const auto [x, y, tau, omega, omega1] = Letters();
  for (const int sign : {1, -2}) {
    CHECK(hypothesis(proofs::kernel::Term(sign) * (omega - omega1), "a").text == "omega - omega1 != 0");
    CHECK(hypothesis(proofs::kernel::Term(sign) * (omega - 1), "a").text == "1 - omega != 0");
  }
  CHECK(hypothesis(x / (omega - omega1), "a").text == "x/(omega - omega1) != 0");
  CHECK(hypothesis(sin(omega1 * tau), "a").latex == "\\sin(\\omega_1 \\tau) \\neq 0");
}

TEST_CASE("a divisor shows what is a factor of it, and nothing else") {
  using proofs::tactics::implies_nonzero;
  const auto [x, y, tau, omega, omega1] = Letters();
  CHECK(implies_nonzero(x * y, x, {}));
  CHECK(implies_nonzero(power(x, 2) - power(y, 2), y - x, {}));
  CHECK(implies_nonzero(sin(2 * tau), sin(tau), {}));
  CHECK(implies_nonzero(sin(2 * tau), cos(tau), {}));
  CHECK(implies_nonzero(x, x, {}));
  CHECK_FALSE(implies_nonzero(x, x * y, {}));
  CHECK_FALSE(implies_nonzero(x, y, {}));
  CHECK_FALSE(implies_nonzero(sin(tau), sin(2 * tau), {}));
  CHECK_FALSE(implies_nonzero(cos(tau), sin(tau), {}));
  CHECK_FALSE(implies_nonzero(x, 1 + cos(proofs::kernel::pi() / x), {}));  // which divides by x, too
  CHECK_FALSE(implies_nonzero(x + y, x - y, parameters()));
}
