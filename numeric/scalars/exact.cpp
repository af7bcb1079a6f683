#include "numeric/scalars/exact.hpp"

#include <cstdint>
#include <cstdlib>

namespace stickslip::numeric::scalars {
namespace {

constexpr std::size_t longest_form = 12;

// A number from 0 to below `count` for the text: FNV-1a.
unsigned pick(unsigned seed, const std::string& text, unsigned count) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](std::uint64_t byte) { hash = (hash ^ byte) * 1099511628211ULL; };
  for (int shift = 0; shift < 32; shift += 8) {
    add((seed >> shift) & 0xffU);
  }
  for (const char c : text) {
    add(static_cast<unsigned char>(c));
  }
  return static_cast<unsigned>((hash ^ (hash >> 31)) % count);
}

Rational ratio(long numerator, long denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

// (sin, cos) of the sum of two angles.
using Pair = std::pair<Rational, Rational>;
Pair added(const Pair& a, const Pair& b) {
  return {Rational(a.first * b.second + a.second * b.first),
          Rational(a.second * b.second - a.first * b.first)};
}

Pair multiple(const Pair& angle, long count) {
  Pair result{0, 1};
  const Pair step = count < 0 ? Pair{Rational(-angle.first), angle.second} : angle;
  for (long i = 0; i < std::labs(count); ++i) {
    result = added(result, step);
  }
  return result;
}

// How often the angle goes into it.
long whole(const Rational& coefficient, int angles_per_unit) {
  const Rational count = coefficient * angles_per_unit;
  if (count.get_den() != 1 || abs(count) > 64) {
    throw NoExactValue("an angle or exponent is no small multiple of a quarter of a phase, or of pi/2");
  }
  return count.get_num().get_si();
}

std::string to_text(const std::map<std::string, int>& monomial) {
  std::string text;
  for (const auto& [name, exponent] : monomial) {
    text += name + "^" + std::to_string(exponent) + " ";
  }
  return text;
}

}  // namespace

Exact::Form Exact::form() const {
  if (kind_ == Kind::formed) {
    return *form_;
  }
  return {nullptr, value_ == 0 ? std::map<Monomial, Rational>{} : std::map<Monomial, Rational>{{{}, value_}}};
}

void Exact::set_form(Form form) {
  if (form.terms.size() > longest_form) {
    lose_form();
    return;
  }
  kind_ = Kind::formed;
  form_ = std::make_shared<const Form>(std::move(form));
}

void Exact::lose_form() {
  kind_ = Kind::formless;
  form_.reset();
}

Exact& Exact::operator+=(const Exact& b) {
  if (kind_ == Kind::formless || b.kind_ == Kind::formless) {
    lose_form();
  } else if (kind_ == Kind::formed || b.kind_ == Kind::formed) {
    Form sum = form();
    const Form more = b.form();
    sum.point = sum.point != nullptr ? sum.point : more.point;
    for (const auto& [monomial, coefficient] : more.terms) {
      Rational& total = sum.terms[monomial];
      total += coefficient;
      if (total == 0) {
        sum.terms.erase(monomial);
      }
    }
    set_form(std::move(sum));
  }
  value_ += b.value_;
  return *this;
}

Exact& Exact::operator*=(const Exact& b) {
  const bool zero = (kind_ == Kind::constant && value_ == 0) || (b.kind_ == Kind::constant && b.value_ == 0);
  if (zero) {
    return *this = Exact(0);
  }
  if (kind_ == Kind::formless || b.kind_ == Kind::formless) {
    lose_form();
  } else if (kind_ == Kind::formed || b.kind_ == Kind::formed) {
    const Form left = form(), right = b.form();
    Form product{left.point != nullptr ? left.point : right.point, {}};
    for (const auto& [x, a] : left.terms) {
      for (const auto& [y, c] : right.terms) {
        Monomial monomial = x;
        for (const auto& [name, exponent] : y) {
          if ((monomial[name] += exponent) == 0) {
            monomial.erase(name);
          }
        }
        Rational& total = product.terms[monomial];
        total += a * c;
        if (total == 0) {
          product.terms.erase(monomial);
        }
      }
    }
    set_form(std::move(product));
  }
  value_ *= b.value_;
  return *this;
}

Exact& Exact::operator/=(const Exact& b) {
  if (b.value_ == 0) {
    throw ZeroDivision("a division by zero");
  }
  Exact inverse(Rational(1 / b.value_));
  if (b.kind_ == Kind::formed && b.form_->terms.size() == 1) {
    const auto& [monomial, coefficient] = *b.form_->terms.begin();
    Form form{b.form_->point, {}};
    Monomial turned;
    for (const auto& [name, exponent] : monomial) {
      turned[name] = -exponent;
    }
    form.terms[turned] = 1 / coefficient;
    inverse.set_form(std::move(form));
  } else if (b.kind_ != Kind::constant) {
    inverse.lose_form();
  }
  return *this *= inverse;
}

std::pair<Exact, Exact> sin_cos(const Exact& angle) {
  if (angle.kind_ == Exact::Kind::formless) {
    throw NoExactValue("an angle is no combination of monomials");
  }
  const Exact::Form form = angle.form();
  static const Exact::Monomial pi{{"pi", 1}};
  Pair result{0, 1};
  for (const auto& [phase, coefficient] : form.terms) {
    if (phase.empty()) {
      throw NoExactValue("an angle contains a number that is no multiple of pi");
    }
    result = added(result, phase == pi ? multiple({1, 0}, whole(coefficient, 2))
                                       : multiple(form.point->quarter(phase), whole(coefficient, 4)));
  }
  Exact sine(result.first), cosine(result.second);
  if (!form.terms.empty()) {
    sine.lose_form();
    cosine.lose_form();
  }
  return {sine, cosine};
}

Exact exp(const Exact& exponent) {
  if (exponent.kind_ == Exact::Kind::formless) {
    throw NoExactValue("an exponent is no combination of monomials");
  }
  const Exact::Form form = exponent.form();
  Exact result(1);
  for (const auto& [phase, coefficient] : form.terms) {
    if (phase.empty()) {
      throw NoExactValue("an exponent contains a number");
    }
    const Rational once = form.point->growth(phase);
    const long count = whole(coefficient, 4);
    for (long i = 0; i < std::labs(count); ++i) {
      result *= Exact(count < 0 ? Rational(1 / once) : once);
    }
  }
  if (!form.terms.empty()) {
    result.lose_form();
  }
  return result;
}

Rational ExactPoint::draw(const std::string& name) const {
  const long part = 1 + pick(seed_, name, 30);
  return name == "omega1"   ? ratio(part, 31)
         : name == "omega2" ? Rational(1 + ratio(part, 13))
                            : ratio(part, 1 + pick(seed_ + 1, name, 12));
}

Exact ExactPoint::symbol(const std::string& name) const {
  Exact result(draw(name));
  result.set_form({this, {{{{name, 1}}, 1}}});
  return result;
}

std::pair<Rational, Rational> ExactPoint::quarter(const Exact::Monomial& phase) const {
  const std::string text = to_text(phase);
  const long m = 1 + pick(seed_ + 2, text, 9), n = m + 1 + pick(seed_ + 3, text, 7);
  return {ratio(2 * m * n, m * m + n * n), ratio(n * n - m * m, m * m + n * n)};
}

Rational ExactPoint::growth(const Exact::Monomial& phase) const {
  const std::string text = to_text(phase);
  const long m = 1 + pick(seed_ + 4, text, 13), n = m + 1 + pick(seed_ + 5, text, 29);
  return ratio(n, m);
}

}  // namespace stickslip::numeric::scalars
