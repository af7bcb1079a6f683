// Programs that draw, typeset and compile.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::report::tools {

// A program, the Debian package that has it, and what it is wanted for: "draw a plot".
struct Tool {
  std::string program;
  std::string package;
  std::string purpose;
};

// Whether the program is found on the PATH.
[[nodiscard]] bool is_there(const Tool& tool);

// Throws InputOutputError naming the program and its package unless it is found on the PATH.
void require(const Tool& tool);

// What the program writes to its standard output for these arguments and this standard input, run in the
// directory if one is named. Throws InputOutputError when it is not there, or when it fails, with the first
// line of its complaint.
[[nodiscard]] std::string run(const Tool& tool, const std::vector<std::string>& arguments,
                              const std::string& input = {}, const std::filesystem::path& directory = {});

// What a program wrote, whether or not it failed.
struct Ran {
  bool succeeded = false;
  std::string output, complaints;  // to its standard output, and to standard error
};
// The same of a program that may fail. Throws InputOutputError when it is not there.
[[nodiscard]] Ran attempt(const Tool& tool, const std::vector<std::string>& arguments,
                          const std::string& input = {}, const std::filesystem::path& directory = {});

// The version in what a program says about itself: from the first digit to the end of the line.
[[nodiscard]] std::string version_in(const std::string& text);

// A directory for other programs to work in.

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
