#include "core/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/error.hpp"

namespace stickslip {
namespace {

constexpr long largest_exponent = 10000;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// What is probably meant by a text that is no number: 12,4 or 12.4 kg.
std::string hint(std::string_view text) {
  const std::size_t end = text.find_first_not_of("+-.0123456789");
  const bool begins_well =
      end != std::string_view::npos &&
      std::any_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), is_digit);
  if (begins_well && text[end] == ',') {
    return fmt::format("a decimal has a point, {}.{}", text.substr(0, end), text.substr(end + 1));
  }
  if (begins_well && (text[end] == ' ' || std::isalpha(static_cast<unsigned char>(text[end])) != 0)) {
    return fmt::format("write {} alone, without a unit", text.substr(0, end));
  }
  return "write a decimal such as 0.1607 or 2.5e-3, or a fraction such as 1/3";
}

[[noreturn]] void not_a_number(std::string_view text) {
  throw UsageError(fmt::format("'{}' is not a number: {}", text, hint(text)));
}

Rational power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent >= 0 ? Rational(power) : Rational(1) / Rational(power);
}

// Takes the leading digits off `rest`.
std::string take_digits(std::string_view& rest) {
  const auto end = std::find_if_not(rest.begin(), rest.end(), is_digit);
  std::string digits(rest.begin(), end);
  rest.remove_prefix(digits.size());
  return digits;
}

// Takes a sign off `rest`: -1 or 1.
int take_sign(std::string_view& rest) {
  constexpr std::string_view unicode_minus = "\u2212";
  if (rest.starts_with(unicode_minus)) {
    rest.remove_prefix(unicode_minus.size());
    return -1;
  }
  if (rest.starts_with('-') || rest.starts_with('+')) {
    const int sign = rest.front() == '-' ? -1 : 1;
    rest.remove_prefix(1);
    return sign;
  }
  return 1;
}

// Takes e[+-]digits off `rest`, 0 when there is none.
long take_exponent(std::string_view& rest, std::string_view text) {
  if (!rest.starts_with('e') && !rest.starts_with('E')) {
    return 0;
  }
  rest.remove_prefix(1);
  const int sign = take_sign(rest);
  const std::string digits = take_digits(rest);
  if (digits.empty() || digits.size() > 6 || std::stol(digits) > largest_exponent) {
    not_a_number(text);
  }
  return sign * std::stol(digits);
}

Rational parse_named(const std::string& name, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace

DomainError::DomainError(const std::string& name, const std::string& value, const std::string& range)
    : Error(exit_domain, fmt::format("{} = {} is outside the allowed range: {}", name, value, range)) {}

Decimal parse_decimal(std::string_view text) {
  std::string_view rest = text;
  const int sign = take_sign(rest);
  std::string digits = take_digits(rest);
  long places = 0;
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    const std::string fraction = take_digits(rest);
    places = static_cast<long>(fraction.size());
    digits += fraction;
  }
  if (digits.empty()) {
    not_a_number(text);
  }
  const long exponent = take_exponent(rest, text);
  if (!rest.empty()) {
    not_a_number(text);
  }
  const Rational unit = power_of_ten(exponent - places);
  return {std::string(text), sign * Rational(mpz_class(digits, 10)) * unit, unit};
}

Rational parse_rational(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) {
    return parse_decimal(text).value;
  }
  std::string_view numerator = text.substr(0, slash);
  std::string_view denominator = text.substr(slash + 1);
  const int sign = take_sign(numerator);
  const std::string above = take_digits(numerator);
  const std::string below = take_digits(denominator);
  if (above.empty() || below.empty() || !numerator.empty() || !denominator.empty() ||
      mpz_class(below, 10) == 0) {
    not_a_number(text);
  }
  return sign * Rational(mpz_class(above, 10)) / Rational(mpz_class(below, 10));
}

Range parse_range(const std::string& name, const std::string& text) {
  for (const std::string separator : {"+-", "±"}) {
    const std::size_t place = text.find(separator);
    if (place != std::string::npos) {
      const Range range{parse_named(name, text.substr(0, place)),
                        parse_named(name, text.substr(place + separator.size()))};
      if (range.radius < 0) {
        throw UsageError(fmt::format("{}: '{}' has a negative half width", name, text));
      }
      return range;
    }
  }
  return {parse_named(name, text)};
}

std::string to_string(const Rational& value) {
  constexpr long most_places = 40;
  mpz_class rest = value.get_den();
  const auto remove_factor = [&rest](unsigned long p) {
    const mpz_class prime(p);
    return static_cast<long>(mpz_remove(rest.get_mpz_t(), rest.get_mpz_t(), prime.get_mpz_t()));
  };
  const long twos = remove_factor(2);
  const long fives = remove_factor(5);
  const long places = std::max(twos, fives);
  if (rest != 1 || places > most_places) {
    return value.get_str();
  }
  const Rational scaled = abs(value) * power_of_ten(places);
  std::string digits = scaled.get_num().get_str();
  const auto wanted = static_cast<std::size_t>(places) + 1;
  if (digits.size() < wanted) {
    digits.insert(0, wanted - digits.size(), '0');
  }
  if (places > 0) {
    digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
  }
  return (value < 0 ? "-" : "") + digits;
}

}  // namespace stickslip
