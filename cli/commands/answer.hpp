// What the commands about a machine share: where their results go.
#pragma once

#include <fmt/format.h>

#include <string>

#include "cli/answers/machine_file.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/commands/output.hpp"
#include "core/interruption.hpp"
#include "report/orbits/attractors/attractors.hpp"
#include "report/orbits/branches/branches.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/pure_word.hpp"
#include "report/orbits/simulation.hpp"
#include "report/tools/files.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::cli {

// How a command about a machine ends.
[[nodiscard]] inline ExitCode exit_of(bool interrupted, bool decided) {
  return interrupted ? exit_interrupted : decided ? exit_decided : exit_undecided;
}

// What the work gives, which Ctrl-C ends early; with a line on the terminal meanwhile.
template <class Work>
[[nodiscard]] auto worked_out(const char * doing, const Work& work) {
  const Interruptible scope;
  const Progress progress(doing);
  return work();
}

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

// On standard output, as JSON or as text; `how`: the units of the text, and the like. A machine in tables
// has no file but its own.
template <class Result, class... How>
void print_result(const Result& result, const ParameterFile& file, bool json, const How&... how) {
  using report::orbits::terminal_report;
  using report::orbits::to_json;
  tell_left_out(file);
  print(json ? report::tools::to_text(with_machine(to_json(result), file))
             : machine_report(file) + terminal_report(result, terminal_style(), how...));
}

// The page that `pages` makes, if it is asked for, and what `print` prints.
template <class Pages, class Print>
void write_page(const Outputs& o, const Pages& pages, const Print& print) {
  if (o.out) {
    const Progress progress("making the page ...");
    report::tools::write_files(*o.out, pages());
  }
  print();
  if (o.out) {
    tell(fmt::format("The report is in {}: index.html.", *o.out));
  }
}

// A table and a picture of the result, as far as they are asked for.
template <class Result, class... Units>
void write_table_and_picture(const Outputs& o, const Result& result, const Units&... units) {
  using report::orbits::plot_script;
  using report::orbits::to_csv;
  if (o.csv) {
    report::tools::write_file(*o.csv, to_csv(result, units...));
  }
  if (o.plot) {
    draw(*o.plot, plot_script(result, report::tools::plot_format(*o.plot), units...));
  }
}

// All that is asked for.
template <class Result, class... Units>
void write_outputs(const Outputs& o, const Result& result, const ParameterFile& file, const Units&... units) {
  write_table_and_picture(o, result, units...);
  write_page(
      o,
      [&] {
        return report::orbits::pages(result, {file.name, file.machine, units...});
      },
      [&] { print_result(result, file, o.json, units...); });
}

}  // namespace stickslip::cli
