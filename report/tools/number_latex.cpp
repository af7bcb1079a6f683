#include "report/tools/number_latex.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "report/tools/numbers.hpp"

namespace stickslip::report::tools {

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

}  // namespace stickslip::report::tools
