#include "report/tools/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace stickslip::report::tools {

std::string readable(const Ball& ball, int digits) {
  return ball.is_finite() ? to_string(ball, digits) : "unbounded";
}

std::optional<std::string> rounded_like(const Decimal& printed, const Ball& value) {
  // The nearest whole number of units, halves upwards.
  Ball nearest = value / Ball(printed.unit) + Ball(Rational(1, 2));
  arb_floor(nearest.raw(), nearest.raw(), WorkingPrecision::bits());
  if (!nearest.is_finite() || !nearest.is_exact()) {
    return std::nullopt;
  }
  fmpz_t whole;
  fmpz_init(whole);
  mpz_class units;
  arf_get_fmpz(whole, arb_midref(nearest.raw()), ARF_RND_NEAR);
  fmpz_get_mpz(units.get_mpz_t(), whole);
  fmpz_clear(whole);
  const std::size_t point = printed.text.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : printed.text.size() - point - 1;
  std::string digits = mpz_class(abs(units)).get_str();
  digits.insert(0, digits.size() > decimals ? 0 : decimals + 1 - digits.size(), '0');
  if (decimals > 0) {
    digits.insert(digits.size() - decimals, ".");
  }
  return (units < 0 ? "-" : "") + digits;
}

int known_digits(const Ball& ball, int digits) {
  if (ball.is_exact()) {
    return digits;
  }
  const auto bits = static_cast<double>(arb_rel_accuracy_bits(ball.raw()));
  const double known = std::clamp(bits * std::log10(2.0), 0.0, static_cast<double>(digits));
  return std::clamp(static_cast<int>(known) + 2, 2, std::max(digits, 2));
}

std::string rounded(const Ball& ball, int digits) {
  if (!ball.is_finite()) {
    return "unbounded";
  }
  constexpr long bits_per_digit = 4;
  if (!ball.is_exact() && arb_rel_accuracy_bits(ball.raw()) < 2 * bits_per_digit) {
    return to_string(ball, 2);
  }
  const int sure = known_digits(ball, digits + 2) - 2;
  return to_text(ball, std::min(digits, std::max(sure, 1))).mid;
}

std::string latex_factor(const Ball& value, int digits) {
  std::string text = rounded(value, digits);
  constexpr std::string_view radius = " ± ";
  const std::size_t sign = text.find(radius);
  std::vector<std::string> parts{text.substr(0, sign)};
  if (sign != std::string::npos) {
    parts.push_back(text.substr(sign + radius.size()));
  }
  for (std::string& part : parts) {
    if (const std::size_t e = part.find('e'); e != std::string::npos) {
      part = fmt::format("{}\\cdot 10^{{{}}}", part.substr(0, e), std::stoi(part.substr(e + 1)));
    }
  }
  return parts.size() == 1 ? parts[0] : fmt::format("({} \\pm {})", parts[0], parts[1]);
}

std::string latex_term(const Ball& value, const std::string& times, int digits) {
  std::string text = latex_factor(value, digits);
  if (text == "1" || text == "-1") {
    text.pop_back();
  }
  return text.starts_with("-") ? fmt::format(" - {}{}", text.substr(1), times)
                               : fmt::format(" + {}{}", text, times);
}

std::string below(double x, int digits) {
  std::string text = fmt::format("{:.{}g}", x, digits);
  // Of the last digit.
  const double unit = x == 0 ? 0 : std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - digits);
  for (int halves = 1; halves <= 2 && std::stod(text) > x; ++halves) {
    text = fmt::format("{:.{}g}", x - halves * unit / 2, digits);
  }
  return text;
}

std::string above(double x, int digits) {
  const std::string negative = below(-x, digits);
  return negative.starts_with('-') ? negative.substr(1) : negative == "0" ? negative : "-" + negative;
}

}  // namespace stickslip::report::tools
