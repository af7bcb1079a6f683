#include "report/tools/json.hpp"

namespace stickslip::report::tools {

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stickslip::report::tools
