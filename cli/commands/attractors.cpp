// stickslip attractors: what a machine does.

#include <algorithm>
#include <optional>

#include "cli/answers/asked.hpp"
#include "cli/answers/machine_answers.hpp"
#include "cli/answers/orbit_data.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "cli/commands/answer.hpp"
#include "cli/commands/commands.hpp"

namespace stickslip::cli {

using namespace numeric;
using namespace numeric::attractors;
using words::WordOrbit;

bool is_decided(const WordOrbit& o) {
  return o.existence.truth == Truth::proved &&
         (o.orbit.admissible.truth == Truth::refuted ||
          (o.orbit.admissible.truth == Truth::proved &&
           o.orbit.stability->kind != motion::StabilityKind::undecided));
}

namespace {

// stickslip attractors --along and --plane.

template <class Question, class Answer>
ExitCode answer(const AttractorsOptions& o, const Asked<Question>& asked, const Answer& answer_to) {
  const Jobs limit = jobs(o.jobs);
  require_outputs(o);
  const auto result = worked_out("following the starts ...", [&] { return answer_to(asked.question); });
  write_outputs(o, result, asked.file, asked.units);
  return exit_of(result.interrupted, true);
}

ExitCode run_diagram(const AttractorsOptions& o, const proofs::methods::Examples& examples) {
  if (o.plane && (o.neighbourhood || o.window)) {
    const auto asked = asked_basins(as_text(o), examples);
    return run_plane(as_tables(asked.question.machine.machine, asked.file, asked.units,
                               "--plane with --neighbourhood or --window"),
                     without_machine(o));
  }
  return o.plane ? answer(o, asked_basins(o, examples), basins_of)
                 : answer(o, asked_diagram(o, examples), diagram_of);
}

}  // namespace

ExitCode run(const AttractorsOptions& options, const proofs::methods::Examples& examples) {
  if (const auto done = run_in_tables(options)) {
    return *done;
  }
  if (!options.along.empty() || options.plane) {
    return run_diagram(options, examples);
  }
  const auto asked = asked_attractors(options, examples);
  const AttractorQuestion& question = asked.question;
  const Jobs limit = jobs(options.jobs);
  require_outputs(options);
  const AttractorList list =
      worked_out("following the starts ...", [&] { return find_attractors(question); });
  std::optional<Basins> basins;
  if (options.out && !list.interrupted) {
    constexpr long pixels = AttractorsOptions::pixels_beside_starts;
    basins = worked_out("following starts in a plane ...", [&] {
      return basins_of({question, {0, 1}, {}, {pixels, pixels}});
    });
  }
  write_page(
      options,
      [&] {
        return report::orbits::pages(list, basins, {asked.file.name, asked.file.machine, asked.units});
      },
      [&] { print_result(list, asked.file, options.json, asked.units); });
  return exit_of(list.interrupted, std::ranges::all_of(list.attractors, [](const Attractor& a) {
                   return a.kind != Kind::periodic || (a.orbit && is_decided(*a.orbit));
                 }));
}

}  // namespace stickslip::cli
