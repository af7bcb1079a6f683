// All closed motions of a family over an interval of one parameter: its reduced equations in the unknowns v
// and that parameter, for searches that leave out what is known (zeros/search.hpp).
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "model/named_data.hpp"
#include "numeric/machine_along.hpp"
#include "numeric/motion/closing.hpp"
#include "numeric/scalars/form.hpp"
#include "numeric/zeros/search.hpp"

namespace stickslip::numeric::families {

// One parameter, by its place among chi, eta, us, V, omega, p, phi, ur, from end to end of its interval; the
// others are exact.
struct StripQuestion {
  motion::Given<Rational> given;
  std::size_t place = 0;
  Rational from, to;
  // Then it is that of the machine which varies, and `given` are the data at its upper end.
  std::optional<MachineAlong> machine = {};
};

// v, of which a family with one unknown takes the first, and how far the parameter is on its way from the one
// end of its interval to the other, 0 … length_of(question).
using StripBox = zeros::Box<3>;
using Bounds = std::pair<double, double>;

// A power of two, such that the equations change about as much over this length as over that of a v: then
// searches that halve the longest sides do well.
[[nodiscard]] inline double length_of(const StripQuestion& q) {
  const double size = std::max(std::abs(q.from.get_d()), std::abs(q.to.get_d()));
  const double share = 4 * Rational(q.to - q.from).get_d() / size;
  return std::exp2(std::round(std::log2(std::clamp(share, 0x1p-20, 1.0))));
}

// Bounds of the unknowns where some may grow beyond all bounds: of the reciprocal of the one at `place`, in
// its place, and of the growing ones divided by it. No motion has a zero there.
struct LargeBounds {
  int place = 0;
  std::vector<int> growing;
  std::vector<Bounds> x;
};

struct Strip {
  int system = 0;  // see Candidate
  int angle = -1;
  zeros::Cell<3> domain;  // every closed motion of the family with positive durations is in it
  struct View {
    StripBox rest;          // holds all zeros that the box has
    std::vector<Bounds> x;  // bounds the unknowns of the closing conditions there, see Reduced
    Bounds parameter;
    std::vector<LargeBounds> large;  // each of them bounds all of the motions; of those that may be large
  };
  // Nothing when the box has no zero.
  std::function<std::optional<View>(const StripBox&)> look;
};

// What is known of a box: the functions that vanish wherever a motion closes, the unknowns of the closing
// conditions, and whether none can close for another reason.
template <class T>
struct Reduced {
  std::vector<T> vanish;
  // At its zeros; empty where nothing is known.
  std::vector<Bounds> x = {};
  std::vector<LargeBounds> large = {};
  bool excluded = false;
};

namespace detail {

template <class S>
using StripForm = scalars::Form<S, 3>;

// The middle and the radius, in doubles, of an interval that contains the ball.
[[nodiscard]] inline std::pair<double, double> in_doubles(const Ball& x) {
  const double middle = x.approximate();
  return {middle, arf_get_d(arb_midref(abs(x - Ball(middle)).upper().raw()), ARF_RND_CEIL)};
}

template <class S>
[[nodiscard]] motion::Given<StripForm<S>> forms(const StripQuestion& q, const StripForm<S>& parameter) {
  if (q.machine) {
    return q.machine->at<StripForm<S>, S>(parameter);
  }
  auto given = motion::mapped<StripForm<S>>(
      q.given, [](const Rational& value) { return StripForm<S>(scalars::scalar<S>(value)); });
  const auto& named = model::named_data<StripForm<S>>;
  if (q.place < named.size()) {
    given.data.*named[q.place].second = parameter;
  } else {
    (q.place == named.size() ? given.phi : given.ur) = parameter;
  }
  return given;
}

// Shares of the box, each in [-1, 1].
template <class S>
using Shares = Eigen::Matrix<S, 3, 1>;

// Those at which at + slopes · e vanishes; nothing when there are none. The slopes hold for all of the box.
template <class S, class Slopes>
[[nodiscard]] std::optional<Shares<S>> shrunk(const S& at, const Slopes& slopes, const Shares<S>& e) {
  const Eigen::Matrix<S, 1, 3> slope(slopes[0], slopes[1], slopes[2]);
  return zeros::contract_by<3, S>(at, slope, Shares<S>::Constant(S(0)), e);
}

// Two functions combined so that of two variables, those that they tell apart best, each has one.
template <class S>
[[nodiscard]] std::optional<Shares<S>> shrunk_by_both(const StripForm<S>& f, const StripForm<S>& g,
                                                      const Shares<S>& e) {
  const auto slope = [](const StripForm<S>& h, std::size_t i) { return h.slopes[i].approximate(); };
  double most = 0;
  std::size_t first = 0, second = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const double det = slope(f, i) * slope(g, j) - slope(f, j) * slope(g, i);
      if (std::abs(det) > std::abs(most)) {
        most = det;
        first = i;
        second = j;
      }
    }
  }
  if (most == 0 || !std::isfinite(most)) {
    return e;
  }
  const auto combined = [&](double of_f, double of_g, const Shares<S>& shares) {
    std::array<S, 3> slopes;
    for (std::size_t i = 0; i < 3; ++i) {
      slopes[i] = S(of_f) * f.slopes[i] + S(of_g) * g.slopes[i];
    }
    return shrunk<S>(S(S(of_f) * f.at + S(of_g) * g.at), slopes, shares);
  };
  const auto once = combined(slope(g, second) / most, -slope(f, second) / most, e);
  return once ? combined(-slope(g, first) / most, slope(f, first) / most, *once) : std::nullopt;
}

template <class S, class F>
[[nodiscard]] std::optional<Strip::View> look(const StripQuestion& q, const F& reduced, const StripBox& X) {
  using T = StripForm<S>;
  const Ball value = Ball(q.from) + Ball(Rational(q.to - q.from)) * X(2) / Ball(length_of(q));
  std::array<std::pair<double, double>, 3> sides{in_doubles(X(0)), in_doubles(X(1)), in_doubles(value)};
  const auto variable = [&](int i) {
    const auto& [middle, radius] = sides[static_cast<std::size_t>(i)];
    return T::variable(middle, radius, i);
  };
  const Reduced<T> here =
      reduced.template operator()<T, S>(forms<S>(q, variable(2)), variable(0), variable(1));
  if (here.excluded) {
    return std::nullopt;
  }
  Strip::View view{X, here.x, scalars::ends(value), here.large};
  std::optional<Shares<S>> e = Shares<S>::Constant(scalars::around<S>(-1, 1));
  for (std::size_t i = 0; e && i < here.vanish.size(); ++i) {
    const T& f = here.vanish[i];
    e = f.over.is_nonzero() ? std::nullopt : shrunk<S>(f.at, f.slopes, *e);
  }
  if (e && here.vanish.size() >= 2) {
    e = shrunk_by_both<S>(here.vanish[here.vanish.size() - 2], here.vanish.back(), *e);
  }
  if (!e) {
    return std::nullopt;
  }
  for (int i = 0; i < 2; ++i) {
    const auto& [middle, radius] = sides[static_cast<std::size_t>(i)];
    const auto [low, high] = scalars::ends((*e)(i));
    const Ball side = Ball(middle) + Ball(radius) * Ball::hull(Ball(low), Ball(high));
    const std::optional<Ball> rest = zeros::intersection(X(i), side);
    if (!rest) {
      return std::nullopt;
    }
    view.rest(i) = *rest;
  }
  return view;
}

}  // namespace detail

// F: template <class T, class S> Reduced<T> operator()(const Given<T>&, const T& v0, const T& v1), T =
// Form<S, 3>. In doubles, or in Arb where the box is too narrow for them.
template <class F>
[[nodiscard]] Strip strip_of(const StripQuestion& q, int system, int angle, zeros::Cell<3> domain,
                             const F& reduced) {
  domain.upper[2] = length_of(q);
  constexpr double too_narrow = 0x1p-28;
  return {system, angle, domain, [q, reduced](const StripBox& X) {
            double widest = 0;
            for (const Ball& side : X) {
              widest = std::max(widest, side.radius().approximate());
            }
            return widest > too_narrow ? detail::look<scalars::HardwareBall>(q, reduced, X)
                                       : detail::look<Ball>(q, reduced, X);
          }};
}

}  // namespace stickslip::numeric::families
