#include "proofs/pascal2012/printed_closing.hpp"

#include <algorithm>

#include "numeric/families/overshooting.hpp"

namespace stickslip::proofs::pascal2012 {

using namespace numeric::families;
using namespace numeric::motion;
using namespace numeric::zeros;

namespace {

template <std::size_t N>
Vector points(const std::array<Decimal, N>& printed) {
  Vector x(static_cast<int>(N));
  std::transform(printed.begin(), printed.end(), x.begin(), [](const Decimal& d) { return Ball(d.value); });
  return x;
}
template <std::size_t N>
Vector intervals(const std::array<Decimal, N>& printed) {
  Vector x(static_cast<int>(N));
  std::transform(printed.begin(), printed.end(), x.begin(), printed_interval);
  return x;
}

}  // namespace

Equations16 equations_16(const ExactParameters& a, LoadPhase phase) {
  const model::SymmetricData<Ball> data = symmetric_data(a, phase);
  return {data, model::Vector2<Ball>(model::Q<Ball>(parameters_as<Ball>(a), data.m) * data.sigma)};
}

PrintedClosing<4> printed_zero_of_16(const ExactParameters& a, const std::array<Decimal, 4>& printed) {
  const Equations16 f = equations_16(a, LoadPhase::first);
  const Box<4> interval = intervals(printed);
  return {f(Box<4>(points(printed))), f(interval), krawczyk_test<4>(f, interval).verdict};
}

PrintedClosing<5> printed_closing_overshooting(const ExactParameters& a, const Rational& phi,
                                               const std::array<Decimal, 5>& printed) {
  require_stick_slip_domain(a);
  const model::Oscillator<Ball> o = model::oscillator<Ball>(parameters_as<Ball>(a));
  const auto residuals = [&](const Vector& x) -> Box<5> {
    const Ball rest = Ball(2) * Ball::pi() / o.data.omega - x(0) - x(1);
    const Motion m =
        compose(o, Ball(phi), {x(2), x(3), x(4), o.data.V},
                {{PhaseKind::slip, x(0)}, {PhaseKind::overshoot, x(1)}, {PhaseKind::stick, rest}});
    const Phase& stick = m.phases[2];
    const model::Vector4<Ball> Z = flow<Ball>(o, stick.kind, stick.load, stick.Z, stick.duration);
    const Ball& V = o.data.V;  // a stick keeps z2' as it is
    return (Box<5>() << m.phases[1].Z(3) - V, Z(0) - x(2), Z(1) - x(3), Z(2) - x(4), stick.Z(3) - V)
        .finished();
  };
  PrintedClosing<5> result{residuals(points(printed)), residuals(intervals(printed)),
                           Verdict::undecided("every closing condition may hold somewhere in the intervals")};
  if (std::any_of(result.at_intervals.begin(), result.at_intervals.end(),
                  [](const Ball& residual) { return residual.is_nonzero(); })) {
    result.verdict = Verdict::refuted("a closing condition holds nowhere in the printed intervals");
  }
  return result;
}

}  // namespace stickslip::proofs::pascal2012
