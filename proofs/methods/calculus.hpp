// Methods of proof that take one theorem of calculus each. They check that the premises are of the form which
// the theorem wants; the theorem itself is named in the route.
#pragma once

#include <string>

#include "proofs/methods/methods.hpp"

namespace stickslip::proofs::methods {

// Mean value theorem. The assumption says "d/dt (row * Z(t)) < bound" for lower < t < upper, the bound
// constant; the printed inequality is row * at_upper - row * at_lower < bound * (upper - lower). The claim
// must assume Z(upper) = at_upper under the id `named`; at_lower is Z(0), and lower is 0.
struct MeanValue {
  std::string slope;  // id of the assumption about the derivative
  std::string named;  // id of the assumption Z(upper) = at_upper
  symbols::Term row = 1;
  symbols::Term at_lower = 0, at_upper = 0;
  symbols::Term upper = 0;
};
[[nodiscard]] Proof by_mean_value(MeanValue step);

// A continuous function of period Theta whose rate of change is never positive does not change. `rate` says
// d/dt E = A, `form` says A = -weight * difference^2 with a weight that `positive` says is positive; the
// printed equation is difference = 0, at almost all times. E is a function of `motions`, pairs of symbols,
// through their differences alone, which `periodic` assumes to return after Theta.
struct PeriodicDecrease {
  Premise rate, form, positive;
  std::string periodic;
  symbols::Term weight = 1, difference = 0;
  std::vector<std::pair<symbols::Term, symbols::Term>> motions;
};
[[nodiscard]] Proof by_periodic_decrease(PeriodicDecrease step);

// The printed "A != 0" follows from the assumption "B != 0", as A divides B or its square.
[[nodiscard]] Proof by_nonzero_multiple(const std::string& assumption);

}  // namespace stickslip::proofs::methods
