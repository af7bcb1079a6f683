// Exact rational numbers at a random point of the field in which identities are decided.
//
// That field is made of rational functions in symbols, pi, and a pair (cos, sin) for every phase, a monomial
// of symbols and pi such as omega1*tau or pi*omega1/omega, and its exponential; all of these are independent
// except for cos² + sin² = 1. A point gives each symbol, pi among them, a rational number, each phase a
// rational point of the circle and a positive rational number as its exponential. What is identically zero is
// exactly zero there; what is not is nonzero at almost every point. Nothing here knows a normal form: numbers
// are added and multiplied as they come.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/rational.hpp"
#include "model/scalar_traits.hpp"

namespace stickslip::numeric::scalars {

class ExactPoint;

// A denominator is zero at the point: take another one.
struct ZeroDivision : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The number has no exact value: an angle or exponent that is no combination of phases with coefficients in
// Z/4.
struct NoExactValue : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A scalar of the model.
class Exact {
 public:
  Exact() = default;
  Exact(int value) : Exact(Rational(value)) {}  // NOLINT: scalars convert from int
  explicit Exact(Rational value) : value_(std::move(value)) {}

  [[nodiscard]] const Rational& value() const { return value_; }

  Exact& operator+=(const Exact& b);
  Exact& operator-=(const Exact& b) { return *this += Exact(-1) * b; }
  Exact& operator*=(const Exact& b);
  Exact& operator/=(const Exact& b);  // throws ZeroDivision
  friend Exact operator+(Exact a, const Exact& b) { return a += b; }
  friend Exact operator-(Exact a, const Exact& b) { return a -= b; }
  friend Exact operator*(Exact a, const Exact& b) { return a *= b; }
  friend Exact operator/(Exact a, const Exact& b) { return a /= b; }
  friend Exact operator-(const Exact& a) { return Exact(-1) * a; }
  friend Exact operator+(const Exact& a) { return a; }

  // Throw NoExactValue.
  friend std::pair<Exact, Exact> sin_cos(const Exact& angle);
  friend Exact sin(const Exact& angle) { return sin_cos(angle).first; }
  friend Exact cos(const Exact& angle) { return sin_cos(angle).second; }
  friend Exact exp(const Exact& exponent);
  friend bool is_zero(const Exact& a) { return a.value_ == 0; }

 private:
  friend class ExactPoint;
  using Monomial = std::map<std::string, int>;  // name -> exponent
  // The number as a combination of monomials, for as long as it is a short one: it may become an angle.
  struct Form {
    const ExactPoint * point = nullptr;
    std::map<Monomial, Rational> terms;
  };
  enum class Kind { constant, formed, formless };

  [[nodiscard]] Form form() const;
  void set_form(Form form);
  void lose_form();

  Rational value_;
  Kind kind_ = Kind::constant;
  std::shared_ptr<const Form> form_;
};

// The point with this number: the same values on every run. It has to outlive the numbers made from it.
class ExactPoint {
 public:
  explicit ExactPoint(unsigned seed) : seed_(seed) {}
  ExactPoint(const ExactPoint&) = delete;
  ExactPoint& operator=(const ExactPoint&) = delete;

  // The symbol, between 0 and 1 for omega1, above 1 for omega2, positive for all others.
  [[nodiscard]] Exact symbol(const std::string& name) const;

 private:
  friend std::pair<Exact, Exact> sin_cos(const Exact& angle);
  friend Exact exp(const Exact& exponent);
  // (sin, cos) of a quarter of the phase.
  [[nodiscard]] std::pair<Rational, Rational> quarter(const Exact::Monomial& phase) const;
  // exp of a quarter of the phase.
  [[nodiscard]] Rational growth(const Exact::Monomial& phase) const;
  [[nodiscard]] Rational draw(const std::string& name) const;

  unsigned seed_;
};

}  // namespace stickslip::numeric::scalars

namespace Eigen {

template <>
struct NumTraits<stickslip::numeric::scalars::Exact>
    : stickslip::model::ScalarTraits<stickslip::numeric::scalars::Exact, 10, 100, 100> {};

}  // namespace Eigen
