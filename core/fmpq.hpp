// FLINT's rational numbers, for calls of its functions only: what is kept is a Rational.
#pragma once

#if __has_include(<flint/fmpq.h>)
#include <flint/fmpq.h>
#endif

#include "core/rational.hpp"

namespace stickslip {

class Fmpq {
 public:
  Fmpq() { fmpq_init(value_); }
  explicit Fmpq(const Rational& value) : Fmpq() { fmpq_set_mpq(value_, value.get_mpq_t()); }
  Fmpq(const Fmpq&) = delete;
  Fmpq& operator=(const Fmpq&) = delete;
  ~Fmpq() { fmpq_clear(value_); }

  [[nodiscard]] fmpq * raw() { return value_; }
  [[nodiscard]] const fmpq * raw() const { return value_; }
  [[nodiscard]] Rational value() const {
    Rational result;
    fmpq_get_mpq(result.get_mpq_t(), value_);
    return result;
  }

 private:
  fmpq_t value_;
};

}  // namespace stickslip
