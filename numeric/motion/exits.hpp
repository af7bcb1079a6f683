// The ways in which a multiplier can cross the unit circle, as functions of the motion over any scalar; and
// what they say of the stability of many motions at once.
#pragma once

#include <Eigen/LU>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/symmetric.hpp"
#include "numeric/motion/multipliers.hpp"
#include "numeric/motion/stability.hpp"
#include "numeric/zeros/parametric.hpp"

namespace stickslip::numeric::motion {

// The ways in which a multiplier can cross the unit circle, as functions that vanish exactly then: det(I -
// M), det(I + M), and the product of 1 - mu_i mu_j over i < j, which also vanishes for a real pair mu, 1/mu.
enum class Exit { plus_one, minus_one, pair };
inline constexpr std::array exits{Exit::plus_one, Exit::minus_one, Exit::pair};
[[nodiscard]] std::string to_string(Exit exit);

// From the coefficients of motion/multipliers.hpp, whose leading one is positive where the friction law is
// obeyed: that times the function, for a pair its square. Where it is negative, a multiplier is outside: if
// all were inside, each would be a product of positive factors.
template <class S>
[[nodiscard]] S exit_function(Exit exit, const std::vector<S>& c) {
  const auto n = static_cast<int>(c.size()) - 1;
  if (exit != Exit::pair) {
    S sum(0);
    for (int k = 0; k <= n; ++k) {
      sum += exit == Exit::minus_one && (n - k) % 2 == 1 ? S(-c[static_cast<std::size_t>(k)])
                                                         : c[static_cast<std::size_t>(k)];
    }
    return sum;
  }
  // By the elementary symmetric functions of the multipliers, e4 = 0 with a stick.
  const auto e = [&](int k) {
    const S& coefficient = c[static_cast<std::size_t>(n - k)];
    return k % 2 == 1 ? S(-coefficient) : coefficient;
  };
  const S three = e(0) * e(0) - e(0) * e(2) + e(1) * e(3) - e(3) * e(3);
  return n == 3 ? three
                : S(three +
                    e(4) * S(e(1) * e(3) + S(2) * e(2) - S(1) - e(1) * e(1) - e(4) * S(S(1) + e(2) - e(4))));
}

// The exit functions of a motion that obeys the friction law, each as factors: their product is a positive
// multiple of it if `is_regular`, the rate r' at the end of a stick or 1, is positive; else they say nothing.
template <class S>
struct ExitFactors {
  std::array<std::vector<S>, exits.size()> of;
  S is_regular;

  [[nodiscard]] const std::vector<S>& operator[](Exit exit) const {
    return of[static_cast<std::size_t>(exit)];
  }
  [[nodiscard]] S product(Exit exit) const {
    S product(1);
    for (const S& factor : (*this)[exit]) {
      product *= factor;
    }
    return product;
  }
};

// The coefficients of a polynomial whose zeros are the multipliers, except for zeros: that of the return map
// seen where a stick begins, with more than one. Then not finite where one of them may end at rest.
template <class S>
[[nodiscard]] std::vector<S> multiplier_coefficients(const MotionOf<S>& motion) {
  const std::vector<std::size_t> sticks = sticks_of(motion);
  if (sticks.size() < 2) {
    return multiplier_polynomial(motion);
  }
  const Eigen::Matrix<S, 3, 3> M = monodromy<S>(motion, sticks.back()).template topLeftCorner<3, 3>();
  const auto minor = [&](int i, int j) { return S(M(i, i) * M(j, j) - M(i, j) * M(j, i)); };
  return {S(-M.determinant()), S(minor(0, 1) + minor(0, 2) + minor(1, 2)), S(-M(0, 0) - M(1, 1) - M(2, 2)),
          S(1)};
}

// sin x - x cos x, that is x³/3 for small x, by its derivative x sin x: with a small relative error.
[[nodiscard]] inline Ball cubic(const Ball& x) {
  const Ball m = x.midpoint();
  return sin(m) - m * cos(m) + x * sin(x) * (x - m);
}
[[nodiscard]] inline zeros::ParameterJet cubic(const zeros::ParameterJet& x) {
  return x.chain(cubic(x.value), x.value * sin(x.value));
}

// A symmetric orbit, with the symbols of model/symmetric.hpp; x = T/2 and rho(x) = r - us at the
// break-away, with the rate rho'(x) there (atlas/symmetric_orbit.hpp).
//
// Its symmetry gives det(I - M) two factors, F = lambda_2 s_2 P_1 - lambda_1 s_1 P_2 and N = omega_1 P_1 E_2
// - omega_2 P_2 E_1, with E_j = lambda_j omega_j (s_j rho' + omega_j c_j rho) when N is multiplied by rho',
// for chi eta (lambda_j - 1) = lambda_j omega_j².
//
// Where k omega = omega_j, s_j, P_j and E_j vanish with x, and 1 is a multiplier there. With u_j = s_j +
// omega_j c_j x and D(x) = sin x - x cos x,
//   P_j = u_j cos x + omega_j c_j D(x),  E_j = lambda_j omega_j (u_j rho' + omega_j c_j G),
//   G = rho - x rho' = -chi C D(x) - sigma (p/eta) D(omega x),
// and R_j = u_j, S_j = -(omega u_j cos(omega x) + omega_j c_j D(omega x))/(omega_j² - omega²), so the closing
// condition C lambda_k P_j = V omega_k² R_j + sigma p S_j reads u_j B = -omega_j c_j A,
//   B = C lambda_k cos x - V omega_k² + f omega cos(omega x),  A = C lambda_k D(x) + f D(omega x),
//   f = sigma p/(omega_j² - omega²).
// Then N B is omega_j c_j times what has A, D and G as factors, all of the order x³: nothing cancels.
template <class S>
class SymmetricExits {
 public:
  explicit SymmetricExits(const MotionOf<S>& motion)
      : a_(motion.oscillator.data),
        tau_(motion.phases.at(0).duration),
        x_(motion.phases.at(1).duration / S(2)) {
    const PhaseOf<S>& slip = motion.phases[0];
    const model::Modes<S>& m = motion.oscillator.modes;
    rho_ = model::friction_at<S>(a_, slip.Z, slip.load) - a_.us;
    rate_ = model::friction_rate<S>(a_, slip.Z, slip.load);
    const auto [sine, cosine] = sin_cos(x_);
    C_ = S(slip.Z(0) - a_.chi * slip.Z(1)) * sine + S(slip.Z(2) - a_.chi * a_.V) * cosine;
    load_ = a_.p * S(sin(S(slip.load + a_.omega * tau_ / S(2))));
    modes_ = {mode(m.omega1, m.lambda1), mode(m.omega2, m.lambda2)};
  }

  // A positive multiple of det(I - M), if rho' is positive.
  [[nodiscard]] std::vector<S> at_one() const {
    const auto& [one, two] = modes_;
    return {F(), S(one.omega * one.P * two.E - two.omega * two.P * one.E)};
  }

  // The same by the closing condition of mode j, 0 or 1.
  [[nodiscard]] std::vector<S> at_one_by_mode(std::size_t j) const {
    const Mode &mode = modes_.at(j), &other = modes_.at(1 - j);
    const S f = load_ / S(mode.omega * mode.omega - a_.omega * a_.omega);
    const S wx = a_.omega * x_;
    const S cosine = cos(x_), D = cubic(x_), D_load = cubic(wx);
    const S G = -a_.chi * C_ * D - load_ / a_.eta * D_load;
    const S B = C_ * other.lambda * cosine - a_.V * other.omega * other.omega + f * a_.omega * S(cos(wx));
    const S A = C_ * other.lambda * D + f * D_load;
    const S rest =
        other.omega * other.P * mode.lambda * S(B * G - A * rate_) - other.E * S(B * D - A * cosine);
    return {F(), S(S(j == 1 ? 1 : -1) * mode.cosine), B, rest};
  }

 private:
  struct Mode {
    S omega, lambda, P, E, sine, cosine;
  };
  [[nodiscard]] Mode mode(const S& omega, const S& lambda) const {
    const auto [sine, cosine] = sin_cos(S(omega * tau_ / S(2)));
    return {omega,
            lambda,
            model::stick_transfer<S>(omega, S(tau_ + S(2) * x_), tau_).odd,
            S(lambda * omega * S(rate_ * sine + rho_ * omega * cosine)),
            sine,
            cosine};
  }
  [[nodiscard]] S F() const {
    const auto& [one, two] = modes_;
    return two.lambda * two.sine * one.P - one.lambda * one.sine * two.P;
  }

  const model::Parameters<S>& a_;
  S tau_, x_, rho_, rate_, C_, load_;  // load_ is sigma p
  std::array<Mode, 2> modes_;
};

// `is_symmetric`: the motion is an orbit of Section 4, of which det(I - M) has two factors.
template <class S>
[[nodiscard]] ExitFactors<S> exit_factors(const MotionOf<S>& motion, bool is_symmetric = false) {
  const std::vector<S> c = multiplier_coefficients(motion);
  ExitFactors<S> result{{}, c.back()};
  for (const Exit exit : exits) {
    result.of[static_cast<std::size_t>(exit)] = {exit_function(exit, c)};
  }
  if (is_symmetric) {
    result.of[static_cast<std::size_t>(Exit::plus_one)] = SymmetricExits<S>(motion).at_one();
  }
  return result;
}

// Of all motions of a proof (zeros/parametric.hpp), each of which obeys the friction law: by their jets, and
// the one at the middle. Where one of the exit functions is negative a multiplier is outside the unit circle;
// where none vanishes as many are outside all over the box as at its middle. Nothing where that decides
// nothing. `is_symmetric`: all are orbits of Section 4.
[[nodiscard]] std::optional<StabilityKind> stability_over(const zeros::ParametricProof& proof,
                                                          const MotionOf<zeros::ParameterJet>& jets,
                                                          const Motion& middle, bool is_symmetric);

}  // namespace stickslip::numeric::motion
