// A symmetric orbit over a box of parameters: what it has to obey, and its multipliers, in the few functions
// that its symmetry leaves. Nothing here is singular where omega is a natural frequency.
//
// With s the time from the middle of a phase (model/symmetric.hpp) both phases are odd. On the stick
//   z2 = V s,  z1 = chi V s + C sin s,  load's phase omega s + 3 pi/2 (sigma = 1) or that plus pi, so by (4)
//   r - us = rho(s) = chi (1 - chi) V s - chi C sin s - sigma (p/eta) sin(omega s).
// It ends at r = ur: ur - us = rho(T/2), by definition of ur. Since rho is odd, the friction when the stick
// begins is us - rho(T/2), and of the requirements, given us > 0 and ur > us,
//   (12) says ur > us;  (14) says -(ur + us) < -(ur - us) < ur - us;  f1, rho <= ur - us all along, gives
//   rho >= -(ur - us) > -(ur + us), f2.
// So an orbit is admissible if and only if us > 0, ur > us, z2' < V on the slip, and f1.
//
// On the slip each modal coordinate obeys y_j'' + omega_j² y_j = p_j cos(load's phase), that phase being
// omega s + pi/2 (sigma = 1) or that plus pi, p_j = ∓p/(lambda_2 - lambda_1) for j = 1, 2. Odd solutions are
//   y_j = b_j sin(omega_j s) + sigma p_j D_j(s),  D_j = (sin(omega_j s) - sin(omega s))/(omega_j² - omega²)
//       = s cos((omega_j + omega) s/2) sinc((omega_j - omega) s/2)/(omega_j + omega),
//   D_j' = (cos(omega s) - omega_j s sin((omega_j + omega) s/2) sinc((omega_j - omega) s/2))/(omega_j +
//   omega), D_j'' = -omega_j² D_j - sin(omega s);
// and z2' = sum of lambda_j y_j' is even: half of the slip tells all.
#pragma once

#include <array>
#include <utility>

#include "numeric/atlas/along.hpp"
#include "numeric/atlas/multipliers.hpp"
#include "numeric/atlas/sheets.hpp"

namespace stickslip::numeric::atlas {

template <class T>
class SymmetricOrbit {
 public:
  // The orbit of the sheet at the share u; nothing when C may be unbounded.
  [[nodiscard]] static std::optional<SymmetricOrbit> at(const Sheet& sheet, const Setting<T>& s, const T& u,
                                                        const std::optional<T>& /*ur*/) {
    const model::SymmetricData<T> data = symmetric_data(s, sheet.sign);
    const T tau = data.Theta * u;
    const model::SymmetricRows<T> rows = model::symmetric_rows<T>(data, tau);
    const auto size = [&](int j) { return std::abs(rows.left(j).at.approximate()); };
    const int j = size(0) > size(1) ? 0 : 1;
    if (!rows.left(j).over.is_nonzero()) {
      return std::nullopt;
    }
    return SymmetricOrbit(data, tau, T(rows.right(j) / rows.left(j)));
  }

  // Whether it obeys the requirement; one that follows from the others counts as proved.
  [[nodiscard]] Decision holds(const motion::Requirement& q, double least, Times& open) const {
    switch (q.quantity) {
      case motion::Quantity::slipping_friction:
        return decide_positive(a_.us);
      case motion::Quantity::friction_step:
        return decide_positive(step_);
      case motion::Quantity::below_belt: {
        const auto speed = slip();
        const auto below = [&](const T& s) {
          const auto [value, slope] = speed(s);
          return std::array<T, 2>{T(a_.V - value), T(-slope)};
        };
        return is_positive_along<T>(below, T(tau_ / T(2)), {false, true}, least, open);
      }
      case motion::Quantity::below_ur: {
        if (!q.along) {
          return {Truth::proved};
        }
        const auto below = [&](const T& t) {
          const auto [value, slope] = rho(T(t - T_ / T(2)));
          return std::array<T, 2>{T(step_ - value), T(-slope)};
        };
        return is_positive_along<T>(below, T_, q.touches, least, open);
      }
      default:
        return {Truth::proved};
    }
  }

  [[nodiscard]] Decision stability() const { return is_inside_unit_circle<T>(multipliers(), at_one()); }

  // e1, e2, e3 of the multipliers.
  [[nodiscard]] std::array<T, 3> multipliers() const {
    return symmetric_functions<T>(a_.chi, a_.m, tau_, T_, kappa());
  }

  // det(I - M)/p, M the derivative of the return map. For p = 0 the speed along the orbit is a multiplier's
  // vector with multiplier 1; so det(I - M) is small for small p, and this is not.
  //
  // A deviation that returns after a period splits into one whose z is odd about the middles of both phases,
  // and one whose z is even, because both flows are reversible; only in the even one does anything deviate in
  // r. With (c_j, s_j) = (cos, sin)(omega_j tau/2), P_j of model/symmetric.hpp, amplitudes B_j, A_j
  // on the slip and the stick's eliminated, continuity of z1, z2, z1', and z2' = kappa (z2 - z1) at the
  // break-away are
  //   odd:   sum of P_j B_j = 0,  sum of lambda_j s_j B_j = 0;
  //   even:  sum of omega_j P_j A_j = 0,  sum of E_j A_j = 0,  E_j = lambda_j omega_j s_j - kappa (lambda_j -
  //   1) c_j.
  // det(I - M) is the determinant of all seven conditions, before the elimination, with H and Gamma of
  // determinant 1 and det Lambda = d = lambda_2 - lambda_1 divided out:
  //   det(I - M) = 8/(d² omega_1 omega_2) (lambda_2 s_2 P_1 - lambda_1 s_1 P_2) N,
  //   N = omega_1 P_1 E_2 - omega_2 P_2 E_1.
  // The orbit's own velocity is even, and meets the even conditions except for the load: with A_j = omega_j
  // b_j,
  //   sum of omega_j P_j A_j = sigma p rho_1,  sum of E_j A_j = sigma p rho_2,
  // so by Cramer's rule N (A_1² + A_2²) = sigma p (A_1 (rho_1 E_2 - rho_2 omega_2 P_2)
  //                                              + A_2 (omega_1 P_1 rho_2 - E_1 rho_1)).
  [[nodiscard]] T at_one() const {
    const std::array<Mode, 2>& m = modes();
    const auto [sine, cosine] = sin_cos(T(T_ / T(2)));
    const T k = kappa();
    const T to_load = a_.omega * T(cos(T(a_.omega * T_ / T(2))));
    T rho1(0);  // with sigma
    T rho2 = a_.eta * step_ / rate_ * a_.sigma * to_load / a_.eta;
    std::array<T, 2> A, P, E;
    for (std::size_t j = 0; j < 2; ++j) {
      const T& w = m[j].omega;
      A[j] = w * m[j].b;
      P[j] = model::stick_transfer<T>(w, a_.Theta, tau_).odd;
      E[j] = m[j].lambda * w * m[j].sine - k * T((m[j].lambda - T(1)) * m[j].cosine);
      rho1 += m[j].push * T(cosine * m[j].D_dot2 - sine * w * w * m[j].D_dot);
      rho2 += m[j].push * T(m[j].lambda * m[j].D_dot2 + k * T((m[j].lambda - T(1)) * m[j].D_dot));
    }
    const T d = a_.m.lambda2 - a_.m.lambda1;
    const T odd = m[1].lambda * m[1].sine * P[0] - m[0].lambda * m[0].sine * P[1];
    const T even =
        A[0] * T(rho1 * E[1] - rho2 * m[1].omega * P[1]) + A[1] * T(m[0].omega * P[0] * rho2 - E[0] * rho1);
    return T(8) * odd * even / T(d * d * m[0].omega * m[1].omega * T(A[0] * A[0] + A[1] * A[1]));
  }

  // rho and its derivative.
  [[nodiscard]] std::array<T, 2> rho(const T& s) const {
    const auto [sine, cosine] = sin_cos(s);
    const auto [load_sine, load_cosine] = sin_cos(T(a_.omega * s));
    return {T(stiffness_ * s - kick_ * sine - load_ * load_sine),
            T(stiffness_ - kick_ * cosine - load_ * a_.omega * load_cosine)};
  }

 private:
  // chi x2''(0+)/r' at the break-away.
  [[nodiscard]] T kappa() const { return -a_.chi * a_.eta * step_ / rate_; }

  SymmetricOrbit(const model::SymmetricData<T>& a, const T& tau, const T& C)
      : a_(a),
        tau_(tau),
        T_(a.Theta - tau),
        C_(C),
        stiffness_(a.chi * (T(1) - a.chi) * a.V),
        kick_(a.chi * C),
        load_(a.sigma * a.p / a.eta) {
    const std::array<T, 2> at_break_away = rho(T(T_ / T(2)));
    step_ = at_break_away[0];
    rate_ = at_break_away[1];
  }

  // A modal coordinate on the slip; sine and cosine at alpha = omega tau/2, D and its derivatives at tau/2.
  struct Mode {
    T omega, lambda;
    T push;  // sigma p_j/p
    T b;
    T sine, cosine, D, D_dot, D_dot2;
  };
  // Computed once, when they are first asked for.
  [[nodiscard]] const std::array<Mode, 2>& modes() const {
    if (modes_) {
      return *modes_;
    }
    const model::Vector4<T> Z0 = model::symmetric_start<T>(a_, tau_, C_);
    const T det = a_.m.lambda2 - a_.m.lambda1;
    const T half = tau_ / T(2);
    const std::pair<T, T> load = sin_cos(T(a_.omega * half));
    const T &load_sine = load.first, &load_cosine = load.second;
    const auto mode = [&](const T& omega, const T& lambda, const T& other, int sign) {
      // y_j and y_j' at s = -tau/2, where y_j is odd: b_j from sin² + cos² = 1.
      const T y = T(sign) * (Z0(1) - other * Z0(0)) / det;
      const T ydot = T(sign) * (Z0(3) - other * Z0(2)) / det;
      const T push = T(sign) * a_.sigma / det;
      const T sum = omega + a_.omega;
      const T wide = half * sinc(T((omega - a_.omega) * half / T(2)));
      const auto [beat_sine, beat_cosine] = sin_cos(T(sum * half / T(2)));
      const T D = beat_cosine * wide / sum;
      const T D_dot = (load_cosine - omega * beat_sine * wide) / sum;
      const auto [sine, cosine] = sin_cos(T(omega * half));
      const T b = T((ydot - a_.p * push * D_dot) / omega) * cosine - T(y + a_.p * push * D) * sine;
      return Mode{omega, lambda, push, b, sine, cosine, D, D_dot, T(-omega * omega * D - load_sine)};
    };
    modes_.emplace(std::array<Mode, 2>{mode(a_.m.omega1, a_.m.lambda1, a_.m.lambda2, -1),
                                       mode(a_.m.omega2, a_.m.lambda2, a_.m.lambda1, 1)});
    return *modes_;
  }

  // z2' and its derivative as functions of s: what does not depend on s is computed once.
  [[nodiscard]] auto slip() const {
    struct Wave {
      T omega, sum, difference;    // omega_j, and half of what omega_j and omega make
      T free, forced;              // of cos(omega_j s), and of D_j'
      T free_slope, forced_slope;  // the same with omega_j
    };
    const auto wave = [this](const Mode& m) {
      const T free = m.lambda * m.omega * m.b;
      const T forced = m.lambda * a_.p * m.push / T(m.omega + a_.omega);
      return Wave{m.omega,
                  T((m.omega + a_.omega) / T(2)),
                  T((m.omega - a_.omega) / T(2)),
                  free,
                  forced,
                  T(free * m.omega),
                  T(forced * m.omega)};
    };
    const std::array<Mode, 2>& m = modes();
    const T of_cosine = T(m[0].lambda * m[0].push / T(m[0].omega + a_.omega) +
                          m[1].lambda * m[1].push / T(m[1].omega + a_.omega)) *
                        a_.p;
    const T of_sine = T(m[0].lambda * m[0].push + m[1].lambda * m[1].push) * a_.p;
    return [waves = std::array<Wave, 2>{wave(m[0]), wave(m[1])}, of_cosine, of_sine,
            omega = a_.omega](const T& s) {
      const auto [load_sine, load_cosine] = sin_cos(T(omega * s));
      std::array<T, 2> speed{T(of_cosine * load_cosine), T(-of_sine * load_sine)};
      for (const Wave& w : waves) {
        const auto [sine, cosine] = sin_cos(T(w.omega * s));
        const T wide = w.forced_slope * T(s * sinc(T(w.difference * s)));
        const auto [beat_sine, beat_cosine] = sin_cos(T(w.sum * s));
        speed[0] += w.free * cosine - beat_sine * wide;
        speed[1] -= w.free_slope * sine + w.omega * T(beat_cosine * wide);
      }
      return speed;
    };
  }

  model::SymmetricData<T> a_;
  T tau_, T_, C_;
  T stiffness_, kick_, load_;
  T step_;  // ur - us
  T rate_;  // of r at the break-away
  mutable std::optional<std::array<Mode, 2>> modes_;
};

}  // namespace stickslip::numeric::atlas
