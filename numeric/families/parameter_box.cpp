#include "numeric/families/parameter_box.hpp"

#include <array>

#include "core/error.hpp"
#include "model/nonsticking.hpp"
#include "model/symmetric_closing.hpp"
#include "numeric/families/nonsticking.hpp"

namespace stickslip::numeric::families {

using namespace motion;
using namespace zeros;

namespace {

template <class T>
model::Oscillator<T> oscillator_of(const ParameterVector<T>& p) {
  return model::oscillator<T>({p(0), p(1), p(2), p(3), p(4), p(5)});
}

template <class T>
T half_turn() {
  return T(Ball::pi());
}

struct SymmetricProblem {
  static constexpr int unknowns = 2;
  int sigma;

  template <class T>
  [[nodiscard]] model::SymmetricData<T> data(const ParameterVector<T>& p) const {
    return {p(0), model::modes<T>(p(0), p(1)), p(3), p(4), p(5), T(T(2) * half_turn<T>() / p(4)), T(sigma)};
  }
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> closing(const Eigen::Matrix<T, 2, 1>& x,
                                               const ParameterVector<T>& p) const {
    return model::symmetric_closing<T>(data<T>(p), x(0), x(1));
  }
  // The stick begins at E Z0 (13).
  template <class T>
  [[nodiscard]] MotionOf<T> motion(const Eigen::Matrix<T, 2, 1>& x, const ParameterVector<T>& p) const {
    const model::SymmetricData<T> a = data<T>(p);
    const model::Vector4<T> Z0 = model::symmetric_start<T>(a, x(0), x(1));
    const model::Vector4<T> ZC(T(-Z0(0)), T(-Z0(1)), Z0(2), Z0(3));
    const T phi = model::symmetric_phase<T>(a, half_turn<T>(), x(0));
    return {oscillator_of<T>(p),
            {{PhaseKind::slip, T(0), x(0), phi, Z0},
             {PhaseKind::stick, x(0), T(a.Theta - x(0)), T(phi + p(4) * x(0)), ZC}}};
  }
};

struct OvershootingProblem {
  static constexpr int unknowns = 5;

  template <class T>
  [[nodiscard]] MotionOf<T> motion(const Eigen::Matrix<T, 5, 1>& x, const ParameterVector<T>& p) const {
    const T Theta = T(2) * half_turn<T>() / p(4);
    const model::Vector4<T> Z0(x(2), x(3), x(4), p(3));
    MotionOf<T> motion = compose_motion<T>(
        oscillator_of<T>(p), p(6), Z0,
        {{PhaseKind::slip, x(0)}, {PhaseKind::overshoot, x(1)}, {PhaseKind::stick, T(Theta - x(0) - x(1))}});
    return motion;
  }
  // z2' = V at tau and tau + tau1, and (20) in z1, z2, z1'.
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 5, 1> closing(const Eigen::Matrix<T, 5, 1>& x,
                                               const ParameterVector<T>& p) const {
    const MotionOf<T> m = motion<T>(x, p);
    const PhaseOf<T>& stick = m.phases[2];
    const model::Vector4<T> Z = flow<T>(m.oscillator, PhaseKind::stick, stick.load, stick.Z, stick.duration);
    Eigen::Matrix<T, 5, 1> f;
    f << T(m.phases[1].Z(3) - p(3)), T(stick.Z(3) - p(3)), T(Z(0) - x(2)), T(Z(1) - x(3)), T(Z(2) - x(4));
    return f;
  }
};

// The same at a given u_r, the seventh parameter: the load's phase is the sixth unknown, for (12).
struct OvershootingAtFriction {
  static constexpr int unknowns = 6;

  template <class T>
  [[nodiscard]] MotionOf<T> motion(const Eigen::Matrix<T, 6, 1>& x, const ParameterVector<T>& p) const {
    ParameterVector<T> with_phase = p;
    with_phase(6) = x(5);
    return OvershootingProblem{}.motion<T>(x.template head<5>(), with_phase);
  }
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 6, 1> closing(const Eigen::Matrix<T, 6, 1>& x,
                                               const ParameterVector<T>& p) const {
    ParameterVector<T> with_phase = p;
    with_phase(6) = x(5);
    Eigen::Matrix<T, 6, 1> f;
    f.template head<5>() = OvershootingProblem{}.closing<T>(x.template head<5>(), with_phase);
    const model::Vector4<T> Z0(x(2), x(3), x(4), p(3));
    f(5) = model::friction_at<T>({p(0), p(1), p(2), p(3), p(4), p(5)}, Z0, x(5)) - p(6);
    return f;
  }
};

struct NonstickingProblem {
  static constexpr int unknowns = 2;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> closing(const Eigen::Matrix<T, 2, 1>& x,
                                               const ParameterVector<T>& p) const {
    const model::Oscillator<T> o = oscillator_of<T>(p);
    return model::two_slips<T>(o.data, o.modes, o.Q(1), model::modal_rest<T>(o.modes, o.d0), half_turn<T>(),
                               x(0), x(1));
  }
  template <class T>
  [[nodiscard]] MotionOf<T> motion(const Eigen::Matrix<T, 2, 1>& x, const ParameterVector<T>& p) const {
    const model::Oscillator<T> o = oscillator_of<T>(p);
    return two_slips_motion<T>(o, model::modal_rest<T>(o.modes, o.d0), half_turn<T>(), x(0), x(1));
  }
};

// What a quantity of a motion over jets and of the motion at the middle say together, see parametric.hpp.
struct Merge {
  ParameterVector<Ball> spread;

  [[nodiscard]] Ball operator()(const ParameterJet& g, const Ball& middle) const {
    return over_parameters(g, middle, spread);
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
  [[nodiscard]] model::Oscillator<Ball> operator()(const model::Oscillator<ParameterJet>& g,
                                                   const model::Oscillator<Ball>& middle,
                                                   const model::Parameters<Ball>& data) const {
    const auto& m = g.modes;
    const auto& n = middle.modes;
    return {data,
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

constexpr std::array<const char *, parameter_count - 1> names{"chi", "eta", "us", "V", "omega", "p"};

// Existence, and the motion with its waves over the whole box.
template <class Problem>
BoxOrbit prove_over(const Problem& problem, const model::Parameters<Ball>& a, const Ball& seventh,
                    const char * seventh_name, const std::vector<double>& guess) {
  constexpr int N = Problem::unknowns;
  if (guess.size() != N) {
    throw InternalError("a guess of " + std::to_string(guess.size()) + " numbers for " + std::to_string(N) +
                        " unknowns");
  }
  ParameterVector<Ball> P;
  P << a.chi, a.eta, a.us, a.V, a.omega, a.p, seventh;
  Box<N> start;
  for (int i = 0; i < N; ++i) {
    start(i) = Ball(guess[static_cast<std::size_t>(i)]);
  }
  const ParametricProof<N> proof = prove_over_parameters<N>(problem, P, start);
  BoxOrbit orbit;
  orbit.existence = proof.verdict;
  const auto widest = static_cast<std::size_t>(proof.widest);
  orbit.split = widest < names.size() ? names[widest] : seventh_name;
  if (proof.verdict.truth != Truth::proved) {
    return orbit;
  }
  orbit.zero.assign(proof.box.begin(), proof.box.end());
  ParameterVector<Ball> p0;
  ParameterVector<ParameterJet> p;
  Eigen::Matrix<ParameterJet, N, 1> x;
  for (int j = 0; j < parameter_count; ++j) {
    p0(j) = P(j).midpoint();
    p(j) = P(j).is_exact() ? ParameterJet(P(j)) : ParameterJet::variable(P(j), j);
  }
  for (int i = 0; i < N; ++i) {
    x(i) = ParameterJet(proof.box(i));
    for (int j = 0; j < parameter_count; ++j) {
      if (!P(j).is_exact()) {
        x(i).partials[static_cast<std::size_t>(j)] = proof.derivative(i, j);
      }
    }
  }
  const Merge merge{P - p0};
  const MotionOf<ParameterJet> jets = problem.template motion<ParameterJet>(x, p);
  const Motion middle = problem.template motion<Ball>(proof.at_middle, p0);
  orbit.motion.oscillator = merge(jets.oscillator, middle.oscillator, a);
  for (std::size_t k = 0; k < middle.phases.size(); ++k) {
    orbit.motion.phases.push_back(merge(jets.phases[k], middle.phases[k]));
    orbit.waves.push_back(merge(waves_of<ParameterJet>(jets.oscillator, jets.phases[k]), waves(middle, k)));
  }
  orbit.ur = merge(friction_of<ParameterJet>(jets, 0), friction_of<Ball>(middle, 0));
  return orbit;
}

}  // namespace

BoxOrbit prove_symmetric_over(const model::Parameters<Ball>& a, int sigma, const std::vector<double>& guess) {
  BoxOrbit orbit = prove_over(SymmetricProblem{sigma}, a, Ball(0), "", guess);
  if (orbit.existence.truth == Truth::proved) {
    orbit.conditions = decide_conditions(Family::symmetric, orbit.motion, orbit.waves, orbit.ur);
  }
  return orbit;
}

BoxOrbit prove_overshooting_over(const model::Parameters<Ball>& a, const Ball& phi,
                                 const std::vector<double>& guess) {
  BoxOrbit orbit = prove_over(OvershootingProblem{}, a, phi, "phi", guess);
  if (orbit.existence.truth == Truth::proved) {
    orbit.conditions = decide_conditions(Family::overshooting, orbit.motion, orbit.waves, orbit.ur);
  }
  return orbit;
}

BoxOrbit prove_overshooting_at_friction_over(const model::Parameters<Ball>& a, const Ball& ur,
                                             const std::vector<double>& guess) {
  BoxOrbit orbit = prove_over(OvershootingAtFriction{}, a, ur, "ur", guess);
  if (orbit.existence.truth == Truth::proved) {
    orbit.ur = ur;
    orbit.conditions = decide_conditions(Family::overshooting, orbit.motion, orbit.waves, orbit.ur);
  }
  return orbit;
}

BoxOrbit prove_nonsticking_over(const model::Parameters<Ball>& a, const std::optional<Ball>& ur,
                                const std::vector<double>& guess) {
  BoxOrbit orbit = prove_over(NonstickingProblem{}, a, Ball(0), "", guess);
  if (orbit.existence.truth == Truth::proved) {
    const Ball at_tau = -friction_of<Ball>(orbit.motion, 1);
    arb_min(orbit.ur.raw(), orbit.ur.raw(), at_tau.raw(), WorkingPrecision::bits());
    orbit.conditions = decide_conditions(Family::nonsticking, orbit.motion, orbit.waves, ur);
    if (!ur) {
      orbit.conditions.push_back(room_for_friction(orbit.ur, a.us));
    } else if (const std::optional<Condition> load =
                   condition_36(orbit.motion.oscillator, orbit.zero[0], orbit.zero[1] - orbit.zero[0], *ur)) {
      orbit.conditions.push_back(*load);
    }
  }
  return orbit;
}

}  // namespace stickslip::numeric::families
