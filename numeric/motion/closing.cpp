#include "numeric/motion/closing.hpp"

#include "core/error.hpp"

namespace stickslip::numeric::motion {

using namespace zeros;

namespace {

// What a quantity of a motion over jets and of the motion at the middle say together, see parametric.hpp.
struct OverBox {
  const ParametricProof& proof;

  [[nodiscard]] Ball operator()(const ParameterJet& g, const Ball& middle) const {
    return proof.over_box(g, middle);
  }
  template <int N>
  [[nodiscard]] Eigen::Matrix<Ball, N, 1> operator()(const Eigen::Matrix<ParameterJet, N, 1>& g,
                                                     const Eigen::Matrix<Ball, N, 1>& middle) const {
    Eigen::Matrix<Ball, N, 1> result;
    for (int i = 0; i < N; ++i) {
      result(i) = (*this)(g(i), middle(i));
    }
    return result;
  }
  [[nodiscard]] model::Wave<Ball> operator()(const model::Wave<ParameterJet>& g,
                                             const model::Wave<Ball>& middle) const {
    model::Wave<Ball> w;
    w.constant = (*this)(g.constant, middle.constant);
    w.slope = (*this)(g.slope, middle.slope);
    for (std::size_t k = 0; k < static_cast<std::size_t>(g.count); ++k) {
      const model::Harmonic<ParameterJet>& h = g.harmonics[k];
      const model::Harmonic<Ball>& at = middle.harmonics[k];
      w.add((*this)(h.nu, at.nu), (*this)(h.a, at.a), (*this)(h.b, at.b));
    }
    return w;
  }
  [[nodiscard]] model::PhaseWaves<Ball> operator()(const model::PhaseWaves<ParameterJet>& g,
                                                   const model::PhaseWaves<Ball>& middle) const {
    return {(*this)(g.z1, middle.z1), (*this)(g.z2, middle.z2), (*this)(g.zdot2, middle.zdot2),
            (*this)(g.r, middle.r)};
  }
  [[nodiscard]] Phase operator()(const PhaseOf<ParameterJet>& g, const Phase& middle) const {
    return {g.kind, (*this)(g.start, middle.start), (*this)(g.duration, middle.duration),
            (*this)(g.load, middle.load), (*this).operator()<4>(g.Z, middle.Z)};
  }
  [[nodiscard]] model::Parameters<Ball> operator()(const model::Parameters<ParameterJet>& g,
                                                   const model::Parameters<Ball>& middle) const {
    return {(*this)(g.chi, middle.chi), (*this)(g.eta, middle.eta),     (*this)(g.us, middle.us),
            (*this)(g.V, middle.V),     (*this)(g.omega, middle.omega), (*this)(g.p, middle.p)};
  }
  [[nodiscard]] model::Oscillator<Ball> operator()(const model::Oscillator<ParameterJet>& g,
                                                   const model::Oscillator<Ball>& middle) const {
    const auto& m = g.modes;
    const auto& n = middle.modes;
    return {(*this)(g.data, middle.data),
            {(*this)(m.omega1, n.omega1), (*this)(m.omega2, n.omega2), (*this)(m.lambda1, n.lambda1),
             (*this)(m.lambda2, n.lambda2)},
            (*this).operator()<2>(g.Q, middle.Q),
            (*this).operator()<2>(g.d0, middle.d0)};
  }
};

template <class S>
S friction_of(const MotionOf<S>& motion, std::size_t k) {
  return model::friction_at<S>(motion.oscillator.data, motion.phases[k].Z, motion.phases[k].load);
}

// The exact data as balls at the working precision.
Given<Ball> rounded(const Given<Rational>& given) {
  const auto ball = [](const std::optional<Rational>& value) {
    return value ? std::optional(Ball(*value)) : std::nullopt;
  };
  return {parameters_as<Ball>(given.data), ball(given.phi), ball(given.ur)};
}

}  // namespace

Vector Closing::parameters(const Given<Ball>& given) const {
  if ((takes_phi_ && !given.phi) || (takes_ur_ && !given.ur)) {
    throw InternalError("the load's phase or the friction of a motion is not given");
  }
  const model::Parameters<Ball>& a = given.data;
  std::vector<Ball> p{a.chi, a.eta, a.us, a.V, a.omega, a.p};
  if (takes_phi_) {
    p.push_back(*given.phi);
  }
  if (takes_ur_) {
    p.push_back(*given.ur);
  }
  return Eigen::Map<Vector>(p.data(), static_cast<Eigen::Index>(p.size()));
}

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
  ClosedMotion closed{Verdict::proved(), {}, motion, all_waves(motion), {}};
  for (std::size_t k = 0; k < motion.phases.size(); ++k) {
    closed.friction.push_back(friction_of<Ball>(motion, k));
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
    return {zero.verdict, {}, {}, {}, {}};
  }
  const long bits = scalars::bits_for(digits);
  const auto recipe = [&] { return AtParameters<Closing>{f, parameters()}; };
  const Vector x = refine<Eigen::Dynamic>(recipe, zero.box, bits);
  const WorkingPrecision scope(bits + 64);
  return taken_as_closed(f.motion<Ball>(x, parameters()));
}

ClosedMotion closed_over(const ParametricProof& proof, const MotionOf<ParameterJet>& jets,
                         const Motion& middle) {
  ClosedMotion closed{proof.verdict, {}, {}, {}, {}};
  const OverBox over{proof};
  closed.motion.oscillator = over(jets.oscillator, middle.oscillator);
  for (std::size_t k = 0; k < middle.phases.size(); ++k) {
    closed.motion.phases.push_back(over(jets.phases[k], middle.phases[k]));
    closed.waves.push_back(over(waves_of<ParameterJet>(jets.oscillator, jets.phases[k]), waves(middle, k)));
    closed.friction.push_back(over(friction_of<ParameterJet>(jets, k), friction_of<Ball>(middle, k)));
  }
  return closed;
}

ClosedMotion prove_closed_over(const Closing& f, const Given<Ball>& given, const Motion& guess) {
  const ParametricProof proof = prove_over_parameters(f, f.parameters(given), f.unknowns(guess));
  ClosedMotion closed{proof.verdict, f.parameter_names()[static_cast<std::size_t>(proof.widest)], {}, {}, {}};
  if (proof.verdict.truth != Truth::proved) {
    return closed;
  }
  ClosedMotion over =
      closed_over(proof, f.motion<ParameterJet>(proof.x, proof.p), f.motion<Ball>(proof.at_middle, proof.p0));
  over.split = closed.split;
  return over;
}

}  // namespace stickslip::numeric::motion
