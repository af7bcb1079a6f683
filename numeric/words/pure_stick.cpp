#include "numeric/words/pure_stick.hpp"

namespace stickslip::numeric::words {

Verdict pure_stick(const motion::ExactParameters& data, const Rational& ur) {
  if (data.V != 0) {
    return Verdict::refuted("the belt takes mass 2 along until $r$ reaches $ur$ or $-ur$");
  }
  return data.p < ur * data.eta ? Verdict::proved() : Verdict::undecided("$p/eta$ is not below $ur$");
}

}  // namespace stickslip::numeric::words
