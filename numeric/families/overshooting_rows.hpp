// The reduced equations of Section 5 as rows over (s, w), tau + tau1 = Theta s, tau1 = Theta s w, that are
// linear in the amplitudes a, C, D of the stick and, where the load's phase is unknown, in its cosine and
// sine.
#pragma once

#include "model/overshooting_closing.hpp"
#include "numeric/zeros/elimination.hpp"

namespace stickslip::numeric::families {

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

// By Laplace's expansion in the first two rows.
template <class T>
[[nodiscard]] T det4(const Eigen::Matrix<T, 4, 4>& x) {
  const auto upper = [&](int i, int j) { return det2<T>(x(0, i), x(0, j), x(1, i), x(1, j)); };
  const auto lower = [&](int i, int j) { return det2<T>(x(2, i), x(2, j), x(3, i), x(3, j)); };
  return upper(0, 1) * lower(2, 3) - upper(0, 2) * lower(1, 3) + upper(0, 3) * lower(1, 2) +
         upper(1, 2) * lower(0, 3) - upper(1, 3) * lower(0, 2) + upper(2, 3) * lower(0, 1);
}

// phi given: five rows for (a, C, D).
template <class S>
struct OvershootingAtPhaseOf {
  static constexpr int rows = 5;
  static constexpr int unknowns = 3;
  model::OvershootingData<S> data;
  S phi;

  template <class T, int R>
  using Rows = Eigen::Matrix<T, R, unknowns + 1>;

  // odd_1 and odd_2: only their columns C and 1 are not zero.
  template <class T>
  [[nodiscard]] Rows<T, 2> odd(const model::OvershootingData<T>& d, const Times<T>& t) const {
    const auto both = model::overshooting_odd<T>(d, t.tau, t.tau1);
    return with_phase<T, 2>(both, d, t);
  }
  // even_1, even_2 and turn.
  template <class T>
  [[nodiscard]] Rows<T, 3> others(const model::OvershootingData<T>& d, const Times<T>& t) const {
    const auto [even1, even2] = model::overshooting_even<T>(d, t.tau, t.tau1);
    return with_phase<T, 3>({even1, even2, model::overshooting_turn<T>(d, t.tau, t.tau1)}, d, t);
  }

  // What must vanish once (a, C, D) are eliminated.
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> functions(const Rows<T, rows>& eliminated) const {
    return {eliminated(3, 3), eliminated(4, 3)};
  }

 private:
  template <class T, int R>
  [[nodiscard]] Rows<T, R> with_phase(const std::array<model::OvershootingRow<T>, R>& all,
                                      const model::OvershootingData<T>& d, const Times<T>& t) const {
    const std::pair<T, T> psi = sin_cos(T(T(phi) + d.omega * T(t.tau + t.tau1) / T(2)));
    Rows<T, R> m;
    for (int i = 0; i < R; ++i) {
      const model::OvershootingRow<T>& row = all[static_cast<std::size_t>(i)];
      T one = row.one;
      if (!is_zero(row.cos_psi)) {
        one += row.cos_psi * psi.second;
      }
      if (!is_zero(row.sin_psi)) {
        one += row.sin_psi * psi.first;
      }
      m.row(i) << row.a, row.C, row.D, one;
    }
    return m;
  }
};

// u_r given, phi unknown: six rows for (a, C, D, cos psi, sin psi).
template <class S>
struct OvershootingAtFrictionOf {
  static constexpr int rows = 6;
  static constexpr int unknowns = 5;
  model::OvershootingData<S> data;
  S ur;

  template <class T, int R>
  using Rows = Eigen::Matrix<T, R, unknowns + 1>;

  // odd_1 and odd_2: only their columns C, sin psi and 1 are not zero.
  template <class T>
  [[nodiscard]] Rows<T, 2> odd(const model::OvershootingData<T>& d, const Times<T>& t) const {
    return as_matrix<T, 2>(model::overshooting_odd<T>(d, t.tau, t.tau1));
  }
  // even_1, even_2, turn and (12).
  template <class T>
  [[nodiscard]] Rows<T, 4> others(const model::OvershootingData<T>& d, const Times<T>& t) const {
    const auto [even1, even2] = model::overshooting_even<T>(d, t.tau, t.tau1);
    return as_matrix<T, 4>({even1, even2, model::overshooting_turn<T>(d, t.tau, t.tau1),
                            model::overshooting_friction<T>(d, T(ur), t.tau, t.tau1)});
  }

  // What must vanish once they are eliminated: the sixth row, and cos² psi + sin² psi - 1.
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> functions(const Rows<T, rows>& eliminated) const {
    const Eigen::Matrix<T, unknowns, 1> u = zeros::back_substituted<T, rows, unknowns + 1>(eliminated);
    return {eliminated(5, 5), T(u(3) * u(3) + (u(4) - T(1)) * (u(4) + T(1)))};
  }

 private:
  template <class T, int R>
  [[nodiscard]] static Rows<T, R> as_matrix(const std::array<model::OvershootingRow<T>, R>& all) {
    Rows<T, R> m;
    for (int i = 0; i < R; ++i) {
      const model::OvershootingRow<T>& row = all[static_cast<std::size_t>(i)];
      m.row(i) << row.a, row.C, row.D, row.cos_psi, row.sin_psi, row.one;
    }
    return m;
  }
};

using OvershootingAtPhase = OvershootingAtPhaseOf<Ball>;
using OvershootingAtFriction = OvershootingAtFrictionOf<Ball>;

template <class T, class Family>
using RowsOf = Eigen::Matrix<T, Family::rows, Family::unknowns + 1>;

// The odd rows above the others.
template <class T, class Family>
[[nodiscard]] RowsOf<T, Family> all_rows(const Family& f, const Eigen::Matrix<T, 2, 1>& sw) {
  const model::OvershootingData<T> d = model::lift<T>(f.data);
  const Times<T> t = times<T>(d.Theta, sw);
  RowsOf<T, Family> m;
  m.template topRows<2>() = f.template odd<T>(d, t);
  m.template bottomRows<Family::rows - 2>() = f.template others<T>(d, t);
  return m;
}

// Two functions of (s, w), for krawczyk.hpp: the family's rows combined as fits a box, its unknowns
// eliminated. Not finite where a pivot may vanish. Where they are finite and vanish, all combined rows hold
// for exactly one value of the unknowns; so do the rows themselves when the combinations are invertible.
template <class Family>
struct Eliminated {
  static constexpr int R = Family::rows;
  static constexpr int C = Family::unknowns + 1;
  Family family;
  Eigen::Matrix<Ball, R, R> combinations;

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, R, C> rows(const Eigen::Matrix<T, 2, 1>& sw) const {
    return zeros::combined_rows<T, R, C>(combinations, all_rows<T>(family, sw));
  }

  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 2, 1> operator()(const Eigen::Matrix<T, 2, 1>& sw) const {
    Eigen::Matrix<T, R, C> m = rows<T>(sw);
    if (!zeros::eliminate<T, R, C>(m, 0, C - 1)) {
      const T nowhere = T(1) / T(0);
      return {nowhere, nowhere};
    }
    return family.template functions<T>(m);
  }
};

}  // namespace stickslip::numeric::families
