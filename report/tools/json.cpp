#include "report/tools/json.hpp"

#include <cln/version.h>
#include <fmt/format.h>
#include <ginac/version.h>
#include <gmp.h>
#include <mpfr.h>

#include <Eigen/Core>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include "core/ball.hpp"
#include "core/error.hpp"

namespace stickslip::report::tools {

std::string program_version() {
  return STICKSLIP_VERSION;
}

std::optional<std::string> source_date() {
  const char * variable = std::getenv("SOURCE_DATE_EPOCH");
  if (variable == nullptr || *variable == '\0') {
    return std::nullopt;
  }
  const std::string_view text(variable);
  std::time_t seconds = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  std::tm utc{};
  if (error != std::errc() || rest != text.data() + text.size() || ::gmtime_r(&seconds, &utc) == nullptr) {
    throw UsageError(fmt::format("SOURCE_DATE_EPOCH: '{}' is not a whole number of seconds", text));
  }
  char buffer[64];
  return std::string(buffer, std::strftime(buffer, sizeof buffer, "%Y-%m-%dT%H:%M:%SZ", &utc));
}

std::vector<Component> libraries() {
  return {
      {"GiNaC", fmt::format("{}.{}.{}", GiNaC::version_major, GiNaC::version_minor, GiNaC::version_micro)},
      {"CLN", fmt::format("{}.{}.{}", cln::version_major, cln::version_minor, cln::version_patchlevel)},
      {"Arb", arb_version},
      {"FLINT", flint_version},
      {"MPFR", MPFR_VERSION_STRING},
      {"GMP", gmp_version},
      {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
  };
}

}  // namespace stickslip::report::tools
