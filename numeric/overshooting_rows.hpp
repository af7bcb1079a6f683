// The reduced equations of Section 5 as two functions of (s, w), tau + tau1 = Theta s, tau1 = Theta s w, with
// the amplitudes, and the load's phase where it is unknown, eliminated by determinants.
//
// Each family is a functor for krawczyk.hpp and search.hpp over T = Ball and jets over it.
#pragma once

#include "model/overshooting_closing.hpp"
#include "numeric/jet.hpp"

namespace stickslip {

template <class T>
struct Times {
  T tau, tau1;
};

template <class T>
[[nodiscard]] Times<T> times(const T& Theta, const Eigen::Matrix<T, 2, 1>& sw) {
  const T total = Theta * sw(0);
  const T tau1 = total * sw(1);
  return {T(total - tau1), tau1};
}

template <class T>
[[nodiscard]] T det2(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}

// Of rows i, j, k in the columns l, m, n.
template <class T, int Rows, int Columns>
[[nodiscard]] T det3(const Eigen::Matrix<T, Rows, Columns>& x, std::array<int, 3> row,
                     std::array<int, 3> column) {
  const auto [i, j, k] = row;
  const auto [l, m, n] = column;
  return x(i, l) * det2<T>(x(j, m), x(j, n), x(k, m), x(k, n)) -
         x(i, m) * det2<T>(x(j, l), x(j, n), x(k, l), x(k, n)) +
         x(i, n) * det2<T>(x(j, l), x(j, m), x(k, l), x(k, m));
}

// By Laplace's expansion in the first two rows.
template <class T>
[[nodiscard]] T det4(const Eigen::Matrix<T, 4, 4>& x) {
  const auto upper = [&](int i, int j) { return det2<T>(x(0, i), x(0, j), x(1, i), x(1, j)); };
  const auto lower = [&](int i, int j) { return det2<T>(x(2, i), x(2, j), x(3, i), x(3, j)); };
  return upper(0, 1) * lower(2, 3) - upper(0, 2) * lower(1, 3) + upper(0, 3) * lower(1, 2) +
         upper(1, 2) * lower(0, 3) - upper(1, 3) * lower(0, 2) + upper(2, 3) * lower(0, 1);
}

// phi given. Each odd row is left C + right = 0; the even rows and turn are linear in (a, D, 1), with C
// eliminated through the odd row `pivot`.
template <class S>
struct OvershootingAtPhase {
  model::OvershootingData<S> data;
  S phi;
  int pivot = 0;

  template <class T>
  struct Odd {
    Eigen::Matrix<T, 2, 1> left, right;
  };

  // (sin psi, cos psi).
  template <class T>
  [[nodiscard]] std::pair<T, T> phase(const model::OvershootingData<T>& d, const Times<T>& t) const {
    return sin_cos(T(T(phi) + d.omega * T(t.tau + t.tau1) / T(2)));
  }

  template <class T>
  [[nodiscard]] Odd<T> odd(const model::OvershootingData<T>& d, const Times<T>& t) const {
    const T sin_psi = phase<T>(d, t).first;
    const auto rows = model::overshooting_odd<T>(d, t.tau, t.tau1);
    return {{rows[0].C, rows[1].C},
            {T(rows[0].one + rows[0].sin_psi * sin_psi), T(rows[1].one + rows[1].sin_psi * sin_psi)}};
  }

  // Columns a, D, 1 of even_1, even_2 and of turn times the pivot's left side.
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 3, 3> even(const model::OvershootingData<T>& d, const Times<T>& t,
                                            const Odd<T>& o) const {
    const auto [s, c] = phase<T>(d, t);
    const auto rows = model::overshooting_even<T>(d, t.tau, t.tau1);
    const model::OvershootingRow<T> turn = model::overshooting_turn<T>(d, t.tau, t.tau1);
    Eigen::Matrix<T, 3, 3> m;
    for (int j = 0; j < 2; ++j) {
      const model::OvershootingRow<T>& row = rows[static_cast<std::size_t>(j)];
      m(j, 0) = row.a;
      m(j, 1) = row.D;
      m(j, 2) = row.one + row.cos_psi * c;
    }
    const T& left = o.left(pivot);
    m(2, 0) = turn.a * left;
    m(2, 1) = turn.D * left;
    m(2, 2) = T(turn.one + turn.cos_psi * c + turn.sin_psi * s) * left - turn.C * o.right(pivot);
    return m;
  }

  // The determinant of the odd rows alone: cheap, and enough to exclude most of the triangle.
  template <class T>
  [[nodiscard]] T first(const Eigen::Matrix<T, 2, 1>& sw) const {
    const model::OvershootingData<T> d = model::lift<T>(data);
    const Odd<T> o = odd<T>(d, times<T>(d.Theta, sw));
    return det2<T>(o.left(0), o.right(0), o.left(1), o.right(1));
  }

  // Both determinants.
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& sw) const {
    const model::OvershootingData<T> d = model::lift<T>(data);
    const Times<T> t = times<T>(d.Theta, sw);
    const Odd<T> o = odd<T>(d, t);
    const Eigen::Matrix<T, 3, 3> m = even<T>(d, t, o);
    return {det2<T>(o.left(0), o.right(0), o.left(1), o.right(1)), det3<T, 3, 3>(m, {0, 1, 2}, {0, 1, 2})};
  }
};

// u_r given, phi unknown. The odd rows are linear in (C, sin psi, 1); their 2×2 minors give C and sin psi
// over the common denominator `over`. The even rows, turn and (12), times that denominator, are linear in
// (a, D, cos psi, 1); the three rows other than `left_out` give cos psi. The two functions are the
// determinant of the four rows and cos² psi + sin² psi - 1 times the squares of its denominators.
template <class S>
struct OvershootingAtFriction {
  model::OvershootingData<S> data;
  S ur;
  int left_out = 3;

  template <class T>
  struct Odd {
    T C, sin_psi, over;
  };

  template <class T>
  [[nodiscard]] Odd<T> odd(const model::OvershootingData<T>& d, const Times<T>& t) const {
    const auto [x, y] = model::overshooting_odd<T>(d, t.tau, t.tau1);
    return {det2<T>(x.sin_psi, x.one, y.sin_psi, y.one), det2<T>(x.one, x.C, y.one, y.C),
            det2<T>(x.C, x.sin_psi, y.C, y.sin_psi)};
  }

  // Columns a, D, cos psi and 1 times `over` of even_1, even_2, turn and (12).
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 4, 4> rows(const model::OvershootingData<T>& d, const Times<T>& t,
                                            const Odd<T>& o) const {
    const auto [even1, even2] = model::overshooting_even<T>(d, t.tau, t.tau1);
    const std::array<model::OvershootingRow<T>, 4> all{
        even1, even2, model::overshooting_turn<T>(d, t.tau, t.tau1),
        model::overshooting_friction<T>(d, T(ur), t.tau, t.tau1)};
    Eigen::Matrix<T, 4, 4> m;
    for (int i = 0; i < 4; ++i) {
      const model::OvershootingRow<T>& row = all[static_cast<std::size_t>(i)];
      m(i, 0) = row.a;
      m(i, 1) = row.D;
      m(i, 2) = row.cos_psi;
      m(i, 3) = row.one * o.over + row.C * o.C + row.sin_psi * o.sin_psi;
    }
    return m;
  }

  // The rows other than left_out.
  [[nodiscard]] std::array<int, 3> kept() const {
    std::array<int, 3> rows{};
    for (int i = 0, k = 0; i < 4; ++i) {
      if (i != left_out) {
        rows[static_cast<std::size_t>(k++)] = i;
      }
    }
    return rows;
  }

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& sw) const {
    const model::OvershootingData<T> d = model::lift<T>(data);
    const Times<T> t = times<T>(d.Theta, sw);
    const Odd<T> o = odd<T>(d, t);
    const Eigen::Matrix<T, 4, 4> m = rows<T>(d, t, o);
    const T scale = det3<T, 4, 4>(m, kept(), {0, 1, 2});
    const T cosine = det3<T, 4, 4>(m, kept(), {0, 1, 3});  // -cos psi scale over
    const T sine = o.sin_psi * scale;
    const T unit = o.over * scale;
    return {det4<T>(m), T(cosine * cosine + T(sine - unit) * T(sine + unit))};
  }
};

}  // namespace stickslip
