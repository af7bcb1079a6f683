// The reader of decimals: whatever it accepts means what its shortest notation means, and lies where its last
// digit says.
#include "core/decimal.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "core/error.hpp"

using namespace stickslip;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size) {
  const std::string text(reinterpret_cast<const char *>(data), size);
  const auto require = [](bool holds, const char * what) {
    if (!holds) {
      throw std::logic_error(what);
    }
  };
  try {
    const Rational value = parse_rational(text);
    require(parse_rational(to_string(value)) == value, "the notation of a number is another number");
    const Decimal decimal = parse_decimal(text);
    require(decimal.value == value, "a decimal is read in two ways");
    require(decimal.unit > 0 && decimal.lower() < value && value < decimal.upper(),
            "a last digit of no weight");
  } catch (const UsageError&) {
  }
  return 0;
}
