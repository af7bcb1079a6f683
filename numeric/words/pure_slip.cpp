#include "numeric/words/pure_slip.hpp"

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

}  // namespace stickslip::numeric::words
