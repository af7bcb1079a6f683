#include "report/tools/latex.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "report/tools/process.hpp"

namespace stickslip::report::tools {
namespace {

namespace fs = std::filesystem;

const Tool& compiler() {
  static const Tool tool{"pdflatex", "texlive-latex-recommended", "compile LaTeX"};
  return tool;
}

// What a pass leaves for the next one: numbers of pages, the contents, bookmarks.
std::string notes(const Workshop& workshop, const std::string& name) {
  return workshop.content(name + ".aux") + workshop.content(name + ".toc") + workshop.content(name + ".out");
}

// The first complaint in what TeX writes down.
std::string complaint(const std::string& log) {
  const std::size_t start = log.find("\n! ");
  return start == std::string::npos ? ""
                                    : ": " + log.substr(start + 3, log.find('\n', start + 1) - start - 3);
}

// Once without a document, then until the pass finds the notes that it leaves; whether it came to that.
bool settled(const Workshop& workshop, const std::string& name) {
  constexpr int most_passes = 6;
  std::vector<std::string> arguments{"-halt-on-error", "-interaction=nonstopmode", "-no-shell-escape",
                                     "-draftmode", name + ".tex"};
  (void)run(compiler(), arguments, {}, workshop.path());
  std::erase(arguments, "-draftmode");
  for (int pass = 2; pass <= most_passes; ++pass) {
    const std::string before = notes(workshop, name);
    (void)run(compiler(), arguments, {}, workshop.path());
    if (notes(workshop, name) == before) {
      return true;
    }
  }
  return false;
}

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
    const Workshop workshop("compile LaTeX");
    write_files(workshop.path(), files);
    try {
      if (!settled(workshop, name)) {
        return {{}, "its numbers of pages do not settle"};
      }
    } catch (const InputOutputError&) {
      return {{}, fmt::format("{} failed{}", compiler().program, complaint(workshop.content(name + ".log")))};
    }
    return {{{name + ".pdf", read_file(workshop.path() / (name + ".pdf"))}}, {}};
  } catch (const InputOutputError& error) {
    return {{}, error.what()};
  }
}

}  // namespace stickslip::report::tools
