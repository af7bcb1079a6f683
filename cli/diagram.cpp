// stickslip attractors --along and --plane.
#include <string>

#include "cli/answer.hpp"
#include "cli/asked.hpp"
#include "cli/commands.hpp"
#include "cli/numbers.hpp"
#include "core/interruption.hpp"

namespace stickslip::cli {

using namespace numeric::attractors;

namespace {

template <class Question, class Answer>
ExitCode answer(const AttractorsOptions& o, const Asked<Question>& asked, const Answer& answer_to) {
  const Jobs limit = jobs(o.jobs);
  require_outputs(o);
  const auto result = [&] {
    const Interruptible scope;
    const Progress progress("following the starts ...");
    return answer_to(asked.question);
  }();
  write_outputs(o, result, asked.file, asked.units);
  return result.interrupted ? exit_interrupted : exit_decided;
}

}  // namespace

ExitCode run_diagram(const AttractorsOptions& o, const proofs::methods::Paper& paper) {
  return o.plane ? answer(o, asked_basins(o, paper), basins_of)
                 : answer(o, asked_diagram(o, paper), diagram_of);
}

}  // namespace stickslip::cli
