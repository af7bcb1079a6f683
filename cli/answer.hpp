// What the commands about a machine share: where their results go.
#pragma once

#include <fmt/format.h>

#include <string>

#include "cli/arguments.hpp"
#include "cli/machine_file.hpp"
#include "cli/output.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/branches.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/pure_word.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/files.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::cli {

// Before long work: throws InputOutputError unless the table, the picture and the page that are asked for can
// be made and written.
inline void require_outputs(const Outputs& o) {
  if (o.csv) {
    report::tools::require_writable_file(*o.csv);
  }
  if (o.plot) {
    report::tools::require_plot(*o.plot);
  }
  if (o.out) {
    require_page(*o.out);
  }
}

// The picture, or that there is none of it to draw: "nothing", "no orbit".
inline void draw(const std::string& file, const std::string& script, const char * none = "nothing") {
  if (script.empty()) {
    tell(fmt::format("There is {} to draw: {} is not written.", none, file));
  } else {
    report::tools::write_plot(file, script);
  }
}

// On standard output, as JSON or as text; `how`: the units of the text, and the like.
template <class Result, class... How>
void print_result(const Result& result, const ParameterFile& file, bool json, const How&... how) {
  tell_left_out(file);
  print(json ? report::tools::to_text(with_machine(report::orbits::to_json(result), file))
             : machine_report(file) + report::orbits::terminal_report(result, terminal_style(), how...));
}

// All that is asked for.
template <class Result, class... Units>
void write_outputs(const Outputs& o, const Result& result, const ParameterFile& file, const Units&... units) {
  if (o.csv) {
    report::tools::write_file(*o.csv, report::orbits::to_csv(result, units...));
  }
  if (o.plot) {
    draw(*o.plot, report::orbits::plot_script(result, report::tools::plot_format(*o.plot), units...));
  }
  if (o.out) {
    const Progress progress("making the page ...");
    report::tools::write_files(*o.out, report::orbits::pages(result, {file.name, file.machine, units...}));
  }
  print_result(result, file, o.json, units...);
  if (o.out) {
    tell(fmt::format("The report is in {}: index.html.", *o.out));
  }
}

}  // namespace stickslip::cli
