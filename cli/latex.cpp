// stickslip latex: derived expressions for papers.
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "proofs/paper.hpp"
#include "report/pages.hpp"
#include "symbolic/objects.hpp"

namespace stickslip::cli {
namespace {

struct Options {
  std::vector<std::string> names;
  symbolic::Unknowns unknowns = symbolic::Unknowns::chi;
  bool list = false;
  bool errata = false;
};

symbolic::Unknowns unknowns_named(const std::string& word) {
  if (word != "chi" && word != "omega") {
    throw CLI::ValidationError("--in", "'" + word + "' is neither chi nor omega");
  }
  return word == "chi" ? symbolic::Unknowns::chi : symbolic::Unknowns::omega;
}

// The named objects, or all of them. Names are looked up first, so that an unknown one prints nothing.
std::string formulas(const Options& options) {
  std::vector<const symbolic::Object*> chosen;
  for (const std::string& name : options.names) {
    chosen.push_back(&symbolic::object_named(name));
  }
  if (chosen.empty()) {
    for (const symbolic::Object& object : symbolic::objects()) {
      chosen.push_back(&object);
    }
  }
  std::string result;
  for (const symbolic::Object* object : chosen) {
    result += (result.empty() ? "" : "\n") + symbolic::displayed(*object, options.unknowns);
  }
  return result;
}

}  // namespace

void add_latex(CLI::App& program, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("latex", "Print derived expressions as LaTeX");
  command->footer(
      "Displayed equations for a document with the amsmath package: stickslip latex H > H.tex\n"
      "Every formula is printed from the one that the proofs are about; two runs print the\n"
      "same characters.");
  CLI::Option* names = command
                           ->add_option("NAME", options->names,
                                        "What to print (H, Gamma, Q, ...); everything if none is given")
                           ->type_name("");
  CLI::Option* list = command->add_flag("--list", options->list, "List the names, with equation numbers");
  command
      ->add_flag(
          "--errata", options->errata,
          "A document with the errata of the paper and the hypotheses\nto be added, after proving everything")
      ->excludes(list)
      ->excludes(names);
  command
      ->add_option_function<std::string>(
          "--in", [options](const std::string& word) { options->unknowns = unknowns_named(word); },
          "chi (the default): with chi, eta and the abbreviations omega_j,\nlambda_j; omega: with the "
          "natural "
          "frequencies alone")
      ->type_name("WORD");
  command->callback([options, &action] {
    action = [options] {
      print(options->errata ? report::errata(prove(proofs::paper(), {}))
            : options->list ? symbolic::list_of_objects()
                            : formulas(*options));
      return exit_decided;
    };
  });
}

}  // namespace stickslip::cli
