#include "numeric/words/pure_stick.hpp"

namespace stickslip::numeric::words {

Verdict pure_stick(const motion::ExactParameters& data, const Rational& ur) {
  if (data.V != 0) {
    return Verdict::refuted("the belt takes mass 2 along until $r$ reaches $ur$ or $-ur$");
  }
  if (data.p < ur * data.eta) {
    return Verdict::proved();
  }
  const bool aside = data.p > ur * data.eta && Rational(1 / data.omega).get_den() != 1;
  return aside ? Verdict::refuted("the load alone takes $r$ beyond $ur$")
               : Verdict::undecided("$p/eta$ is not below $ur$");
}

}  // namespace stickslip::numeric::words
