#include "proofs/pascal2012/printed_closing.hpp"

#include <algorithm>

#include "numeric/families/overshooting.hpp"
#include "numeric/motion/shooting.hpp"

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
  const Shooting f{overshooting().phases, true};
  const Vector p = Closing(f).parameters({parameters_as<Ball>(a), Ball(phi)});
  const auto residuals = [&](const Vector& x) -> Box<5> {
    const Vector r = f.closing<Ball>(x, p);
    return (Box<5>() << r(0), r(2), r(3), r(4), r(1)).finished();  // a stick keeps z2' as it is
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
