#include "report/tools/latex.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "report/tools/process.hpp"

namespace stickslip::report::tools {
namespace {

namespace fs = std::filesystem;

const Tool& compiler() {
  static const Tool tool{"latexmk", "latexmk, with texlive-latex-recommended", "compile LaTeX"};
  return tool;
}

// A directory of its own, gone with all that is in it.
class Workshop {
 public:
  Workshop() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "stickslip-XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr) {
      throw InputOutputError("cannot compile LaTeX: there is no temporary directory to do it in");
    }
    path_ = name;
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

bool can_compile() {
  return is_there(compiler());
}

Compiled compile(const std::vector<File>& files, const std::string& name) {
  if (!can_compile()) {
    return {{}, fmt::format("{} is not there (Debian has it in {})", compiler().program, compiler().package)};
  }
  try {
    const Uninterrupted until_it_is_cleaned_up;
    const Workshop workshop;
    write_files(workshop.path(), files);
    std::vector<std::string> arguments{"-pdf", "-halt-on-error", "-interaction=nonstopmode",
                                       "-no-shell-escape", name + ".tex"};
    (void)run(compiler(), arguments, {}, workshop.path());
    // Latexmk misses a table of contents that was written twice in one second with the same length: once
    // more.
    arguments.insert(arguments.begin(), "-g");
    (void)run(compiler(), arguments, {}, workshop.path());
    return {{{name + ".pdf", read_file(workshop.path() / (name + ".pdf"))}}, {}};
  } catch (const InputOutputError& error) {
    return {{}, error.what()};
  }
}

}  // namespace stickslip::report::tools
