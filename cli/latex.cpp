// stickslip latex: derived expressions, statements, theorems and orbits for papers.
#include <optional>

#include "cli/commands.hpp"
#include "cli/latex_text.hpp"
#include "cli/output.hpp"

namespace stickslip::cli {

ExitCode run(const LatexOptions& options, const proofs::methods::Paper& paper) {
  const LatexText made = [&] {
    std::optional<Progress> progress;
    if (!options.orbit.empty()) {
      progress.emplace("searching for orbits ...");
    }
    return latex_text(options, paper, prove);
  }();
  for (const std::string& sentence : made.left_out) {
    tell(sentence);
  }
  print(made.text);
  return exit_decided;
}

}  // namespace stickslip::cli
