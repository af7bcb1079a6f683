#include "numeric/families/through_phases/two_sticks.hpp"

#include "model/flows.hpp"
#include "model/parameters.hpp"
#include "numeric/families/through_phases/linear_closing_search.hpp"

namespace stickslip::numeric::families {

using scalars::HardwareBall;

template <class T, class S>
TwoSticksData<T> lifted(const TwoSticksData<S>& d) {
  return {model::lift<T>(d), T(d.ur), d.sign};
}

namespace {

// t, T1, t', T2.
template <class T>
std::array<T, 4> all_durations(const T& total, const Eigen::Matrix<T, 3, 1>& x) {
  const T first = total * x(0), rest = total - first;
  const T t = first * x(1), later = rest * x(2);
  return {t, T(first - t), later, T(rest - later)};
}

template <class T>
using Row = Eigen::Matrix<T, 1, TwoSticks::columns>;
constexpr int cos_psi = 6, sin_psi = 7, one = 8;

// A phase between two sticks: its duration, half those of the sticks before and after it, where their
// amplitudes stand, and by how much the load's phase at its middle is later than psi.
template <class T>
struct Between {
  T t;
  std::pair<T, T> before, after;  // sine and cosine of half the duration
  T half_before, half_after;
  int amplitudes_before, amplitudes_after;
  std::pair<T, T> load;  // sine and cosine of what it is later
  T friction;            // ± eta us
};

template <class T>
std::array<Between<T>, 2> phases_between(const TwoSticksData<T>& d, const Eigen::Matrix<T, 3, 1>& x) {
  const std::array<T, 4> t = all_durations<T>(d.Theta, x);
  const T half1 = t[1] / T(2), half2 = t[3] / T(2);
  const std::pair<T, T> stick1 = sin_cos(half1), stick2 = sin_cos(half2);
  const T force = d.eta * d.us;
  return {{{t[0], stick2, stick1, half2, half1, 3, 0, sin_cos(T(-d.omega * T(t[1] + t[0]) / T(2))),
            d.sign[0] > 0 ? force : T(-force)},
           {t[2], stick1, stick2, half1, half2, 0, 3, sin_cos(T(d.omega * T(t[1] + t[2]) / T(2))),
            d.sign[1] > 0 ? force : T(-force)}}};
}

// A mode: its frequency, the other one's and its lambda.
template <class T>
struct Mode {
  const T &omega, &other, &lambda;
};
template <class T>
std::array<Mode<T>, 2> both_modes(const model::Modes<T>& m) {
  return {{{m.omega1, m.omega2, m.lambda2}, {m.omega2, m.omega1, m.lambda1}}};
}

template <class T>
Row<T> zero_row() {
  return Row<T>::Constant(T(0));
}

// odd_j; ± eta us has no part that is odd in s.
template <class T>
Row<T> odd(const TwoSticksData<T>& d, const Between<T>& b, const Mode<T>& j) {
  const T half = b.t / T(2);
  const std::pair<T, T> alpha = sin_cos(T(j.omega * half));
  const T c = j.omega * alpha.second / T(2), s = alpha.first / T(2);
  const T square = j.other * j.other;
  Row<T> row = zero_row<T>();
  row(b.amplitudes_after) = -square * c;
  row(b.amplitudes_before) = square * c;
  row(b.amplitudes_after + 1) = -j.lambda * T(c * b.after.first + s * b.after.second);
  row(b.amplitudes_before + 1) = -j.lambda * T(c * b.before.first + s * b.before.second);
  row(b.amplitudes_after + 2) = j.lambda * T(c * b.after.second - s * b.after.first);
  row(b.amplitudes_before + 2) = -j.lambda * T(c * b.before.second - s * b.before.first);
  row(one) = d.V * square * T(c * T(b.half_before + b.half_after) + T(2) * s);
  // S_j = -S sin(psi_b): the load's part is odd in s for sin(psi_b).
  const T load = d.p * model::load_transfer<T>(j.omega, d.omega, b.t);
  row(cos_psi) = load * b.load.first;
  row(sin_psi) = load * b.load.second;
  return row;
}

// What even_j is made of, divided by t/2 except for the velocities: amplitudes, load and friction.
template <class T>
struct Even {
  T sine;      // omega_j sin(alpha_j)/(t/2)
  T load;      // half the sum of two sincs, times p
  T friction;  // sinc(alpha_j), times ± eta us
};
template <class T>
Even<T> even(const TwoSticksData<T>& d, const Between<T>& b, const T& omega_j) {
  const T half = b.t / T(2);
  const T s = T(sinc(T(omega_j * half)));
  const T near = T(sinc(T((omega_j - d.omega) * half))), far = T(sinc(T((omega_j + d.omega) * half)));
  return {T(omega_j * omega_j * s), T(d.p * T(near + far) / T(2)), T(b.friction * s)};
}

// even_j, or a sum of multiples of both: s for lambda_k omega_j sin(alpha_j)/2, `sine_of_place` for omega_k²
// omega_j sin(alpha_j)/2, `cosine` for lambda_k cos(alpha_j)/2; load and friction are halves of the
// integrals.
template <class T>
Row<T> even_row(const TwoSticksData<T>& d, const Between<T>& b, const T& s, const T& sine_of_place,
                const T& cosine, const T& load, const T& friction) {
  Row<T> row = zero_row<T>();
  row(b.amplitudes_after) = -sine_of_place;
  row(b.amplitudes_before) = -sine_of_place;
  row(b.amplitudes_after + 1) = cosine * b.after.second - s * b.after.first;
  row(b.amplitudes_before + 1) = s * b.before.first - cosine * b.before.second;
  row(b.amplitudes_after + 2) = s * b.after.second + cosine * b.after.first;
  row(b.amplitudes_before + 2) = s * b.before.second + cosine * b.before.first;
  row(one) = friction - sine_of_place * d.V * T(b.half_before - b.half_after);
  row(cos_psi) = load * b.load.second;
  row(sin_psi) = -load * b.load.first;
  return row;
}

template <class T>
std::array<Row<T>, 2> even_rows(const TwoSticksData<T>& d, const Between<T>& b) {
  const T &w1 = d.m.omega1, &w2 = d.m.omega2, &l1 = d.m.lambda1, &l2 = d.m.lambda2;
  const T half = b.t / T(2);
  const Even<T> e1 = even<T>(d, b, w1), e2 = even<T>(d, b, w2);
  const T sine1 = e1.sine * half / T(2);
  const Row<T> first =
      even_row<T>(d, b, T(l2 * sine1), T(w2 * w2 * sine1), T(l2 * T(cos(T(w1 * half))) / T(2)),
                  T(e1.load * half), T(e1.friction * half));
  // (cos(alpha_1) - cos(alpha_2))/(t/2), the difference a product.
  const T below = T(w1 - w2) / T(2);
  const T cosines = T(-2) * T(sin(T(T(w1 + w2) / T(2) * half))) * T(below * T(sinc(T(below * half))));
  const Row<T> second =
      even_row<T>(d, b, T(l1 * l2 * T(e1.sine - e2.sine) / T(2)),
                  T(T(l1 * w2 * w2 * e1.sine - l2 * w1 * w1 * e2.sine) / T(2)), T(l1 * l2 * cosines / T(2)),
                  T(l1 * e1.load - l2 * e2.load), T(l1 * e1.friction - l2 * e2.friction));
  return {first, second};
}

// The stick before the phase ends with r = ± ur: chi (x2 - x1) - p/eta cos(load) ∓ ur = 0.
template <class T>
Row<T> friction_row(const TwoSticksData<T>& d, const Between<T>& b, int sign, const T& load_later) {
  const T stiffness = d.chi * T(T(1) - d.chi);
  const std::pair<T, T> load = sin_cos(load_later);
  Row<T> row = zero_row<T>();
  row(b.amplitudes_before) = stiffness;
  row(b.amplitudes_before + 1) = -d.chi * b.before.first;
  row(b.amplitudes_before + 2) = -d.chi * b.before.second;
  row(cos_psi) = -d.p / d.eta * load.second;
  row(sin_psi) = d.p / d.eta * load.first;
  row(one) = stiffness * d.V * b.half_before - (sign > 0 ? d.ur : T(-d.ur));
  return row;
}

}  // namespace

// odd_1 and odd_2 of both phases.
template <class T>
FirstRows<TwoSticks, T> first_rows(const TwoSticks& problem, const Eigen::Matrix<T, 3, 1>& x) {
  const TwoSticksData<T> d = data_over<T>(problem);
  FirstRows<TwoSticks, T> rows;
  int i = 0;
  for (const Between<T>& b : phases_between<T>(d, x)) {
    for (const Mode<T>& j : both_modes<T>(d.m)) {
      rows.row(i++) = odd<T>(d, b, j);
    }
  }
  return rows;
}

template <class T>
OtherRows<TwoSticks, T> other_rows(const TwoSticks& problem, const Eigen::Matrix<T, 3, 1>& x) {
  const TwoSticksData<T> d = data_over<T>(problem);
  const std::array<T, 4> t = all_durations<T>(d.Theta, x);
  const std::array<Between<T>, 2> between = phases_between<T>(d, x);
  // How much later than psi the load is where either phase begins.
  const std::array<T, 2> begins{T(-d.omega * T(t[1] / T(2) + t[0])), T(d.omega * t[1] / T(2))};
  OtherRows<TwoSticks, T> rows;
  int i = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const Row<T>& row : even_rows<T>(d, between[k])) {
      rows.row(i++) = row;
    }
    rows.row(i++) = friction_row<T>(d, between[k], d.sign[k], begins[k]);
  }
  return rows;
}

// The first rows say nothing alone.
std::optional<FastBox<3>> look(const TwoSticks& /*problem*/, const FirstRows<TwoSticks, FastJet<3>>& /*over*/,
                               const FirstRows<TwoSticks, HardwareBall>& /*at_m*/,
                               const HardwareBox<3>& box) {
  return box.X;
}

bool is_excluded(const TwoSticks& /*problem*/, const zeros::Box<3>& /*X*/) {
  return false;
}

TwoSticks::TwoSticks(const TwoSticksData<Ball>& data) : exact(data), fast(lifted<HardwareBall>(data)) {}

std::optional<ClosedTimes<3>> TwoSticks::motion_at(const LinearEliminant<TwoSticks>& f,
                                                   const zeros::Box<3>& x) {
  const auto linear = f.linear(x);
  if (!linear) {
    return std::nullopt;
  }
  const TwoSticksData<Ball>& d = f.problem.exact;
  const std::array<Ball, 4> t = all_durations<Ball>(d.Theta, x);
  const auto& u = linear->amplitudes;
  model::Vector4<Ball> Z0 = model::overshooting_start<Ball>(d, t[3], u(3), u(4), u(5));
  Z0.head<2>() -= model::d0<Ball>(d.chi, d.us);
  return ClosedTimes<3>{zeros::Box<3>(t[0], t[1], t[2]), t[3], Z0,
                        angle(*linear->cos_sin_psi, -d.omega * (t[0] + t[1] / Ball(2)))};
}

template struct LinearEliminant<TwoSticks>;

}  // namespace stickslip::numeric::families
