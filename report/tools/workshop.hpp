// A directory for other programs to work in.
#pragma once

#include <filesystem>
#include <string>

namespace stickslip::report::tools {

// A directory of its own, gone with all that is in it.
class Workshop {
 public:
  // Throws InputOutputError, which says what it was for ("compile LaTeX"), if none can be made.
  explicit Workshop(const std::string& purpose);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Of a file in it; empty if it is not there.
  [[nodiscard]] std::string content(const std::string& file) const;

 private:
  std::filesystem::path path_;
};

}  // namespace stickslip::report::tools
