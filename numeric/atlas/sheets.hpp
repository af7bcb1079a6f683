// The closing conditions of a family as equations in one unknown u, the share of a phase in the period, over
// a box of parameters: every closed motion of the family is a zero 0 < u < 1 of exactly one sheet, and every
// such zero is one, unless `motion` says that it may not be.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "numeric/atlas/question.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/scalars/form.hpp"
#include "numeric/scalars/jet.hpp"

namespace stickslip::numeric::atlas {

template <class T>
struct Sheet {
  using Jet = scalars::Jet<T, 1>;
  // f(u), and f with its derivative by u. Null for a sheet whose only zero is u = 1/2.
  std::function<T(const T& u)> value;
  std::function<Jet(const Jet& u)> slope;
  // The motion at a zero, or why it may be none.
  std::function<std::variant<motion::MotionOf<T>, Reason>(const T& u)> motion;
  // Its motions disobey a condition, as is known beforehand.
  bool never_admissible = false;
};
template <class T>
using Sheets = std::variant<std::vector<Sheet<T>>, Reason>;

// Section 4: a sheet for each load phase, the eliminant of the reduced equations
// (model/symmetric_closing.hpp). With p = 0 both have the same orbits.
template <class T, class S>
[[nodiscard]] Sheets<T> symmetric_sheets(const model::Oscillator<T>& o, const Box& box) {
  const Interval& p = box[place_of_p];
  if (p.lower == 0 && p.upper > 0) {
    return Reason::no_load;
  }
  const T half_turn(scalars::pi<S>());
  std::vector<Sheet<T>> sheets;
  for (const int sigma : {1, -1}) {
    const model::SymmetricData<T> data{
        o.data.chi, o.modes, o.data.V, o.data.omega, o.data.p, T(T(2) * half_turn / o.data.omega), T(sigma)};
    const auto motion = [=](const T& u) -> std::variant<motion::MotionOf<T>, Reason> {
      const T tau = data.Theta * u;
      const model::SymmetricRows<T> rows = model::symmetric_rows<T>(data, tau);
      const auto size = [&](int j) { return std::abs(rows.left(j).at.approximate()); };
      const int j = size(0) > size(1) ? 0 : 1;
      if (!rows.left(j).over.is_nonzero()) {
        return Reason::no_amplitude;
      }
      return families::symmetric_motion<T>(data, o, half_turn, tau, T(rows.right(j) / rows.left(j)));
    };
    using Jet = typename Sheet<T>::Jet;
    const model::SymmetricData<Jet> lifted{
        data.chi, model::lift<Jet>(data.m), data.V, data.omega, data.p, data.Theta, data.sigma};
    sheets.push_back(
        {[=](const T& u) { return model::symmetric_eliminant<T>(data, T(data.Theta * u)); },
         [=](const Jet& u) { return model::symmetric_eliminant<Jet>(lifted, Jet(lifted.Theta * u)); }, motion,
         false});
    if (p.upper == 0) {
      break;
    }
  }
  return sheets;
}

// The angle whose cosine and sine these are, for every member a point of the unit circle. With mu0 near it,
// e = sin(mu - mu0) and cos(mu - mu0) > 0: |mu - mu0| <= pi/2 |e|; mu' = c s' - s c'. Nothing when mu may be
// far from mu0.
template <class S, int N>
[[nodiscard]] std::optional<scalars::Form<S, N>> angle_of(const scalars::Form<S, N>& c,
                                                          const scalars::Form<S, N>& s) {
  const S mu0(std::atan2(s.at.approximate(), c.at.approximate()));
  const auto [s0, c0] = sin_cos(mu0);
  if (!(c.over * c0 + s.over * s0).is_positive()) {
    return std::nullopt;
  }
  const auto around_mu0 = [&](const S& cosine, const S& sine) {
    return S(mu0 + scalars::sway(std::array<S, 1>{S((sine * c0 - cosine * s0) * S(1.6))}));
  };
  scalars::Form<S, N> mu;
  mu.at = around_mu0(c.at, s.at);
  mu.over = around_mu0(c.over, s.over);
  for (std::size_t i = 0; i < mu.slopes.size(); ++i) {
    mu.slopes[i] = c.over * s.slopes[i] - s.over * c.slopes[i];
  }
  mu.sharpen();
  return mu;
}

// Orbits that never stick, with u = delta/pi in the two equations of model/nonsticking.hpp,
//   V + A sin(mu) cos(delta) = 0,  G(delta) + A cos(mu) = 0,  A = q2 omega.
// For V ≠ 0 neither A nor cos(delta) vanishes at a zero, and mu can be eliminated: there is one mu, modulo
// 2 pi, for each zero delta of V² + cos²(delta) (G² - A²). For V = 0 and A ≠ 0 either cos(delta) = 0 and
// cos(mu) = -G(pi/2)/A, which two mu obey if |G(pi/2)| < |A| and none if it exceeds |A|; or sin(mu) = 0 and
// G(delta) = ∓A, where x2' < 0 on the slip is impossible (model/nonsticking.hpp). Both at once only where
// |G(pi/2)| = |A|.
template <class T, class S>
[[nodiscard]] Sheets<T> nonsticking_sheets(const model::Oscillator<T>& o, const Box& box) {
  const T pi(scalars::pi<S>());
  const T A = o.Q(1) * o.data.omega;
  const model::Vector2<T> c = model::modal_rest<T>(o.modes, o.d0);
  const auto G = [=]<class Q>(const Q& delta) {
    return model::friction_speed<Q>(model::lift<Q>(o.modes), model::lift<Q>(c), Q(o.data.omega), Q(pi),
                                    delta);
  };
  const auto motion = [=](const T& delta, const T& cosine,
                          const T& sine) -> std::variant<motion::MotionOf<T>, Reason> {
    const std::optional<T> mu = angle_of(cosine, sine);
    if (!mu) {
      return Reason::merging;
    }
    return families::two_slips_motion<T>(o, pi, delta, *mu);
  };
  const Interval& V = box[place_of_V];
  if (V.lower > 0 || V.upper < 0) {
    const auto equation = [=]<class Q>(const Q& u) {
      const Q delta = Q(pi) * u;
      const Q speed = G(delta);
      const Q cosine = cos(delta);
      return Q(Q(T(o.data.V * o.data.V)) + cosine * cosine * Q(speed * speed - Q(T(A * A))));
    };
    const auto at_zero = [=](const T& u) -> std::variant<motion::MotionOf<T>, Reason> {
      const T delta = pi * u;
      const T product = A * T(cos(delta));
      if (!product.over.is_nonzero()) {
        return Reason::merging;
      }
      return motion(delta, T(-G(delta) / A), T(-o.data.V / product));
    };
    return std::vector<Sheet<T>>{{equation, equation, at_zero, false}};
  }
  if (!V.is_point()) {
    return Reason::belt_at_rest;
  }
  if (!A.over.is_nonzero()) {
    return Reason::no_load;
  }
  std::vector<Sheet<T>> sheets;
  for (const int sign : {1, -1}) {
    const auto equation = [=]<class Q>(const Q& u) { return Q(G(Q(Q(pi) * u)) + Q(T(T(sign) * A))); };
    sheets.push_back({equation, equation, nullptr, true});
  }
  const T half = pi / T(2);
  const T cosine = -G(half) / A;
  const T square = T(1) - cosine * cosine;
  if (square.over.is_positive()) {
    for (const int sign : {1, -1}) {
      sheets.push_back({nullptr, nullptr,
                        [=](const T&) { return motion(half, cosine, T(T(sign) * T(sqrt(square)))); }, false});
    }
  } else if (!square.over.is_negative()) {
    return Reason::merging;
  }
  return sheets;
}

}  // namespace stickslip::numeric::atlas
