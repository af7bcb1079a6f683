#include "cli/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <thread>

#include "cli/typed_parameters.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"
#include "numeric/scalars/scalars.hpp"

namespace stickslip::cli {
namespace {

constexpr int most_jobs = 1024;

}  // namespace

int whole_number(const std::string& name, const std::string& text, int most, int otherwise) {
  int value = otherwise;
  const char * const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (!text.empty() && (error != std::errc() || rest != end || value < 1 || value > most)) {
    throw UsageError(fmt::format("{}: '{}' is not a whole number from 1 to {}", name, text, most));
  }
  return value;
}

Rational exact_number(const std::string& name, const std::string& text) {
  const Range range = parse_range(name, text);
  if (range.radius != 0) {
    throw UsageError(fmt::format("{}: '{}' is an interval, but a number is needed here", name, text));
  }
  return range.middle;
}

std::pair<Rational, Rational> interval(const std::string& name, const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots != std::string::npos) {
    if (dots == 0 || dots + 2 == text.size()) {
      throw UsageError(fmt::format("{}: '{}' is not an interval A..B, such as 0.1..0.5", name, text));
    }
    const std::pair ends{exact_number(name, text.substr(0, dots)), exact_number(name, text.substr(dots + 2))};
    if (ends.first >= ends.second) {
      throw UsageError(fmt::format("{}: '{}' does not rise: A..B needs A < B", name, text));
    }
    return ends;
  }
  const std::size_t sign = text.find("+-");
  if (text.ends_with('%') && sign != std::string::npos) {
    const Rational middle = exact_number(name, text.substr(0, sign));
    const Rational share = exact_number(name, text.substr(sign + 2, text.size() - sign - 3)) / 100;
    const Rational radius = abs(middle * share);
    return {middle - radius, middle + radius};
  }
  const Range range = parse_range(name, text);
  return {range.middle - range.radius, range.middle + range.radius};
}

double number(const std::string& name, const std::string& text) {
  return numeric::scalars::scalar<double>(exact_number(name, text));
}

double positive(const std::string& name, const std::string& text) {
  const double value = number(name, text);
  if (!(value > 0)) {
    throw UsageError(fmt::format("{}: '{}' is not a positive number", name, text));
  }
  return value;
}

model::Vector4<double> four_numbers(const std::string& name, const std::string& text) {
  model::Vector4<double> X;
  std::size_t from = 0;
  for (int i = 0; i < 4; ++i) {
    const std::size_t comma = text.find(',', from);
    if ((comma == std::string::npos) != (i == 3)) {
      throw UsageError(fmt::format("{}: '{}' is not four numbers x1,x2,x1',x2'", name, text));
    }
    X(i) = number(name, text.substr(from, comma - from));
    from = comma + 1;
  }
  return X;
}

Jobs jobs(const std::string& text) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return Jobs(static_cast<std::size_t>(whole_number("jobs", text, most_jobs, cores)));
}

}  // namespace stickslip::cli
