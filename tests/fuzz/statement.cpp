// Statements: each line is refused, or read and printed in a way that reads the same again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "proofs/symbols/parse.hpp"

using namespace stickslip::proofs::symbols;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size) {
  static const Names names = names_of(symbol_table());
  const std::string line(reinterpret_cast<const char *>(data), size);
  try {
    for (const Statement& one : parse_statements(line, names)) {
      const std::string printed = text(one);
      if (text(parse_statements(printed, names).front()) != printed) {
        std::abort();
      }
    }
  } catch (const ParseError&) {
  }
  return 0;
}
