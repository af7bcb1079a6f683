#include "numeric/families/overshooting_strip.hpp"

#include "numeric/families/overshooting_rows.hpp"

namespace stickslip::numeric::families {

using namespace motion;

namespace {

template <class T, class S>
model::OvershootingData<T> data_of(const model::Parameters<T>& a) {
  return {a.chi,   a.eta, model::modes<T>(a.chi, a.eta),          a.us, a.V,
          a.omega, a.p,   T(T(2) * T(scalars::pi<S>()) / a.omega)};
}

// The rows with their linear unknowns eliminated.
template <class T, int U>
struct WithoutLinear {
  Eigen::Matrix<T, 2, 1> vanish;
  Eigen::Matrix<T, U, 1> linear;
};

// Nothing where they may be dependent.
template <class T, class S, class Family>
std::optional<WithoutLinear<T, Family::unknowns>> eliminated(const Family& f, const RowsOf<T, Family>& rows) {
  constexpr int R = Family::rows;
  constexpr int C = Family::unknowns + 1;
  Eigen::Matrix<S, R, C> at_middle;
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) {
      at_middle(i, j) = rows(i, j).at;
    }
  }
  const auto combinations = zeros::row_combinations<R, C>(at_middle);
  if (!combinations) {
    return std::nullopt;
  }
  RowsOf<T, Family> m = zeros::combined_rows<T, R, C>(*combinations, rows);
  if (!zeros::eliminate<T, R, C>(m, 0, C - 1)) {
    return std::nullopt;
  }
  return WithoutLinear<T, C - 1>{f.template functions<T>(m), zeros::back_substituted<T, R, C>(m)};
}

// tau, tau1, a, C, D.
template <class T, int U>
std::vector<Bounds> bounds(const Times<T>& t, const Eigen::Matrix<T, U, 1>& linear) {
  return {scalars::ends(t.tau.over), scalars::ends(t.tau1.over), scalars::ends(linear(0).over),
          scalars::ends(linear(1).over), scalars::ends(linear(2).over)};
}

Ball as_ball(const Ball& x) {
  return x;
}
Ball as_ball(const scalars::HardwareBall& x) {
  return x.ball();
}

struct AtPhase {
  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& s, const T& w) const {
    const OvershootingAtPhaseOf<T> f{data_of<T, S>(given.data), *given.phi};
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const auto rows = all_rows<T>(f, sw);
    const T odd = det2<T>(rows(0, 1), rows(0, 3), rows(1, 1), rows(1, 3));
    if (is_nonzero(odd)) {
      return {{}, {}, true};
    }
    const auto rest = eliminated<T, S>(f, rows);
    if (!rest) {
      return {{odd}, {}};
    }
    return {{odd, rest->vanish(0), rest->vanish(1)}, bounds<T>(times<T>(f.data.Theta, sw), rest->linear)};
  }
};

struct AtFriction {
  template <class T, class S>
  [[nodiscard]] Reduced<T> operator()(const Given<T>& given, const T& s, const T& w) const {
    const OvershootingAtFrictionOf<T> f{data_of<T, S>(given.data), *given.ur};
    const Eigen::Matrix<T, 2, 1> sw(s, w);
    const auto rows = all_rows<T>(f, sw);
    // sin psi - 1 and sin psi + 1, times the determinant of the odd rows in (C, sin psi).
    const T one = det2<T>(rows(0, 1), rows(0, 4), rows(1, 1), rows(1, 4));
    const T sine = det2<T>(rows(0, 5), rows(0, 1), rows(1, 5), rows(1, 1));
    const S above = T(sine + one).over, below = T(sine - one).over;
    if ((above.is_positive() && below.is_positive()) || (above.is_negative() && below.is_negative())) {
      return {{}, {}, true};
    }
    const auto rest = eliminated<T, S>(f, rows);
    if (!rest) {
      return {};
    }
    const Times<T> t = times<T>(f.data.Theta, sw);
    Reduced<T> result{{rest->vanish(0), rest->vanish(1)}, bounds<T>(t, rest->linear)};
    // phi, up to full turns.
    Ball phi;
    arb_atan2(phi.raw(), as_ball(rest->linear(4).over).raw(), as_ball(rest->linear(3).over).raw(),
              WorkingPrecision::bits());
    phi -= as_ball(T(f.data.omega * T(t.tau + t.tau1) / T(2)).over);
    result.x.push_back(scalars::ends(phi));
    return result;
  }
};

}  // namespace

std::vector<Strip> overshooting_strips(const StripQuestion& q) {
  const zeros::Cell<3> domain{{0, 0, 0}, {1, 1, 1}};
  if (q.given.phi) {
    return {strip_of(q, 0, -1, domain, AtPhase{})};
  }
  return {strip_of(q, 0, 5, domain, AtFriction{})};
}

}  // namespace stickslip::numeric::families
