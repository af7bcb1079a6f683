// Appendix 4: the orbits of Section 6 are symmetric in space and time, (52)-(54). X is the state (x, x') and
// delta_0 = (d_0, 0). The paper names (5), (19) and (30) as sources of (52); (19) speaks of another orbit,
// what is used are (5) and (27).
#include "proofs/methods/implications.hpp"
#include "proofs/pascal2012/half_period.hpp"
#include "proofs/pascal2012/paper.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace methods;
using namespace symbols;

std::vector<Claim> appendix4() {
  using namespace symbols::vocabulary;
  using namespace half_period;
  const Assumption from_0 = not_before(t, 0), to_tau = not_after(t, tau);
  return {
      {.id = "52.X",
       .kind = Kind::definition,
       .printed = {equation(X(t), Z(t) + delta0), equation(X0, Z0 + delta0), equation(XB, ZB + delta0),
                   equation(delta0, column({d0, zero(2, 1)}))},
       .words = "$X = (x, x')$, $x = z + d_0$",
       .prove = by_definition()},
      {.id = "52.L",
       .kind = Kind::identity,
       .origin = Origin::auxiliary,
       .printed = {equation(L(t) * d0, H(t) * delta0 - delta0)},
       .words = "$L(t) d_0$ is what $H(t)$ adds to $delta_0$",
       .prove = by_normal_form()},
      {.id = "52",
       .kind = Kind::step,
       .printed = {equation(X(t), H(t) * (X0 - F0 - delta0) + F(t) + delta0),
                   equation(X(t + tau), H(t) * (XB - FB + delta0) + F(t + tau) - delta0)},
       .words = "(5) and (27) for $x$",
       .assumptions = {half, period, begins, slips_below, overshoots, named_B, from_0, to_tau},
       .prove =
           by_rewriting({from("52.X").solved_for(X(t)), from("52.X").at("t", t + tau).solved_for(X(t + tau)),
                         from("52.X").solved_for(X0), from("52.X").solved_for(XB), from("5"),
                         from("27").at("t", t + tau), from("52.L")})},
      {.id = "53.F",
       .kind = Kind::identity,
       .printed = {equation(F(t + tau), -F(t)), equation(FB, -F0)},
       .words = "the load half a period later",
       .assumptions = {half},
       .prove = by_normal_form()},
      {.id = "53.X",
       .kind = Kind::step,
       .printed = {equation(XB, -X0)},
       .words = "(33): opposite states",
       .assumptions = motion_and({regular}),
       .prove = by_combination({{{from("33.symmetry"), 0, column({I2, zero(2, 2)})},
                                 {from("33.symmetry"), 1, column({zero(2, 2), I2})}}})},
      {.id = "54",
       .kind = Kind::theorem,
       .printed = {equation(X(t), -X(t + tau))},
       .words = "half a period later the motion is the opposite one",
       .assumptions = motion_and({regular, from_0, to_tau}),
       .prove = by_rewriting(
           {from("52").solved_for(X(t)), from("52").solved_for(X(t + tau)), from("53.X"), from("53.F")})},
  };
}

}  // namespace stickslip::proofs::pascal2012
