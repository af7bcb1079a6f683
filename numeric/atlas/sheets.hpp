// The closing conditions of a family as equations in one unknown u, the share of a phase in the period, over
// a box of parameters: every closed motion of the family is a zero 0 < u < 1 of exactly one sheet, and every
// such zero is one, unless the making of the motion says that it may not be. Over any scalar of boxes
// (form.hpp).
#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "numeric/atlas/question.hpp"
#include "numeric/families/nonsticking.hpp"
#include "numeric/families/symmetric.hpp"
#include "numeric/scalars/form.hpp"

namespace stickslip::numeric::atlas {

struct Sheet {
  enum class Kind {
    symmetric,  // Section 4: the eliminant of the reduced equations; sign: of the load phase
    moving,     // never sticks, V ≠ 0: mu eliminated
    even,       // never sticks, V = 0, sin(mu) = 0: G(delta) + sign A = 0
    half,       // never sticks, V = 0, tau = Theta/2: u = 1/2 is the only zero; sign: of sin(mu)
  } kind;
  int sign = 1;

  [[nodiscard]] bool has_equation() const { return kind != Kind::half; }
  // Its motions disobey a condition, as is known beforehand.
  [[nodiscard]] bool is_never_admissible() const { return kind == Kind::even; }
};

// What the sheets' equations are written in.
template <class T>
struct Setting {
  model::Oscillator<T> o;
  T pi;
  model::Vector2<T> rest;  // of model/nonsticking.hpp, as A = q2 omega
  T A;
  T Theta;

  // As constants of another scalar, by which the parameters are not differentiated.
  template <class Q>
  [[nodiscard]] Setting<Q> lifted() const {
    return {{model::lift<Q>(o.data), model::lift<Q>(o.modes), model::lift<Q>(o.Q), model::lift<Q>(o.d0)},
            Q(pi),
            model::lift<Q>(rest),
            Q(A),
            Q(Theta)};
  }
};
template <class T>
[[nodiscard]] Setting<T> setting_of(const model::Parameters<T>& data, const T& pi) {
  const model::Oscillator<T> o = model::oscillator<T>(data);
  return {o, pi, model::modal_rest<T>(o.modes, o.d0), T(o.Q(1) * data.omega), T(T(2) * pi / data.omega)};
}

template <class T>
[[nodiscard]] model::SymmetricData<T> symmetric_data(const Setting<T>& s, int sign) {
  return {{s.o.data, s.o.modes, s.Theta}, T(sign)};
}

// G of the equations below at delta = pi u.
template <class T>
[[nodiscard]] T slip_speed(const Setting<T>& s, const T& u) {
  return model::friction_speed<T>(s.o.modes, s.rest, s.o.data.omega, s.pi, T(s.pi * u));
}

// f(u). Orbits that never stick, with u = delta/pi, obey the two equations of model/nonsticking.hpp,
//   V + A sin(mu) cos(delta) = 0,  G(delta) + A cos(mu) = 0,  A = q2 omega.
// For V ≠ 0 neither A nor cos(delta) vanishes at a zero, and mu can be eliminated: there is one mu, modulo
// 2 pi, for each zero delta of V² + cos²(delta) (G² - A²). For V = 0 and A ≠ 0 either cos(delta) = 0 and
// cos(mu) = -G(pi/2)/A, which two mu obey if |G(pi/2)| < |A| and none if it exceeds |A|; or sin(mu) = 0 and
// G(delta) = ∓A, where x2' < 0 on the slip is impossible (model/nonsticking.hpp). Both at once only where
// |G(pi/2)| = |A|.
template <class T>
[[nodiscard]] T equation(const Sheet& sheet, const Setting<T>& s, const T& u) {
  if (sheet.kind == Sheet::Kind::symmetric) {
    const model::SymmetricData<T> data = symmetric_data(s, sheet.sign);
    return model::symmetric_eliminant<T>(data, T(data.Theta * u));
  }
  const T G = slip_speed(s, u);
  if (sheet.kind == Sheet::Kind::even) {
    return G + T(sheet.sign) * s.A;
  }
  const T cosine = cos(T(s.pi * u));
  return s.o.data.V * s.o.data.V + cosine * cosine * T(G * G - s.A * s.A);
}

// The angle whose cosine and sine these are, for every member a point of the unit circle. With mu0 near it,
// e = sin(mu - mu0) and cos(mu - mu0) > 0: |mu - mu0| <= pi/2 |e|; mu' = c s' - s c'. Nothing when mu may be
// far from mu0.
template <class S, int N>
[[nodiscard]] std::optional<scalars::Form<S, N>> angle_of(const scalars::Form<S, N>& c,
                                                          const scalars::Form<S, N>& s) {
  const S mu0(std::atan2(s.at.approximate(), c.at.approximate()));
  const std::pair<S, S> both = sin_cos(mu0);
  const S &s0 = both.first, &c0 = both.second;
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
// The motion that never sticks at a zero; nothing when two of them may be one.
template <class T>
[[nodiscard]] std::optional<motion::MotionOf<T>> motion_of(const Sheet& sheet, const Setting<T>& s,
                                                           const T& u) {
  const T delta = s.pi * u;
  const T cosine = -slip_speed(s, u) / s.A;
  std::optional<T> mu;
  if (sheet.kind == Sheet::Kind::half) {
    const T square = T(1) - cosine * cosine;
    if (square.over.is_positive()) {
      mu = angle_of(cosine, T(T(sheet.sign) * T(sqrt(square))));
    }
  } else {
    const T product = s.A * T(cos(delta));
    if (product.over.is_nonzero()) {
      mu = angle_of(cosine, T(-s.o.data.V / product));
    }
  }
  if (!mu) {
    return std::nullopt;
  }
  return families::two_slips_motion<T>(s.o, s.pi, delta, *mu);
}

// All sheets, the same for every member, or why that is not known.
using Sheets = std::variant<std::vector<Sheet>, Reason>;

// Of symmetric orbits: with p = 0 both load phases have the same orbits. p: of the load, as load_of tells.
[[nodiscard]] inline Sheets symmetric_sheets(const Interval& p) {
  using Kind = Sheet::Kind;
  if (p.lower == 0 && p.upper > 0) {
    return Reason::no_load;
  }
  return p.upper == 0 ? std::vector<Sheet>{{Kind::symmetric, 1}}
                      : std::vector<Sheet>{{Kind::symmetric, 1}, {Kind::symmetric, -1}};
}

// Of orbits that never stick. V: of the belt, as belt_of tells.
template <class T>
[[nodiscard]] Sheets nonsticking_sheets(const Setting<T>& s, const Interval& V) {
  using Kind = Sheet::Kind;
  if (V.lower > 0 || V.upper < 0) {
    return std::vector<Sheet>{{Kind::moving}};
  }
  if (!V.is_point()) {
    return Reason::belt_at_rest;
  }
  if (!s.A.over.is_nonzero()) {
    return Reason::idle_load;
  }
  std::vector<Sheet> sheets{{Kind::even, 1}, {Kind::even, -1}};
  const T cosine = slip_speed(s, T(T(1) / T(2))) / s.A;
  const auto square = T(T(1) - cosine * cosine).over;
  if (square.is_positive()) {
    sheets.push_back({Kind::half, 1});
    sheets.push_back({Kind::half, -1});
  } else if (!square.is_negative()) {
    return Reason::merging;
  }
  return sheets;
}

}  // namespace stickslip::numeric::atlas
