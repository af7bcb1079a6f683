#include "numeric/words/pure_slip.hpp"

#include "model/waves.hpp"

namespace stickslip::numeric::words {

PureSlip pure_slip(const motion::ExactParameters& data) {
  const model::Oscillator<Ball> o = model::oscillator<Ball>(motion::parameters_as<Ball>(data));
  const Ball forced = abs(o.Q(1)) * o.data.omega;
  return {forced, (o.data.V - forced).is_positive() ? Verdict::proved()
                                                    : Verdict::undecided("$|q2| omega$ is not below $V$")};
}

}  // namespace stickslip::numeric::words
