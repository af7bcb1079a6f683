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

namespace stickslip::numeric::scalars {

// sum + |x| for all members of x, from above.
inline void add_magnitude(double& sum, const HardwareBall& x) {
  sum = (sum + std::abs(x.approximate()) + x.radius()) * (1 + 0x1p-50);
}
[[nodiscard]] inline bool is_narrower(const HardwareBall& a, const HardwareBall& b) {
  return a.radius() < b.radius();
}
[[nodiscard]] inline bool is_narrower(const Ball& a, const Ball& b) {
  return mag_cmp(arb_radref(a.raw()), arb_radref(b.raw())) < 0;
}

// No member is below the first, or above the second; NaN or infinite where a ball is unbounded.
[[nodiscard]] inline std::pair<double, double> ends(const HardwareBall& x) {
  const double low = x.approximate() - x.radius();
  const double high = x.approximate() + x.radius();
  return {std::nextafter(low, -INFINITY), std::nextafter(high, INFINITY)};
}
[[nodiscard]] inline std::pair<double, double> ends(const Ball& x) {
  return {arf_get_d(arb_midref(x.lower().raw()), ARF_RND_FLOOR),
          arf_get_d(arb_midref(x.upper().raw()), ARF_RND_CEIL)};
}

// All sums of slopes times numbers of [-1, 1].
template <std::size_t N>
[[nodiscard]] HardwareBall sway(const std::array<HardwareBall, N>& slopes) {
  double sum = 0;
  for (const HardwareBall& slope : slopes) {
    add_magnitude(sum, slope);
  }
  return HardwareBall::within(sum);
}
template <std::size_t N>
[[nodiscard]] Ball sway(const std::array<Ball, N>& slopes) {
  Ball sum(0);
  for (const Ball& slope : slopes) {
    sum += abs(slope);
  }
  const Ball bound = sum.upper();
  return Ball::hull(-bound, bound);
}

// middle + sway(slopes).
template <std::size_t N>
[[nodiscard]] HardwareBall mean_value(const HardwareBall& middle, const std::array<HardwareBall, N>& slopes) {
  double sum = middle.radius();
  for (const HardwareBall& slope : slopes) {
    sum += std::abs(slope.approximate()) + slope.radius();
  }
  return {middle.approximate(), sum * (1 + 0x1p-48)};
}
template <std::size_t N>
[[nodiscard]] Ball mean_value(const Ball& middle, const std::array<Ball, N>& slopes) {
  return middle + sway(slopes);
}

[[nodiscard]] inline Ball sum_of_products(const Ball& a, const Ball& x, const Ball& b, const Ball& y) {
  return a * x + b * y;
}

// The second derivative of sinc. It lies in [-1/3, 1/3], and so does the fourth in [-1/5, 1/5].
template <class S>
[[nodiscard]] S sinc_curvature(const S& x) {
  const S square = x * x;
  if (S(square - S(1)).is_positive()) {
    return -sinc(x) - S(2) * sinc_slope(x) / x;
  }
  return S(-1) / S(3) + sway(std::array<S, 1>{S(square / S(10))});
}

// A ball around [low, high].
template <class S>
[[nodiscard]] S around(double low, double high) {
  const double middle = low + (high - low) / 2;
  const double reach = std::nextafter(std::max(high - middle, middle - low), INFINITY);
  return S(middle) + sway(std::array<S, 1>{S(reach)});
}

template <class S, int N>
struct Form {
  using Slopes = std::array<S, static_cast<std::size_t>(N)>;

  S at = S(0);    // where all variables are 0
  S over = S(0);  // everywhere
  Slopes slopes = none();

  Form() = default;
  Form(int constant) : at(constant), over(constant) {}           // NOLINT: scalars convert from int
  Form(S constant) : at(constant), over(std::move(constant)) {}  // NOLINT: a constant has no slope

  // middle + radius e_i. Both are taken as they are: the caller sees to it that no member is missing.
  [[nodiscard]] static Form variable(double middle, double radius, int i) {
    Form x{S(middle)};
    const S share(radius);
    x.slopes[static_cast<std::size_t>(i)] = share;
    x.over = x.at + sway(x.slopes);
    return x;
  }

  // g(this) of which the value at the middle, the range, and the range of the derivative are known.
  [[nodiscard]] Form chain(S middle, S range, const S& slope) const {
    Form result;
    result.at = std::move(middle);
    result.over = std::move(range);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      if (!is_zero(slopes[i])) {
        result.slopes[i] = slope * slopes[i];
      }
    }
    result.sharpen();
    return result;
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

  Form& operator+=(const Form& b) {
    at += b.at;
    over += b.over;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      if (!is_zero(b.slopes[i])) {
        slopes[i] += b.slopes[i];
      }
    }
    sharpen();
    return *this;
  }
  Form& operator-=(const Form& b) {
    at -= b.at;
    over -= b.over;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      if (!is_zero(b.slopes[i])) {
        slopes[i] -= b.slopes[i];
      }
    }
    sharpen();
    return *this;
  }
  Form& operator*=(const Form& b) { return *this = *this * b; }
  Form& operator/=(const Form& b) { return *this = *this / b; }
  friend Form operator+(Form a, const Form& b) { return a += b; }
  friend Form operator-(Form a, const Form& b) { return a -= b; }
  friend Form operator*(const Form& a, const Form& b) {
    Form result;
    result.at = a.at * b.at;
    result.over = a.over * b.over;
    for (std::size_t i = 0; i < result.slopes.size(); ++i) {
      if (is_zero(b.slopes[i])) {
        if (!is_zero(a.slopes[i])) {
          result.slopes[i] = b.over * a.slopes[i];
        }
      } else if (is_zero(a.slopes[i])) {
        result.slopes[i] = a.over * b.slopes[i];
      } else {
        result.slopes[i] = sum_of_products(a.over, b.slopes[i], b.over, a.slopes[i]);
      }
    }
    result.sharpen();
    return result;
  }
  friend Form operator/(const Form& a, const Form& b) {
    const S inverse = S(1) / b.over;
    if (std::all_of(b.slopes.begin(), b.slopes.end(), [](const S& slope) { return is_zero(slope); })) {
      return a.chain(a.at * inverse, a.over * inverse, inverse);  // a constant
    }
    Form result;
    result.at = a.at / b.at;
    result.over = a.over / b.over;
    for (std::size_t i = 0; i < result.slopes.size(); ++i) {
      if (!is_zero(b.slopes[i])) {
        result.slopes[i] = (a.slopes[i] - result.over * b.slopes[i]) * inverse;
      } else if (!is_zero(a.slopes[i])) {
        result.slopes[i] = a.slopes[i] * inverse;
      }
    }
    result.sharpen();
    return result;
  }
  friend Form operator-(const Form& a) { return a.chain(-a.at, -a.over, S(-1)); }
  friend Form operator+(const Form& a) { return a; }

  friend std::pair<Form, Form> sin_cos(const Form& a) {
    const std::pair<S, S> middle = sin_cos(a.at);
    const std::pair<S, S> range = sin_cos(a.over);
    return {a.chain(middle.first, range.first, range.second),
            a.chain(middle.second, range.second, -range.first)};
  }
  friend Form sin(const Form& a) { return sin_cos(a).first; }
  friend Form cos(const Form& a) { return sin_cos(a).second; }
  friend Form sinc(const Form& a) { return a.chain(sinc(a.at), sinc(a.over), sinc_slope(a.over)); }
  friend Form sinc_slope(const Form& a) {
    return a.chain(sinc_slope(a.at), sinc_slope(a.over), sinc_curvature(a.over));
  }
  // Whether it is zero everywhere: then products with it need not be computed.
  friend bool is_zero(const Form& a) { return is_zero(a.over); }
  friend bool is_nonzero(const Form& a) { return a.over.is_nonzero(); }
  friend void add_product(Form& sum, const S& factor, const Form& b) { sum += Form(factor) * b; }
  friend Form sqrt(const Form& a) {
    const S root = sqrt(a.over);
    return a.chain(sqrt(a.at), root, S(1) / (S(2) * root));
  }

 private:
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
