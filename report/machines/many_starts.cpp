// What a machine does along one of its numbers, and where starts in a plane end: text, tables, pictures.
#include <fmt/format.h>

#include "core/decimal.hpp"
#include "report/machines/results.hpp"
#include "report/machines/rows.hpp"
#include "report/orbits/diagram.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::machines {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using attractors::Kind;

namespace {

std::string proved_in_words(const MachineBasins& b) {
  return fmt::format(
      "of {} of {} pixels, {} %: all of their starts converge to the orbit; of the others the middles are "
      "followed in floating point",
      std::ranges::count(b.proved, char{1}), b.proved.size(), report::tools::below(100 * proved_share(b), 4));
}

Seen seen_in(const Diagram& result) {
  return {result.diagram.question.machine, result.origin.in_SI};
}
Seen seen_in(const Basins& result) {
  return {result.basins.question.machine, result.origin.in_SI};
}

std::string ends_of(const std::vector<MachineAttractor>& all, bool autonomous, int decimals) {
  std::string text;
  for (const MachineAttractor& a : all) {
    text += fmt::format("{}{:.{}f} % {}", text.empty() ? "" : ", ", 100 * a.share, decimals,
                        short_name(a, autonomous));
  }
  return text;
}

std::string titled(const std::string& title, const std::vector<Row>& rows, const Style& style) {
  return columns_of({{{title, orbits::bold(style)}}}, style.width) + columns_of(rows, style.width);
}

std::string stable(const MachineAttractor& a) {
  const motion::StabilityKind kind =
      a.orbit && a.orbit->stability ? a.orbit->stability->kind : motion::StabilityKind::undecided;
  return kind == motion::StabilityKind::stable ? "yes" : kind == motion::StabilityKind::unstable ? "no" : "";
}

std::string states_named(const Seen& seen) {
  std::string text;
  for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(2 * seen.oscillator().size()); ++k) {
    text += (k == 0 ? "" : ",") + coordinate(seen, k, true);
  }
  return text;
}

// kind, periods, word.
std::string kind_of(const MachineAttractor& a) {
  return fmt::format("{},{},{}", to_string(a.kind), a.orbit ? std::to_string(a.orbit->periods) : "", a.word);
}

std::string plane_in_words(const Basins& result) {
  const MachineBasins& b = result.basins;
  const Seen seen = seen_in(result);
  return fmt::format("{},{} from {} to {}{}, {} x {} starts{}", coordinate(seen, b.across[0], false),
                     coordinate(seen, b.across[1], false), numbers(b.starts.front()),
                     numbers(b.starts.back()), seen.unit("m and m/s"), b.pixels[0], b.pixels[1],
                     b.interrupted ? "; interrupted" : "");
}

struct Line {
  std::string value, ends;
};
std::vector<Line> lines_of(const Diagram& result) {
  const bool autonomous = seen_in(result).oscillator().is_autonomous();
  std::vector<Line> lines;
  for (const auto& point : result.diagram.points) {
    lines.push_back({fmt::format("{:.6g}", point.value.get_d()),
                     point.outside.empty() ? ends_of(point.attractors, autonomous, 0) : point.outside});
  }
  return lines;
}

}  // namespace

std::vector<Row> question_rows(const Diagram& result) {
  const MachineDiagram& d = result.diagram;
  return {{{"along"},
           {fmt::format("{} from {} to {}, {} values", parameter_of(result.parameter, result.origin),
                        to_string(d.from), to_string(d.to), d.values)}},
          {{"starts"},
           {fmt::format("{} at random, seed {}, at each value{}", d.question.starts, d.question.seed,
                        d.interrupted ? "; interrupted" : "")}}};
}

std::string terminal_report(const Diagram& result, const Style& style) {
  std::vector<Row> head = machine_rows(seen_in(result));
  std::ranges::move(question_rows(result), std::back_inserter(head));
  std::vector<Row> rows{{{parameter_of(result.parameter, result.origin)}, {"share, word (periods)"}}};
  for (const Line& line : lines_of(result)) {
    rows.push_back({{line.value}, {line.ends}});
  }
  return titled("What the machine does along " + result.parameter, head, style) + "\n" +
         columns_of(rows, style.width);
}

std::string terminal_report(const Basins& result, const Style& style) {
  const bool autonomous = seen_in(result).oscillator().is_autonomous();
  std::vector<Row> head = machine_rows(seen_in(result));
  head.push_back({{"plane"}, {plane_in_words(result)}});
  std::vector<Row> rows{{{"   "}, {"share"}, {"motion"}, {"word"}, {""}}};
  for (std::size_t k = 0; k < result.basins.attractors.size(); ++k) {
    const MachineAttractor& a = result.basins.attractors[k];
    rows.push_back({{std::to_string(k + 1)},
                    {fmt::format("{:.1f} %", 100 * a.share)},
                    {to_string(a.kind)},
                    {orbits::shortened(a.word)},
                    {remark(a, autonomous)}});
  }
  const MachineBasins& b = result.basins;
  if (b.prove) {
    head.push_back({{"proved"}, {proved_in_words(b)}});
  }
  std::string text =
      titled("Where starts in a plane end", head, style) + "\n" + columns_of(rows, style.width);
  bool any = false;
  for (std::size_t k = 0; k < b.attractors.size(); ++k) {
    const auto& orbit = b.attractors[k].orbit;
    if (orbit && orbit->neighbourhood) {
      any = true;
      text += fmt::format("\n{} {}\n", k + 1, short_name(b.attractors[k], autonomous)) +
              columns_of(neighbourhood_rows(*orbit, seen_in(result)), style.width);
    }
  }
  return any ? text + "\n" + labelled(0, "recovers", orbits::meaning_of_neighbourhood(), style.width) : text;
}

std::string to_csv(const Diagram& result) {
  std::string text = parameter_of(result.parameter, result.origin) +
                     ",attractor,share,kind,periods,word,stable," + states_named(seen_in(result)) + "\n";
  for (const auto& point : result.diagram.points) {
    const std::string value = fmt::format("{:.17g}", scalars::scalar<double>(point.value));
    if (!point.outside.empty()) {
      text += value + ",,,outside the domain,,," + std::string(2 * seen_in(result).oscillator().size(), ',') +
              "\n";
    }
    for (std::size_t k = 0; k < point.attractors.size(); ++k) {
      const MachineAttractor& a = point.attractors[k];
      for (const Eigen::VectorXd& X : point.once[k]) {
        text +=
            fmt::format("{},{},{:.17g},{},{},{}\n", value, k + 1, a.share, kind_of(a), stable(a), numbers(X));
      }
    }
  }
  return text;
}

std::string to_csv(const Basins& result) {
  const MachineBasins& b = result.basins;
  std::string text = states_named(seen_in(result)) + ",attractor,kind,periods,word\n";
  for (std::size_t i = 0; i < b.starts.size() && !b.attractors.empty(); ++i) {
    text += fmt::format("{},{},{}\n", numbers(b.starts[i]), b.ends[i] + 1, kind_of(b.attractors[b.ends[i]]));
  }
  return text;
}

namespace {

// What the picture along a number shows, in words.
std::string drawn_in_words(const Diagram& result) {
  const Seen seen = seen_in(result);
  const auto j = static_cast<Eigen::Index>(seen.oscillator().rubbing);
  return coordinate(seen, j, false) +
         (seen.oscillator().is_autonomous() ? " where the phases begin" : " once a period of the load");
}

}  // namespace

std::string plot_script(const Diagram& result, PlotFormat format) {
  const MachineDiagram& d = result.diagram;
  const auto j = static_cast<Eigen::Index>(d.question.machine.oscillator.rubbing);
  orbits::DrawnDiagram drawn;
  for (const auto& point : d.points) {
    for (std::size_t k = 0; k < point.attractors.size(); ++k) {
      for (const Eigen::VectorXd& X : point.once[k]) {
        drawn.states.push_back({point.attractors[k].kind, point.value.get_d(), X(j)});
      }
    }
  }
  drawn.title = drawn_in_words(result) + ", " + result.origin.file;
  drawn.parameter = parameter_of(result.parameter, result.origin);
  drawn.place = coordinate(seen_in(result), j, true);
  drawn.from = d.from.get_d();
  drawn.to = d.to.get_d();
  return orbits::plot_script(drawn, format);
}

std::string plot_script(const Basins& result, PlotFormat format) {
  const MachineBasins& b = result.basins;
  const Seen seen = seen_in(result);
  orbits::DrawnBasins drawn;
  for (const Eigen::VectorXd& X : b.starts) {
    drawn.starts.push_back({X(b.across[0]), X(b.across[1])});
  }
  drawn.ends = b.ends;
  for (const MachineAttractor& a : b.attractors) {
    drawn.attractors.push_back(ends_of({a}, seen.oscillator().is_autonomous(), 1));
  }
  drawn.machine = result.origin.file;
  drawn.x = coordinate(seen, b.across[0], true);
  drawn.y = coordinate(seen, b.across[1], true);
  drawn.pixels = b.pixels;
  drawn.proved = b.proved;
  return orbits::plot_script(drawn, format);
}

Json along_data(const Diagram& result) {
  return {{"heading", "Along " + result.parameter},
          {"parameter", parameter_of(result.parameter, result.origin)},
          {"picture", nullptr},
          {"picture_in_words", drawn_in_words(result) + " against " +
                                   parameter_of(result.parameter, result.origin) +
                                   "; the table below says what the starts end on"},
          {"what_is_drawn", drawn_in_words(result) + ", of each motion that starts end on."},
          {"points", list_of(lines_of(result), [](const Line& line) {
             return Json{{"value", line.value}, {"ends", line.ends}};
           })}};
}

Json basins_data(const Basins& result) {
  const std::string plane = plane_in_words(result);
  const bool autonomous = seen_in(result).oscillator().is_autonomous();
  const std::string proved = result.basins.prove ? " Proved " + proved_in_words(result.basins) + "." : "";
  return {{"words", "Where starts in the plane of " + plane + " end." + proved},
          {"picture_in_words", fmt::format("Starts in the plane of {}: {}.", plane,
                                           ends_of(result.basins.attractors, autonomous, 1))}};
}

}  // namespace stickslip::report::machines
