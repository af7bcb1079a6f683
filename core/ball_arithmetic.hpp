// Real balls [mid ± rad] with outward rounding (Arb): the only numbers that may decide anything.
#pragma once

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include <utility>

#include "core/rational.hpp"

namespace stickslip {

// Sets the number of bits that Ball operations of this thread round to, until the object is destroyed.
// The default is 128. Throws nothing; bits must be at least 2.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(long bits);
  ~WorkingPrecision();
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

  [[nodiscard]] static long bits() { return bits_; }

 private:
  long previous_;
  static constinit thread_local long bits_;  // constinit: no wrapper function at every use
};

// A ball contains every real number that it stands for. Each operation returns a ball that contains the exact
// result for all members of its operands; where the result is not defined for some member (division by a ball
// that contains 0, square root of one that reaches below 0) it returns the whole line or "indeterminate",
// which contains everything, overlaps everything and decides nothing. There is no operator<: see the
// predicates.
class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(int value) : Ball() { arb_set_si(value_, value); }    // NOLINT: scalars convert from int
  Ball(long value) : Ball() { arb_set_si(value_, value); }   // NOLINT
  Ball(double value) : Ball() { arb_set_d(value_, value); }  // NOLINT: exactly the double
  explicit Ball(const Rational& value);                      // rounded at the working precision
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  // The smallest ball found at the working precision that contains [lower, upper].
  [[nodiscard]] static Ball from_interval(const Rational& lower, const Rational& upper);
  // The smallest ball that contains both.
  [[nodiscard]] static Ball hull(const Ball& a, const Ball& b);
  [[nodiscard]] static Ball pi();

  [[nodiscard]] arb_ptr raw() { return value_; }
  [[nodiscard]] arb_srcptr raw() const { return value_; }

  Ball& operator+=(const Ball& b) { return combined<arb_add>(b); }
  Ball& operator-=(const Ball& b) { return combined<arb_sub>(b); }
  Ball& operator*=(const Ball& b) { return combined<arb_mul>(b); }
  Ball& operator/=(const Ball& b) { return combined<arb_div>(b); }
  friend Ball operator+(Ball a, const Ball& b) { return a += b; }
  friend Ball operator-(Ball a, const Ball& b) { return a -= b; }
  friend Ball operator*(Ball a, const Ball& b) { return a *= b; }
  friend Ball operator/(Ball a, const Ball& b) { return a /= b; }
  friend Ball operator-(Ball a) {
    arb_neg(a.value_, a.value_);
    return a;
  }
  friend Ball operator+(Ball a) { return a; }

  friend Ball sin(const Ball& a) { return a.applied<arb_sin>(); }
  friend Ball cos(const Ball& a) { return a.applied<arb_cos>(); }
  friend Ball tan(const Ball& a) { return a.applied<arb_tan>(); }
  friend Ball exp(const Ball& a) { return a.applied<arb_exp>(); }
  friend Ball sqrt(const Ball& a) { return a.applied<arb_sqrt>(); }
  friend Ball abs(Ball a) {
    arb_abs(a.value_, a.value_);
    return a;
  }

  // Predicates are true only when the statement holds for every member.
  [[nodiscard]] bool is_positive() const { return arb_is_positive(value_) != 0; }
  [[nodiscard]] bool is_negative() const { return arb_is_negative(value_) != 0; }
  [[nodiscard]] bool is_nonzero() const { return arb_is_nonzero(value_) != 0; }
  [[nodiscard]] bool is_finite() const { return arb_is_finite(value_) != 0; }
  [[nodiscard]] bool is_exact() const { return arb_is_exact(value_) != 0; }
  [[nodiscard]] bool overlaps(const Ball& b) const { return arb_overlaps(value_, b.value_) != 0; }
  [[nodiscard]] bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  [[nodiscard]] bool contains(const Ball& b) const { return arb_contains(value_, b.value_) != 0; }
  [[nodiscard]] bool contains(const Rational& q) const;
  // Every member of this ball lies strictly inside b (b's ends excluded).
  [[nodiscard]] bool is_interior_to(const Ball& b) const {
    return arb_contains_interior(b.value_, value_) != 0;
  }

  [[nodiscard]] Ball midpoint() const;       // exact, radius 0
  [[nodiscard]] Ball radius() const;         // exact, radius 0
  [[nodiscard]] Ball lower() const;          // exact: no member is below
  [[nodiscard]] Ball upper() const;          // exact: no member is above
  [[nodiscard]] double approximate() const;  // the midpoint as a double: for guesses and pictures only

 private:
  template <auto operation>
  Ball& combined(const Ball& b) {
    operation(value_, value_, b.value_, WorkingPrecision::bits());
    return *this;
  }
  template <auto function>
  [[nodiscard]] Ball applied() const {
    Ball result;
    function(result.value_, value_, WorkingPrecision::bits());
    return result;
  }

  arb_t value_;
};

}  // namespace stickslip
