#include "cli/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <thread>

#include "core/error.hpp"

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

Jobs jobs(const std::string& text) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return Jobs(static_cast<std::size_t>(whole_number("jobs", text, most_jobs, cores)));
}

}  // namespace stickslip::cli
