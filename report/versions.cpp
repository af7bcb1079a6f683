#include "report/versions.hpp"

#include <cln/version.h>
#include <fmt/format.h>
#include <ginac/version.h>
#include <gmp.h>
#include <mpfr.h>

#include <Eigen/Core>

#include "core/ball.hpp"

namespace stickslip::report {

std::string program_version() {
  return STICKSLIP_VERSION;
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

}  // namespace stickslip::report
