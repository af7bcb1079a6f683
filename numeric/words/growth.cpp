#include "numeric/words/growth.hpp"

namespace stickslip::numeric::words {

Verdict growth(const motion::ExactParameters& data, const Rational& ur) {
  if (!motion::is_resonant(data)) {
    return Verdict::undecided("$omega$ is no natural frequency");
  }
  const bool driven =
      ur > data.us && (Ball::pi() * Ball(data.p) - Ball(Rational(4 * data.eta * ur))).is_positive();
  return driven ? Verdict::proved() : Verdict::undecided("$pi p$ is not above $4 eta ur$");
}

}  // namespace stickslip::numeric::words
