// Parameter files: each is understood, value by value, or refused.
#include <cstddef>
#include <cstdint>

#include "cli/arguments/typed_parameters.hpp"
#include "core/decimal.hpp"
#include "core/error.hpp"

using namespace stickslip;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size) {
  const std::string text(reinterpret_cast<const char *>(data), size);
  try {
    for (const auto& [name, value] : cli::parse_parameters(text, "FILE")) {
      (void)stickslip::parse_range(name, value);
    }
  } catch (const UsageError&) {
  }
  return 0;
}
