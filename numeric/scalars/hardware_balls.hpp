// A few hardware balls at once, such as the slopes of a form: the operations of hardware_ball.hpp in loops
// that compilers make vector instructions of. The same bounds hold for each of them. What is exactly zero
// stays so, times what is known: 2^-1000, which covers what a product may lose where it underflows, is added
// to the others only. Sums lose nothing there: they are multiples of 2^-1074.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "numeric/scalars/hardware_ball.hpp"

namespace stickslip::numeric::scalars {

template <std::size_t N>
class HardwareBalls {
 public:
  // One of them, to read and to write.
  class Place : public HardwareBall {
   public:
    Place(HardwareBalls& all, std::size_t i) : HardwareBall(all.ball(i)), all_(all), i_(i) {}
    Place(const Place&) = default;
    Place& operator=(const HardwareBall& b) {
      HardwareBall::operator=(b);
      all_.mid_[i_] = b.approximate();
      all_.rad_[i_] = b.radius();
      return *this;
    }
    Place& operator=(const Place& b) { return *this = static_cast<const HardwareBall&>(b); }

   private:
    HardwareBalls& all_;
    std::size_t i_;
  };

  [[nodiscard]] static constexpr std::size_t size() { return N; }
  [[nodiscard]] HardwareBall operator[](std::size_t i) const { return ball(i); }
  [[nodiscard]] Place operator[](std::size_t i) { return {*this, i}; }
  [[nodiscard]] Place back() { return {*this, N - 1}; }
  void fill(const HardwareBall& b) {
    for (std::size_t i = 0; i < N; ++i) {
      (*this)[i] = b;
    }
  }

  friend HardwareBalls operator+(const HardwareBalls& x, const HardwareBalls& y) {
    HardwareBalls sum;
    for (std::size_t i = 0; i < width; ++i) {
      const double mid = x.mid_[i] + y.mid_[i];
      sum.mid_[i] = mid;
      sum.rad_[i] = above(x.rad_[i] + y.rad_[i] + std::abs(mid) * 0x1p-53);
    }
    return sum;
  }
  friend HardwareBalls operator-(const HardwareBalls& x, const HardwareBalls& y) {
    HardwareBalls difference;
    for (std::size_t i = 0; i < width; ++i) {
      const double mid = x.mid_[i] - y.mid_[i];
      difference.mid_[i] = mid;
      difference.rad_[i] = above(x.rad_[i] + y.rad_[i] + std::abs(mid) * 0x1p-53);
    }
    return difference;
  }
  // a x, of each.
  friend HardwareBalls operator*(const HardwareBall& a, const HardwareBalls& x) {
    const double mid_a = a.approximate(), rad_a = a.radius();
    const double size_a = std::abs(mid_a) + rad_a;
    HardwareBalls product;
    for (std::size_t i = 0; i < width; ++i) {
      const double mid = mid_a * x.mid_[i];
      const double size = std::abs(x.mid_[i]);
      const double underflow = size + x.rad_[i] != 0 ? 0x1p-1000 : 0;
      product.mid_[i] = mid;
      product.rad_[i] = above(size_a * x.rad_[i] + rad_a * size + (std::abs(mid) * 0x1p-53 + underflow));
    }
    return product;
  }
  // a x + b y, of each.
  friend HardwareBalls sum_of_products(const HardwareBall& a, const HardwareBalls& x, const HardwareBall& b,
                                       const HardwareBalls& y) {
    const double mid_a = a.approximate(), rad_a = a.radius();
    const double mid_b = b.approximate(), rad_b = b.radius();
    const double size_a = std::abs(mid_a) + rad_a, size_b = std::abs(mid_b) + rad_b;
    HardwareBalls sum;
    for (std::size_t i = 0; i < width; ++i) {
      const double ax = mid_a * x.mid_[i];
      const double by = mid_b * y.mid_[i];
      const double mid = ax + by;
      const double size_x = std::abs(x.mid_[i]), size_y = std::abs(y.mid_[i]);
      const double spread = (size_a * x.rad_[i] + rad_a * size_x) + (size_b * y.rad_[i] + rad_b * size_y);
      const double underflow = (size_x + size_y) + (x.rad_[i] + y.rad_[i]) != 0 ? 0x1p-998 : 0;
      sum.mid_[i] = mid;
      sum.rad_[i] = above(spread + ((std::abs(ax) + std::abs(by) + std::abs(mid)) * 0x1p-53 + underflow));
    }
    return sum;
  }
  // The sum of their |x|, at most four times rounded, for all members.
  [[nodiscard]] double magnitude() const {
    std::array<double, width> sum;
    for (std::size_t i = 0; i < width; ++i) {
      sum[i] = std::abs(mid_[i]) + rad_[i];
    }
    for (std::size_t rest = width / 2; rest > 0; rest /= 2) {
      for (std::size_t i = 0; i < rest; ++i) {
        sum[i] += sum[i + rest];
      }
    }
    return sum[0];
  }
  friend bool is_zero(const HardwareBalls& x) { return x.magnitude() == 0; }

 private:
  static constexpr std::size_t width = std::bit_ceil(std::max<std::size_t>(N, 4));  // the rest stays zero

  [[nodiscard]] HardwareBall ball(std::size_t i) const { return {mid_[i], rad_[i]}; }
  // As in hardware_ball.hpp.
  [[nodiscard]] static double above(double rad) { return rad * (1 + 0x1p-48); }

  std::array<double, width> mid_{};
  std::array<double, width> rad_{};
};

}  // namespace stickslip::numeric::scalars
