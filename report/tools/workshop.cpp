#include "report/tools/workshop.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include "core/error.hpp"
#include "report/tools/files.hpp"

namespace stickslip::report::tools {

namespace fs = std::filesystem;

Workshop::Workshop(const std::string& purpose) {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "stickslip-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr) {
    throw InputOutputError(fmt::format("cannot {}: there is no temporary directory to do it in", purpose));
  }
  path_ = name;
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Workshop::content(const std::string& file) const {
  return fs::exists(path_ / file) ? read_file(path_ / file) : "";
}

}  // namespace stickslip::report::tools
