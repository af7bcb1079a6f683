// The rational numbers of the kernel.
#pragma once

#include <compare>
#include <stdexcept>

#include "core/rational.hpp"

namespace stickslip::proofs::kernel {

// A rule or a constructor refuses: one sentence that says why.
struct KernelError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Always in lowest terms with a positive denominator, in whatever state the rational is that it is made of,
// and never changed: what a rule checks is what it uses. Nothing else holds a number in the kernel.
class Number {
 public:
  Number(int value = 0) : Number(static_cast<long>(value)) {}  // NOLINT: numbers are made of these
  Number(long value) : value_(value) {}                        // NOLINT
  // Throws KernelError for a denominator 0.
  Number(Rational value);  // NOLINT
  template <class T, class U>
  Number(const __gmp_expr<T, U>& value) : Number(Rational(value)) {}  // NOLINT
  Number(double) = delete;
  Number(bool) = delete;

  operator const Rational &() const { return value_; }  // NOLINT
  [[nodiscard]] const Rational& value() const { return value_; }
  friend Rational operator+(const Number& a, const Number& b) { return a.value_ + b.value_; }
  friend Rational operator-(const Number& a, const Number& b) { return a.value_ - b.value_; }

  friend std::strong_ordering operator<=>(const Number& a, const Number& b) {
    return cmp(a.value_, b.value_) <=> 0;
  }
  friend bool operator==(const Number& a, const Number& b) { return a.value_ == b.value_; }

 private:
  Rational value_;
};

}  // namespace stickslip::proofs::kernel
