// Mean value forms: a quantity over a whole box of variables, as its value at the middle and its slopes.
//
// Each of N variables runs through [-1, 1]. Wide balls take every occurrence of a variable for another one;
// a Form knows how a quantity changes with each of them, so that by the mean value theorem
//   g(e) lies in g(0) + g_1 [-1, 1] + … + g_N [-1, 1],  g_i the range of the i-th derivative,
// which is to second order as narrow as the quantity itself. Every operation keeps the narrower of that and
// of what plain balls give; slopes are made of these. A Form is a scalar of the model, over Arb balls and
// over hardware balls S: every formula of model/ gives its values over a box and their derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/sinc.hpp"
#include "numeric/scalars/hardware_ball.hpp"
#include "numeric/scalars/hardware_balls.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::numeric::scalars {

// What is not a number is as wide as can be.
[[nodiscard]] inline bool is_narrower(const HardwareBall& a, const HardwareBall& b) {
  return a.radius() < b.radius() || std::isnan(b.radius());
}
[[nodiscard]] inline bool is_narrower(const Ball& a, const Ball& b) {
  return mag_cmp(arb_radref(a.raw()), arb_radref(b.raw())) < 0;
}

// As of Ball.
[[nodiscard]] inline std::pair<double, double> ends(const HardwareBall& x) {
  const double low = x.approximate() - x.radius();
  const double high = x.approximate() + x.radius();
  return {std::nextafter(low, -INFINITY), std::nextafter(high, INFINITY)};
}

// All sums of slopes times numbers of [-1, 1].
template <std::size_t N>
[[nodiscard]] HardwareBall sway(const std::array<HardwareBall, N>& slopes) {
  double sum = 0;
  for (const HardwareBall& slope : slopes) {
    sum = (sum + std::abs(slope.approximate()) + slope.radius()) * (1 + 0x1p-50);  // from above
  }
  return HardwareBall::within(sum);
}
template <std::size_t N>
[[nodiscard]] HardwareBall sway(const HardwareBalls<N>& slopes) {
  return HardwareBall::within(slopes.magnitude() * (1 + 0x1p-48));
}
template <std::size_t N>
[[nodiscard]] Ball sway(const std::array<Ball, N>& slopes) {
  Ball sum(0);
  for (const Ball& slope : slopes) {
    sum += abs(slope);
  }
  return within(sum);
}

// middle + sway(slopes).
template <std::size_t N>
[[nodiscard]] HardwareBall mean_value(const HardwareBall& middle, const HardwareBalls<N>& slopes) {
  return {middle.approximate(), (middle.radius() + slopes.magnitude()) * (1 + 0x1p-48)};
}
template <std::size_t N>
[[nodiscard]] Ball mean_value(const Ball& middle, const std::array<Ball, N>& slopes) {
  return middle + sway(slopes);
}

[[nodiscard]] inline Ball inverse(const Ball& x) {
  return Ball(1) / x;
}

// The same of slopes in Arb balls as of HardwareBalls; what is zero is skipped.
[[nodiscard]] inline Ball sum_of_products(const Ball& a, const Ball& x, const Ball& b, const Ball& y) {
  if (is_zero(x) || is_zero(y)) {
    return is_zero(x) && is_zero(y) ? Ball(0) : is_zero(x) ? b * y : a * x;
  }
  return a * x + b * y;
}
template <std::size_t N>
[[nodiscard]] std::array<Ball, N> sum_of_products(const Ball& a, std::array<Ball, N> x, const Ball& b,
                                                  const std::array<Ball, N>& y) {
  for (std::size_t i = 0; i < N; ++i) {
    x[i] = sum_of_products(a, x[i], b, y[i]);
  }
  return x;
}
template <std::size_t N>
[[nodiscard]] std::array<Ball, N> operator*(const Ball& a, std::array<Ball, N> x) {
  for (Ball& slope : x) {
    if (!is_zero(slope)) {
      slope = a * slope;
    }
  }
  return x;
}
template <std::size_t N>
[[nodiscard]] std::array<Ball, N> operator+(std::array<Ball, N> x, const std::array<Ball, N>& y) {
  for (std::size_t i = 0; i < N; ++i) {
    x[i] += y[i];
  }
  return x;
}
template <std::size_t N>
[[nodiscard]] std::array<Ball, N> operator-(std::array<Ball, N> x, const std::array<Ball, N>& y) {
  for (std::size_t i = 0; i < N; ++i) {
    x[i] -= y[i];
  }
  return x;
}
template <std::size_t N>
[[nodiscard]] bool is_zero(const std::array<Ball, N>& slopes) {
  return std::all_of(slopes.begin(), slopes.end(), [](const Ball& slope) { return is_zero(slope); });
}

// At two places at once, which costs hardware balls less where both have the same midpoint.
template <class S>
using Both = std::array<S, 2>;
[[nodiscard]] inline Both<std::pair<Ball, Ball>> sin_cos(const Both<Ball>& x) {
  return {sin_cos(x[0]), sin_cos(x[1])};
}
[[nodiscard]] inline Both<std::pair<Ball, Ball>> sinc_and_slope(const Both<Ball>& x) {
  return {std::pair{sinc(x[0]), sinc_slope(x[0])}, {sinc(x[1]), sinc_slope(x[1])}};
}

// The second derivative of sinc, given sinc and the first. It lies in [-1/3, 1/3], and so does the fourth in
// [-1/5, 1/5].
template <class S>
[[nodiscard]] S sinc_curvature(const S& x, const std::pair<S, S>& value_and_slope) {
  const S square = x * x;
  if (S(square - S(1)).is_positive()) {
    return -value_and_slope.first - S(2) * value_and_slope.second / x;
  }
  return S(-1) / S(3) + sway(std::array<S, 1>{S(square / S(10))});
}

// A ball around [low, high].
template <class S>
[[nodiscard]] S around(double low, double high) {
  const double middle = low + (high - low) / 2;
  return S(middle) + sway(std::array<S, 1>{S(reach(low, middle, high))});
}

template <class S, int N>
struct SlopesOf {
  using type = std::array<S, static_cast<std::size_t>(N)>;
};
template <int N>
struct SlopesOf<HardwareBall, N> {
  using type = HardwareBalls<static_cast<std::size_t>(N)>;
};

template <class S, int N>
struct Form {
  using Slopes = typename SlopesOf<S, N>::type;

  S at = S(0);    // where all variables are 0
  S over = S(0);  // everywhere
  Slopes slopes = none();

  Form() = default;
  Form(int constant) : at(constant), over(constant) {}           // NOLINT: scalars convert from int
  Form(S constant) : at(constant), over(std::move(constant)) {}  // NOLINT: a constant has no slope

  // middle + radius e_i. Both are taken as they are: the caller sees to it that no member is missing.
  [[nodiscard]] static Form variable(double middle, double radius, int i) {
    Form x{S(middle)};
    x.slopes[static_cast<std::size_t>(i)] = S(radius);
    x.over = x.at + sway(x.slopes);
    return x;
  }
  // From low to high.
  [[nodiscard]] static Form variable_between(double low, double high, int i) {
    const double middle = low + (high - low) / 2;
    return variable(middle, reach(low, middle, high), i);
  }

  // g(this) of which the value at the middle, the range, and the range of the derivative are known.
  [[nodiscard]] Form chain(S middle, S range, const S& slope) const {
    return {std::move(middle), std::move(range), slope * slopes};
  }

  // The values where all variables from the given one on run and those before are 0.
  [[nodiscard]] S over_from(std::size_t first) const {
    Slopes rest = slopes;
    for (std::size_t i = 0; i < first; ++i) {
      rest[i] = S(0);
    }
    return at + sway(rest);
  }

  // Keeps the narrower of the range and the mean value form.
  void sharpen() {
    S mean = mean_value(at, slopes);
    if (is_narrower(mean, over)) {
      over = std::move(mean);
    }
  }

  Form& operator+=(const Form& b) { return *this = *this + b; }
  Form& operator-=(const Form& b) { return *this = *this - b; }
  Form& operator*=(const Form& b) { return *this = *this * b; }
  Form& operator/=(const Form& b) { return *this = *this / b; }
  friend Form operator+(const Form& a, const Form& b) {
    return {S(a.at + b.at), S(a.over + b.over), a.slopes + b.slopes};
  }
  friend Form operator-(const Form& a, const Form& b) {
    return {S(a.at - b.at), S(a.over - b.over), a.slopes - b.slopes};
  }
  friend Form operator*(const Form& a, const Form& b) {
    return {S(a.at * b.at), S(a.over * b.over), sum_of_products(a.over, b.slopes, b.over, a.slopes)};
  }
  friend Form operator/(const Form& a, const Form& b) {
    const S inverse = stickslip::numeric::scalars::inverse(b.over);
    if (is_zero(b.slopes)) {
      return a.chain(a.at * inverse, a.over * inverse, inverse);
    }
    const S quotient = a.over / b.over;
    return {S(a.at / b.at), quotient, sum_of_products(inverse, a.slopes, S(-quotient * inverse), b.slopes)};
  }
  friend Form operator-(const Form& a) { return a.chain(-a.at, -a.over, S(-1)); }
  friend Form operator+(const Form& a) { return a; }

  friend std::pair<Form, Form> sin_cos(const Form& a) {
    const auto [middle, range] = sin_cos(Both<S>{a.at, a.over});
    return {a.chain(middle.first, range.first, range.second),
            a.chain(middle.second, range.second, S(-range.first))};
  }
  friend Form sin(const Form& a) { return sin_cos(a).first; }
  friend Form cos(const Form& a) { return sin_cos(a).second; }
  friend Form sinc(const Form& a) {
    const auto [middle, range] = sinc_and_slope(Both<S>{a.at, a.over});
    return a.chain(middle.first, range.first, range.second);
  }
  friend Form sinc_slope(const Form& a) {
    const auto [middle, range] = sinc_and_slope(Both<S>{a.at, a.over});
    return a.chain(middle.second, range.second, sinc_curvature(a.over, range));
  }
  // Whether it is zero everywhere: then products with it need not be computed.
  friend bool is_zero(const Form& a) { return is_zero(a.over); }
  friend bool is_nonzero(const Form& a) { return a.over.is_nonzero(); }
  friend void add_product(Form& sum, const S& factor, const Form& b) { sum += Form(factor) * b; }
  friend void add_product(Form& sum, const Form& a, const Form& b) { sum += a * b; }
  friend Form sqrt(const Form& a) {
    const S root = sqrt(a.over);
    return a.chain(sqrt(a.at), root, S(1) / (S(2) * root));
  }

 private:
  Form(S middle, S range, Slopes all)
      : at(std::move(middle)), over(std::move(range)), slopes(std::move(all)) {
    sharpen();
  }
  [[nodiscard]] static Slopes none() {
    Slopes zeros;
    zeros.fill(S(0));
    return zeros;
  }
};

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <class S, int N>
struct NumTraits<stickslip::numeric::scalars::Form<S, N>>
    : stickslip::model::ScalarTraits<stickslip::numeric::scalars::Form<S, N>, 8, 200, 400> {};

}  // namespace Eigen
