// What the paper prints about its three examples: the data and the numbers of Figs. 2, 3 and 4.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/decimal.hpp"
#include "numeric/motion/domain.hpp"

namespace stickslip::numeric::families {
struct Family;
}

namespace stickslip::proofs::pascal2012 {

// A printed result. Where the sign is not legible in the source, only the digits are a printed fact.
struct PrintedResult {
  std::string name;
  Decimal value;
  bool sign_lost = false;
};

struct Example {
  std::string name;    // "S", "O", "P"
  std::string figure;  // "Fig. 2"
  const numeric::families::Family * family = nullptr;
  numeric::motion::ExactParameters data;
  std::optional<Rational> phi, ur;  // as far as they are data of the family
  std::vector<PrintedResult> results;

  // Throws InternalError when there is no result of that name.
  [[nodiscard]] const PrintedResult& result(const std::string& result_name) const;
};

// S, O, P: symmetric, overshooting, non-sticking.
[[nodiscard]] const std::vector<Example>& printed_examples();

// Throws UsageError naming the known ones when there is no example of that name.
[[nodiscard]] const Example& example_named(const std::string& name);

}  // namespace stickslip::proofs::pascal2012
