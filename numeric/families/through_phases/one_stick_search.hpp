// The definitions of one_stick_closing.hpp, for the source files that make its problems.
#pragma once

#include "numeric/families/through_phases/end_rows.hpp"
#include "numeric/families/through_phases/one_stick_rows.hpp"

namespace stickslip::numeric::families {

template <class T, int N, Datum G>
FirstRows<OneStick<N, G>, T> first_rows(const OneStick<N, G>& problem, const Eigen::Matrix<T, N, 1>& x) {
  return odd_rows<N, G, T>(data_over<T>(problem), x);
}
template <class T, int N, Datum G>
OtherRows<OneStick<N, G>, T> other_rows(const OneStick<N, G>& problem, const Eigen::Matrix<T, N, 1>& x) {
  return even_rows<N, G, T>(data_over<T>(problem), x);
}

// phi given: the odd rows are left C + right = 0, and their determinant must vanish. ur given: determinants
// with C say sin psi, and nothing is left where |sin psi| > 1: sin psi ∓ 1, times the determinant of (C, sin
// psi), have one sign.
template <int N, Datum G>
std::optional<FastBox<N>> look(const OneStick<N, G>& /*problem*/,
                               const FirstRows<OneStick<N, G>, FastJet<N>>& over,
                               const FirstRows<OneStick<N, G>, scalars::HardwareBall>& at_m,
                               const HardwareBox<N>& box) {
  const auto minor = [](const auto& x, int k) {
    using T = std::decay_t<decltype(x(0, 0))>;
    return det2<T>(x(0, k), x(0, 1), x(1, k), x(1, 1));
  };
  constexpr int one = OneStick<N, G>::columns - 1;
  if constexpr (G == Datum::phase) {
    return contracted<N>(minor(over, one), minor(at_m, one), box.m, box.X);
  } else {
    const auto range = [&](int sign) {
      const FastJet<N> jet = minor(over, one) - FastJet<N>(sign) * minor(over, one - 1);
      scalars::HardwareBall form = minor(at_m, one) - scalars::HardwareBall(sign) * minor(at_m, one - 1);
      for (int i = 0; i < N; ++i) {
        form += jet.partials[static_cast<std::size_t>(i)] * box.spread(i);
      }
      return scalars::intersection(form, jet.value).value_or(form);
    };
    const scalars::HardwareBall below = range(-1), above = range(1);
    const bool outside =
        (below.is_positive() && above.is_positive()) || (below.is_negative() && above.is_negative());
    return outside ? std::nullopt : std::optional(box.X);
  }
}

// omega = n/k, one or two times: the coefficients of C and sin psi vanish like t³, t = tau + tau1, and the
// rest does not.
template <int N, Datum G>
bool is_excluded(const OneStick<N, G>& problem, const zeros::Box<N>& X) {
  if constexpr (N == 3) {
    return false;
  }
  if (problem.sound_at_origin || !X(0).contains_zero()) {
    return false;
  }
  const OneStickData<Ball>& data = problem.exact;
  const auto [tau, tau1] = both_times<Ball, N>(times<Ball, N>(data.d.Theta, X));
  const model::Modes<Ball>& m = data.d.m;
  const Ball total = tau + tau1;
  const EndRows end{m, data.d.omega, total};
  const auto odd = odd_rows<N, G, Ball>(data, X);
  const Ball left1 = end.left(m.omega1, m.lambda2);
  const Ball left2 = end.left(m.omega2, m.lambda1);
  constexpr int one = OneStick<N, G>::columns - 1;
  const Ball rest = det2<Ball>(odd(0, one), left1, odd(1, one), left2);
  if (G == Datum::phase) {
    return end.applies() && odd(0, one).is_nonzero() && rest.is_nonzero();
  }
  const Ball load1 = data.d.p * end.transfer(m.omega1, data.d.omega);
  const Ball load2 = data.d.p * end.transfer(m.omega2, data.d.omega);
  const Ball most = abs(det2<Ball>(left1, load1, left2, load2)) * total * total * total;
  return end.applies() && (abs(rest) - most).is_positive();
}

template <int N, Datum G>
OneStick<N, G>::OneStick(const OneStickData<Ball>& data, bool is_sound)
    : exact(data), fast(lifted<scalars::HardwareBall>(data)), sound_at_origin(is_sound) {}

template <int N, Datum G>
std::optional<ClosedTimes<N>> OneStick<N, G>::motion_at(const LinearEliminant<OneStick>& f,
                                                        const zeros::Box<N>& x) {
  const auto linear = f.linear(x);
  if (!linear) {
    return std::nullopt;
  }
  const OneStickData<Ball>& data = f.problem.exact;
  const zeros::Box<N> t = f.problem.durations(x);
  const Ball total = t.sum();
  ClosedTimes<N> result{t, data.d.Theta - total, {}, data.given};
  if (linear->cos_sin_psi) {
    result.phi = angle(*linear->cos_sin_psi, -data.d.omega * total / Ball(2));
  }
  const auto& u = linear->amplitudes;
  result.Z0 = model::overshooting_start<Ball>(data.d, result.stick, u(0), u(1), u(2));
  return result;
}

}  // namespace stickslip::numeric::families
