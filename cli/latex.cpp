// stickslip latex: derived expressions for papers.
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "proofs/paper.hpp"
#include "report/pages.hpp"
#include "symbolic/objects.hpp"

namespace stickslip::cli {
namespace {

// The named objects, or all of them. Names are looked up first, so that an unknown one prints nothing.
std::string formulas(const LatexOptions& options) {
  std::vector<const symbolic::Object*> chosen;
  for (const std::string& name : options.names) {
    chosen.push_back(&symbolic::object_named(name));
  }
  if (chosen.empty()) {
    for (const symbolic::Object& object : symbolic::objects()) {
      chosen.push_back(&object);
    }
  }
  const symbolic::Unknowns unknowns =
      options.in_frequencies ? symbolic::Unknowns::omega : symbolic::Unknowns::chi;
  std::string result;
  for (const symbolic::Object* object : chosen) {
    result += (result.empty() ? "" : "\n") + symbolic::displayed(*object, unknowns);
  }
  return result;
}

}  // namespace

ExitCode run(const LatexOptions& options) {
  print(options.errata ? report::errata(prove(proofs::paper(), {}))
        : options.list ? symbolic::list_of_objects()
                       : formulas(options));
  return exit_decided;
}

}  // namespace stickslip::cli
