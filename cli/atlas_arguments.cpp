// stickslip atlas: what may be typed.
#include <fmt/format.h>

#include <limits>

#include "cli/command_line.hpp"

namespace stickslip::cli {
namespace {

constexpr const char * details =
    "Cuts a range of one to four parameters into boxes and proves, for every point of each:\n"
    "how many orbits of the family there are, how many of them are admissible, how many\n"
    "stable. Parameters that vary are given as A..B. Boxes that cannot be decided are halved,\n"
    "each side at most --resolution times, and say why they are left open. Decided and open\n"
    "volume add up exactly.\n\n"
    "In the file of a machine in SI units each value may be a range, such as \"7..8\",\n"
    "\"7.5+-0.01\" or \"4+-5%\"; --along replaces it. Boxes are then of these values, and what\n"
    "is proved holds for every machine in them; tables and maps are in SI units.\n\n"
    "What is found is written into OUT.log while the work goes on; whatever happens to the\n"
    "program, --resume goes on from there. The atlas, an HDF5 file, is written when all is\n"
    "done, and the log removed. It is the same whoever made it, in however many parts. Where\n"
    "the program was built with MPI, mpirun -n N stickslip atlas ... shares the work. SIGTERM,\n"
    "SIGUSR1, Ctrl-C and --time-limit end it in order.\n\n"
    "--verify FILE proves boxes of an atlas again, in Arb's balls.\n\n"
    "Exit code: 0 all that is left open is at the resolution asked for, or confirmed;\n"
    "1 --verify found a box that says what is false; 2 there is more to do, or something lies\n"
    "outside the domain, or is not confirmed; 130 after a signal.";

}  // namespace

void add_atlas(CLI::App& program, Request& request, const PaperInHelp& paper) {
  Command<AtlasOptions> c(program, request, "atlas",
                          "Count orbits over ranges of parameters, proved everywhere");
  AtlasOptions& o = c.options;
  c.app.footer(details);
  c.add("FAMILY", o.family, "", "symmetric, overshooting or nonsticking");
  add_parameters(c.app, o.parameters);
  add_sources(c.app, o, paper);
  c.app
      .add_option("--along", o.along,
                  "A parameter that varies and its interval, once for each of them, such as\nomega 0.5..0.6, "
                  "or load_frequency 7..8 of a machine in SI units")
      ->allow_extra_args(false)
      ->type_name("NAME A..B");
  c.add_units("si: tables and maps are in SI units; those of a machine in SI units always\nare");
  c.add("--resolution", o.resolution, AtlasOptions::most_resolution,
        fmt::format("Boxes are at least 2^-K of each range: {} by default", AtlasOptions::default_resolution),
        "K");
  c.add("--out", o.out, "FILE", "Write the atlas there, and while it grows FILE.log");
  c.app.add_flag("--resume", o.resume, "Go on with what FILE.log holds");
  c.add("--time-limit", o.time_limit, "T", "End in order after T seconds", positive);
  c.add("--csv", o.csv, "FILE", "Write the boxes as a table, too");
  c.add("--plot", o.plot, "FILE",
        "Draw a map of two parameters into FILE.svg, FILE.pdf or FILE.png;\nFILE.vtk: of up to three, for "
        "ParaView");
  c.add_jobs();
  c.add("--verify", o.verify, "FILE", "Prove boxes of this atlas again");
  c.add("--sample", o.sample, std::numeric_limits<int>::max(),
        fmt::format("With --verify: so many of them, {} by default", AtlasOptions::default_sample));
  c.app.add_flag("--json", o.json, "Print the summary, or what --verify finds, as JSON");
}

}  // namespace stickslip::cli
