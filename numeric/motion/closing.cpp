#include "numeric/motion/closing.hpp"

#include "core/error.hpp"
#include "numeric/motion/motion.hpp"

namespace stickslip::numeric::motion {

using namespace zeros;

template <class T>
VectorOf<T> Closing::parameters(const Given<T>& given) const {
  if ((takes_phi_ && !given.phi) || (takes_ur_ && !given.ur)) {
    throw InternalError("the load's phase or the friction of a motion is not given");
  }
  const model::Parameters<T>& a = given.data;
  std::vector<T> p{a.chi, a.eta, a.us, a.V, a.omega, a.p};
  if (takes_phi_) {
    p.push_back(*given.phi);
  }
  if (takes_ur_) {
    p.push_back(*given.ur);
  }
  return Eigen::Map<VectorOf<T>>(p.data(), static_cast<Eigen::Index>(p.size()));
}
template VectorOf<Ball> Closing::parameters(const Given<Ball>&) const;
template VectorOf<ParameterJet> Closing::parameters(const Given<ParameterJet>&) const;

std::vector<std::string> Closing::parameter_names() const {
  std::vector<std::string> names{"chi", "eta", "us", "V", "omega", "p"};
  if (takes_phi_) {
    names.emplace_back("phi");
  }
  if (takes_ur_) {
    names.emplace_back("ur");
  }
  return names;
}

ClosedMotion taken_as_closed(const Motion& motion) {
  ClosedMotion closed{Verdict::proved(), motion, all_waves(motion), {}};
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    closed.friction.push_back(friction_ahead<Ball>(motion, k));
  }
  return closed;
}

ClosedMotion prove_closed(const Closing& f, const Given<Rational>& given, const Motion& guess, int digits) {
  const auto parameters = [&] { return f.parameters(rounded(given)); };
  ZeroProof<Eigen::Dynamic> zero;
  {
    const WorkingPrecision scope(128);
    zero = prove_zero_at(f, parameters(), f.unknowns(guess));
  }
  if (zero.verdict.truth != Truth::proved) {
    return {zero.verdict, {}, {}, {}};
  }
  const long bits = scalars::bits_for(digits);
  const auto recipe = [&] { return AtParameters<Closing>{f, parameters()}; };
  const Vector x = refine<Eigen::Dynamic>(recipe, zero.box, bits);
  const WorkingPrecision scope(bits + 64);
  return taken_as_closed(f.motion<Ball>(x, parameters()));
}

ClosedMotion closed_over(const ParametricProof& proof, const MotionOf<ParameterJet>& jets,
                         const Motion& middle) {
  const auto over = [&](const ParameterJet& g, const Ball& at_middle) {
    return proof.over_box(g, at_middle);
  };
  const Zip<decltype(over)> zip{over};
  ClosedMotion closed{proof.verdict, zip(jets, middle), {}, {}};
  for (std::size_t k = 0; k < middle.phases.size(); ++k) {
    closed.waves.push_back(zip(waves_of<ParameterJet>(jets.oscillator, jets.phases[k]), waves(middle, k)));
    closed.friction.push_back(over(friction_ahead<ParameterJet>(jets, k), friction_ahead<Ball>(middle, k)));
  }
  return closed;
}

}  // namespace stickslip::numeric::motion
