// stickslip atlas: what is proved over ranges of parameters; numeric/atlas/ does the work.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <random>

#include "cli/answers/asked.hpp"
#include "cli/answers/orbit_data.hpp"
#include "cli/arguments/typed_parameters.hpp"
#include "cli/commands/cluster.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/output.hpp"
#include "core/decimal.hpp"
#include "core/interruption.hpp"
#include "core/parallel.hpp"
#include "numeric/atlas/judge.hpp"
#include "numeric/atlas/log.hpp"
#include "numeric/atlas/work.hpp"
#include "report/atlas/archive.hpp"
#include "report/atlas/summary.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/plot.hpp"

namespace stickslip::cli {

using namespace numeric::atlas;
namespace fs = std::filesystem;

namespace {

Question asked_of(const AtlasOptions& o, const proofs::methods::Examples& examples) {
  Asked<Question> asked = asked_atlas(o, examples);
  tell_left_out(asked.file);
  return std::move(asked.question);
}

// Whether --plot asks for a mesh that ParaView opens.
bool is_mesh(const std::optional<std::string>& plot) {
  return plot && fs::path(*plot).extension() == ".vtk";
}

// What was asked for beside the atlas.
void write_pictures(const AtlasOptions& o, const Question& q, const std::vector<Leaf>& leaves) {
  if (o.csv) {
    report::tools::write_file(*o.csv, report::atlas::to_csv(q, leaves));
  }
  if (is_mesh(o.plot)) {
    report::tools::write_file(*o.plot, report::atlas::to_vtk(q, leaves));
  } else if (o.plot) {
    report::tools::write_plot(*o.plot,
                              report::atlas::plot_script(q, leaves, report::tools::plot_format(*o.plot)));
  }
}

void print_summary(const AtlasOptions& o, const Question& q, const std::vector<Leaf>& leaves) {
  print(o.json ? report::tools::to_text(report::atlas::to_json(q, leaves))
               : report::atlas::terminal_report(q, leaves, terminal_style()));
}

// Before long work.
void require_outputs(const AtlasOptions& o, const Question& q) {
  if (o.csv) {
    report::tools::require_writable_file(*o.csv);
  }
  if (is_mesh(o.plot)) {
    if (q.axes.size() > 3) {
      throw UsageError("plot: a mesh has at most three parameters that vary");
    }
    report::tools::require_writable_file(*o.plot);
  } else if (o.plot) {
    if (q.axes.size() != 2) {
      throw UsageError("plot: a map needs two parameters that vary");
    }
    report::tools::require_plot(*o.plot);
  }
}

ExitCode code_of(const Question& q, const std::vector<Leaf>& leaves) {
  return tally(q, leaves).coarser == 0 && gaps(leaves).empty() ? exit_decided : exit_undecided;
}

// ---- --verify

// What the Arb balls say of a leaf of the file, the weightiest last.
enum class Second { confirmed, silent, contradicted };

Second compare(const Leaf& leaf, const Finding& again) {
  const auto count = [](std::int8_t said, std::int8_t proved) {
    return said < 0 || said == proved ? Second::confirmed
           : proved < 0               ? Second::silent
                                      : Second::contradicted;
  };
  const bool outside = static_cast<std::uint8_t>(Reason::outside) == leaf.finding.reason;
  if (outside != (static_cast<std::uint8_t>(Reason::outside) == again.reason)) {
    return Second::contradicted;
  }
  if (leaf.finding.is_decided() && leaf.finding.stable < 0) {
    return Second::contradicted;  // decided means that all is known
  }
  return std::max({count(leaf.finding.orbits, again.orbits), count(leaf.finding.admissible, again.admissible),
                   count(leaf.finding.stable, again.stable)});
}

// Why a box is left open depends on how it was looked at, and is found again by doing the same.
Second compare_reason(const Question& q, const Leaf& leaf, bool same_program) {
  const bool same =
      leaf.finding.is_decided() || judge_from_whole(q, leaf.tile, Balls::both).reason == leaf.finding.reason;
  return same ? Second::confirmed : same_program ? Second::contradicted : Second::silent;
}

// From the leaf alone; where that tells too little from the whole down.
Second look_again(const report::atlas::Archive& archive, const Leaf& leaf) {
  const Question& q = archive.question;
  const bool same_program = archive.version == report::tools::program_version();
  const Second reason = compare_reason(q, leaf, same_program);
  if (archive.elsewhere.contains(leaf.tile) || reason == Second::contradicted) {
    return Second::contradicted;
  }
  Knowledge nothing;
  Second counts = compare(leaf, judge(q, leaf.tile, Balls::arb, nothing));
  if (counts == Second::silent) {
    counts = compare(leaf, judge_from_whole(q, leaf.tile, Balls::arb));
  }
  return counts == Second::confirmed ? reason : counts;
}

ExitCode verify(const AtlasOptions& o) {
  const report::atlas::Archive archive = report::atlas::read_archive(o.verify);
  const Question& q = archive.question;
  const int wanted = o.sample.value_or(AtlasOptions::default_sample);
  std::vector<Leaf> sample;
  std::mt19937_64 random(1);
  std::sample(archive.leaves.begin(), archive.leaves.end(), std::back_inserter(sample), wanted, random);
  for (const Leaf& leaf : archive.leaves) {
    if (archive.elsewhere.contains(leaf.tile) &&
        std::find(sample.begin(), sample.end(), leaf) == sample.end()) {
      sample.push_back(leaf);
    }
  }
  const Jobs limit = jobs(o.jobs);
  const Interruptible scope;
  Progress progress("proving boxes again ...");
  const std::vector<Second> results = parallel_map(sample.size(), [&](std::size_t i) {
    return interrupted() ? Second::silent : look_again(archive, sample[i]);
  });
  report::atlas::Verification found;
  found.boxes = archive.leaves.size();
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (results[i] == Second::contradicted) {
      found.contradicted.push_back(sample[i]);
    } else {
      ++(results[i] == Second::confirmed ? found.confirmed : found.not_decided_again);
    }
  }
  const std::string command = fmt::format("stickslip atlas --verify {} --sample {}", o.verify, wanted);
  print(o.json ? report::tools::to_text(report::atlas::to_json(q, found, command))
               : report::atlas::terminal_report(q, found));
  if (interrupted()) {
    return exit_interrupted;
  }
  return !found.contradicted.empty()   ? exit_refuted
         : found.not_decided_again > 0 ? exit_undecided
                                       : exit_decided;
}

// ---- the work

std::string expected(double done, std::chrono::steady_clock::time_point since, double before) {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - since;
  const double here = done - before;
  const double rest = here > 0 ? passed.count() * (1 - done) / here : 0;
  return fmt::format("{:.2f} % of the volume examined{}", 100 * done,
                     here > 0 ? fmt::format(", about {:.0f} s to go", rest) : std::string());
}

struct Begun {
  std::vector<Leaf> leaves;
  std::vector<Tile> tiles;
  std::unique_ptr<LogLock> lock;
};

// What the log holds, and what is left to do; by the first process alone.
Begun begin(const AtlasOptions& o, const Question& q, const fs::path& log, const std::string& identity) {
  Begun begun;
  if (o.resume && !fs::exists(log) && fs::exists(*o.out) && report::atlas::has_hdf5()) {
    report::atlas::Archive archive = report::atlas::read_archive(*o.out);
    if (numeric::atlas::identity(archive.question, archive.version) != identity) {
      throw UsageError(fmt::format("{} answers another question, or one of another version", *o.out));
    }
    begun.leaves = std::move(archive.leaves);
    return begun;
  }
  if (o.resume) {
    begun.lock = std::make_unique<LogLock>(log);
    begun.leaves = read_log(log, identity);
    put_in_order(q, begun.leaves);
  } else {
    report::tools::require_writable_file(*o.out);
    create_log(log, identity);
    begun.lock = std::make_unique<LogLock>(log);
  }
  begun.tiles = gaps(begun.leaves);
  return begun;
}

// Works until all is done, or it is time to end.
void work(const AtlasOptions& o, Cluster& cluster, const Question& q, const fs::path& log,
          const std::string& identity, const Begun& begun) {
  const auto since = std::chrono::steady_clock::now();
  const auto stop = [&] {
    return interrupted() || (o.time_limit && std::chrono::steady_clock::now() - since >
                                                 std::chrono::duration<double>(*o.time_limit));
  };
  Progress progress("counting orbits ...");
  double done = share(tally(q, begun.leaves).covered()).get_d();
  const double before = done;
  Log file(log, cluster.rank(), identity);
  cluster.work_on_all(q, begun.tiles, stop, [&](const std::vector<Leaf>& leaves) {
    file.append(leaves);
    for (const Leaf& leaf : leaves) {
      done += share(volume(leaf.tile)).get_d() * cluster.size();
    }
    progress.show(expected(std::min(done, 1.0), since, before));
  });
}

// The atlas in its place and the log gone; without HDF5 a table.
void keep(const AtlasOptions& o, const Question& q, const std::vector<Leaf>& leaves, const fs::path& log) {
  if (report::atlas::has_hdf5()) {
    report::atlas::write_archive(*o.out, q, leaves);
    fs::remove_all(log);
    return;
  }
  const std::string table = *o.out + ".csv";
  report::tools::write_file(table, report::atlas::to_csv(q, leaves));
  tell(fmt::format(
      "stickslip: this program was built without HDF5, which script/bootstrap cluster installs: the "
      "boxes are in {} and {}.",
      table, log.string()));
}

ExitCode make(const AtlasOptions& o, const Question& q, Cluster& cluster) {
  if (!o.out || o.out->empty()) {
    throw UsageError("--out FILE is missing: where the atlas is to be written");
  }
  const bool first = cluster.rank() == 0;
  const fs::path log = *o.out + ".log";
  const std::string identity = numeric::atlas::identity(q, report::tools::program_version());
  Begun begun;
  if (first) {
    require_outputs(o, q);
    begun = begin(o, q, log, identity);
  }
  // From here on the log is there, and in order, if there is anything to do.
  const bool to_do = !cluster.from_first(begun.tiles.empty() ? "" : "some").empty();
  bool complete = false;
  bool ended = false;
  {
    const Interruptible scope({SIGTERM, SIGUSR1});
    if (to_do) {
      work(o, cluster, q, log, identity, begun);
    }
    if (!first) {
      return exit_decided;
    }
    std::vector<Leaf> leaves = fs::exists(log) ? read_log(log, identity) : begun.leaves;
    put_in_order(q, leaves);
    complete = gaps(leaves).empty();
    if (complete && fs::exists(log)) {
      keep(o, q, leaves, log);
    }
    begun.leaves = std::move(leaves);
    ended = !complete && interrupted();
  }
  if (complete) {
    write_pictures(o, q, begun.leaves);
  }
  print_summary(o, q, begun.leaves);
  return ended ? exit_interrupted : code_of(q, begun.leaves);
}

}  // namespace

ExitCode run(const AtlasOptions& o, const proofs::methods::Examples& examples) {
  if (!o.verify.empty()) {
    return verify(o);
  }
  if (o.sample) {
    throw UsageError("--sample is for --verify");
  }
  const Question here = asked_of(o, examples);
  Cluster cluster;
  const Jobs limit = jobs(o.jobs);
  try {
    return make(o, here, cluster);
  } catch (const Error& error) {
    if (cluster.size() == 1) {
      throw;
    }
    tell(fmt::format("stickslip: {}.", error.what()));
    cluster.give_up(error.code());
  }
}

}  // namespace stickslip::cli
