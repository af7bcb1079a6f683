// Why orbits that never stick attract, for V = 0: small deviations move freely between the transitions, and
// at each of these the second mass loses some of its speed, by a factor rho = (|r| - u_s)/(|r| + u_s). Off
// resonance no deviation passes four transitions without a loss.
#include <fmt/format.h>

#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/appendix5.hpp"

namespace stickslip::proofs::pascal2012::two_slips {

using namespace methods;
using namespace symbols;

namespace {

const Term rho = scalar("rho");
const Term delta1 = scalar("delta1"), delta2 = scalar("delta2"), deltadot1 = scalar("deltadot1"),
           deltadot2 = scalar("deltadot2");
const Term deviation = column({delta1, delta2, deltadot1, deltadot2});

// What a transition does to a deviation.
const Term transition = block(4, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, rho});

// The energy of A5.energy.
Term energy(const Term& x1, const Term& x2, const Term& xdot1, const Term& xdot2) {
  return power(xdot1, 2) / 2 + power(xdot2, 2) / (2 * eta) + power(x1, 2) / 2 - chi * x1 * x2 +
         chi * power(x2, 2) / 2;
}
Term energy_with(const Term& speed) {
  return energy(delta1, delta2, deltadot1, speed);
}

// The speed of the second mass at the k-th transition, if none before took anything away.
Assumption not_seen(int k) {
  return {fmt::format("A5.speed{}", k), equation(component(3, H(k * tau) * deviation), 0)};
}

// That both modes' parts of the speed are zero, of this one: the other mode is eliminated from three
// transitions that follow each other, twice.
struct Share {
  Term frequency, other, lambda, eigenvector;

  // A of A cos(frequency k tau) + B sin(frequency k tau), or B, as a sum over the four transitions.
  [[nodiscard]] std::vector<Term> coefficients(bool cosine) const {
    const Term angle = frequency * tau;
    const Term at_2 = cosine ? sin(3 * angle) : -cos(3 * angle),
               at_3 = cosine ? -sin(2 * angle) : cos(2 * angle);
    const Term scale = 2 * (cos(angle) - cos(other * tau)) * sin(angle), twice = -2 * cos(other * tau);
    return {at_2 / scale, (twice * at_2 + at_3) / scale, (at_2 + twice * at_3) / scale, at_3 / scale};
  }
  // What it contributes to the places, and to the speeds.
  [[nodiscard]] Term column_of(std::size_t k) const {
    return column({eigenvector * (-coefficients(false)[k] / (lambda * frequency)),
                   eigenvector * (coefficients(true)[k] / lambda)});
  }
};

// One component of the deviation.
std::vector<Multiple> all_four(std::size_t which) {
  const Share first{omega1, omega2, lambda1, psi1}, second{omega2, omega1, lambda2, psi2};
  std::vector<Multiple> all;
  for (int k = 1; k <= 4; ++k) {
    const auto at = static_cast<std::size_t>(k - 1);
    all.push_back(
        {assuming(not_seen(k).id), 0, component(which, first.column_of(at) + second.column_of(at))});
  }
  return all;
}

}  // namespace

std::vector<Claim> attraction() {
  return {
      {.id = "A5.loss",
       .kind = Kind::identity,
       .origin = Origin::new_result,
       .printed = {equation(energy_with(rho * deltadot2),
                            energy_with(deltadot2) - (1 - power(rho, 2)) / (2 * eta) * power(deltadot2, 2))},
       .words =
           "$V = 0$: a transition takes the speed $delta_2'$ of a small deviation to $rho delta_2'$ and "
           "leaves "
           "all else, $rho = (|r| - u_s)/(|r| + u_s) < 1$, the accelerations behind and before: energy is "
           "lost, which between transitions stays as it is (A5.energy); where the mass lands and sticks, "
           "$rho "
           "= 0$",
       .prove = by_normal_form()},
      {.id = "A5.held",
       .kind = Kind::identity,
       .origin = Origin::new_result,
       .printed = {equation(deltadot1 * (chi * delta2 - delta1) + delta1 * deltadot1 -
                                chi * (deltadot1 * delta2 + delta1 * deltadot2) + chi * delta2 * deltadot2,
                            chi * deltadot2 * (delta2 - delta1))},
       .words = "the rate of that energy during a stick, $delta_1'' = chi delta_2 - delta_1$ by (9) and "
                "$delta_2'' = "
                "0$: it is zero, as $delta_2' = 0$ there. With A5.energy and A5.loss, of all that happens "
                "only the "
                "break-away from a stick can make it grow",
       .prove = by_normal_form()},
      {.id = "A5.product",
       .kind = Kind::identity,
       .origin = Origin::new_result,
       .printed = {equation(determinant(transition * H(tau)), rho)},
       .words = "the product of the Floquet multipliers of an orbit that never sticks is that of the factors "
                "$rho$ of its transitions",
       .prove = by_normal_form()},
      {.id = "A5.seen",
       .kind = Kind::theorem,
       .origin = Origin::new_result,
       .printed = {equation(delta1, 0), equation(delta2, 0), equation(deltadot1, 0), equation(deltadot2, 0)},
       .words =
           "a deviation with which the second mass has no speed at four transitions that follow each other "
           "is zero, if $sin(omega_j tau) != 0$ and $cos(omega_1 tau) != cos(omega_2 tau)$: at $tau = "
           "pi/omega$, $omega_j != k omega$ and $omega_2 +- omega_1 != 2 k omega$",
       .assumptions = {not_seen(1),
                       not_seen(2),
                       not_seen(3),
                       not_seen(4),
                       {"A5.sines", {sin(omega1 * tau) * sin(omega2 * tau), 0, Relation::not_equal}},
                       {"A5.apart", {cos(omega1 * tau) - cos(omega2 * tau), 0, Relation::not_equal}}},
       .prove = by_combination({all_four(0), all_four(1), all_four(2), all_four(3)})},
  };
}

}  // namespace stickslip::proofs::pascal2012::two_slips
