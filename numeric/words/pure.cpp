#include "numeric/words/pure.hpp"

#include "model/waves.hpp"

namespace stickslip::numeric::words {

using namespace motion;

PureSlip pure_slip(const ExactParameters& data, PhaseKind kind) {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(data));
  const Rational V = kind == PhaseKind::slip ? data.V : Rational(-data.V);
  const Ball forced = abs(o.Q(1)) * o.data.omega;
  PureSlip result{forced, Ball(V) - forced, {}};
  const auto [first, second] = resonances(data);
  if (result.room.is_positive()) {
    result.exists = Verdict::proved();
  } else if (V <= 0) {
    result.exists = Verdict::refuted("the mean of $x2'$ over a long time is 0");
  } else if (first == 0 && second == 0 && result.room.is_negative()) {
    result.exists = Verdict::refuted("the load alone moves $x2$ faster than the belt");
  } else {
    result.exists = Verdict::undecided("$|q2| omega$ is not below $V$");
  }
  return result;
}

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

Verdict growth(const motion::ExactParameters& data, const Rational& ur) {
  if (!motion::is_resonant(data)) {
    return Verdict::undecided("$omega$ is no natural frequency");
  }
  const bool driven =
      ur > data.us && (Ball::pi() * Ball(data.p) - Ball(Rational(4 * data.eta * ur))).is_positive();
  return driven ? Verdict::proved() : Verdict::undecided("$pi p$ is not above $4 eta ur$");
}

}  // namespace stickslip::numeric::words
