#include "report/orbits/diagram.hpp"

#include <fmt/format.h>

#include "core/decimal.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/prose.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace tools;
using model::Vector4;

namespace {

constexpr std::array colours{"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd",
                             "#8c564b", "#e377c2", "#17becf", "#bcbd22", "#7f7f7f"};
constexpr std::array kinds{Kind::periodic, Kind::quasi_periodic, Kind::irregular, Kind::slides,
                           Kind::stuck,    Kind::grows,          Kind::unsettled};

const char * colour(std::size_t k) {
  return colours[k % colours.size()];
}

std::string stable(const Attractor& a) {
  const bool decided = a.orbit && a.orbit->existence.truth == Truth::proved && a.orbit->orbit.stability;
  const motion::StabilityKind kind =
      decided ? a.orbit->orbit.stability->kind : motion::StabilityKind::undecided;
  return kind == motion::StabilityKind::stable ? "yes" : kind == motion::StabilityKind::unstable ? "no" : "";
}

std::string comma_separated(const Vector4<double>& X) {
  return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g}", X(0), X(1), X(2), X(3));
}

// The data except for the one that varies.
std::string others(const DiagramQuestion& q) {
  auto all = named_parameters(q.machine.machine);
  std::erase_if(all, [&](const auto& one) { return one.first == q.parameter; });
  return parameter_list(all);
}

std::string plane_of(const BasinsQuestion& q) {
  return fmt::format("{},{}", coordinates[static_cast<std::size_t>(q.across[0])],
                     coordinates[static_cast<std::size_t>(q.across[1])]);
}

// Along a parameter in SI units, each value has its own.
Units units_at(const DiagramPoint& point, const Units& units) {
  return point.taken ? Units(*point.taken) : units;
}
Units units_at(const Diagram& d, const Units& units) {
  return d.points.empty() ? units : units_at(d.points.front(), units);
}

// "x1,x2,x1',x2'", with their units in SI.
std::string states_named(const Units& units) {
  std::string text;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    text += (k == 0 ? "" : ",") + units.labelled(coordinates[k], k < 2 ? "m" : "m/s");
  }
  return text;
}

}  // namespace

std::string short_name(const Attractor& a) {
  return a.kind == Kind::periodic ? fmt::format("{} ({})", shortened(a.word), a.periods) : to_string(a.kind);
}

std::string parameter_of(const DiagramQuestion& q) {
  return q.parameter + (q.taken ? in_unit_of(q.parameter) : "");
}

std::vector<Row> rows_of(const Diagram& d) {
  const DiagramQuestion& q = d.question;
  return {{{"parameters"}, {q.taken ? "of the machine, except for " + q.parameter : others(q)}},
          {{"along"},
           {fmt::format("{} from {} to {}, {} values", parameter_of(q), to_string(q.from), to_string(q.to),
                        q.values)}},
          {{"starts"},
           {fmt::format("{} at random, seed {}, at each value{}", q.machine.starts, q.machine.seed,
                        d.interrupted ? "; interrupted" : "")}}};
}

std::vector<DiagramLine> lines_of(const Diagram& d) {
  std::vector<DiagramLine> lines;
  for (const DiagramPoint& point : d.points) {
    std::string all = point.outside;
    for (const Attractor& a : point.attractors) {
      all += fmt::format("{}{:.0f} % {}", all.empty() ? "" : ", ", 100 * a.share, short_name(a));
    }
    lines.push_back({fmt::format("{:.6g}", point.value.get_d()), all});
  }
  return lines;
}

std::string terminal_report(const Diagram& d, const Style& style, const Units& /*units*/) {
  std::vector<Row> rows{{{parameter_of(d.question)}, {"share, word (period)"}}};
  for (const DiagramLine& line : lines_of(d)) {
    rows.push_back({{line.value}, {line.ends}});
  }
  return columns_of({{{"What the machine does along " + d.question.parameter, bold(style)}}}, style.width) +
         columns_of(rows_of(d), style.width) + "\n" + columns_of(rows, style.width);
}

std::string plane_in_words(const Basins& b, const Units& units) {
  const BasinsQuestion& q = b.question;
  return fmt::format("{} from {} to {}{}, {} x {} starts{}", plane_of(q),
                     comma_separated(units.state(b.starts.front())),
                     comma_separated(units.state(b.starts.back())), units.unit(" in m and m/s"), q.pixels[0],
                     q.pixels[1], b.interrupted ? "; interrupted" : "");
}

std::string terminal_report(const Basins& b, const Style& style, const Units& units) {
  std::vector<Row> head{{{"parameters"}, {parameter_list(b.question.machine.machine)}},
                        {{"plane"}, {plane_in_words(b, units)}}};
  std::string text = columns_of({{{"Where starts in a plane end", bold(style)}}}, style.width) +
                     columns_of(head, style.width);
  std::vector<Row> rows{{{"   "}, {"share"}, {""}}};
  for (std::size_t k = 0; k < b.attractors.size(); ++k) {
    rows.push_back({{std::to_string(k + 1)},
                    {fmt::format("{:.1f} %", 100 * b.attractors[k].share)},
                    {in_words(b.attractors[k])}});
  }
  return text + "\n" + columns_of(rows, style.width);
}

std::string to_csv(const Diagram& d, const Units& units) {
  std::string text = parameter_of(d.question) + ",attractor,share,kind,period,word,stable," +
                     states_named(units_at(d, units)) + "\n";
  for (const DiagramPoint& point : d.points) {
    // To the nearest double, not towards zero.
    const std::string value = fmt::format("{:.17g}", scalars::scalar<double>(point.value));
    if (!point.outside.empty()) {
      text += value + ",,,outside the domain,,,,,,,\n";
    }
    for (std::size_t k = 0; k < point.attractors.size(); ++k) {
      const Attractor& a = point.attractors[k];
      const bool periodic = a.kind == Kind::periodic;
      const std::string begin =
          fmt::format("{},{},{:.17g},{},{},{},{},", value, k + 1, a.share, to_string(a.kind),
                      periodic ? std::to_string(a.periods) : "", a.word, stable(a));
      for (const Vector4<double>& X : point.once[k]) {
        text += begin + comma_separated(units_at(point, units).state(X)) + "\n";
      }
    }
  }
  return text;
}

std::string to_csv(const Basins& b, const Units& units) {
  std::string text = states_named(units) + ",attractor,kind,period,word\n";
  for (std::size_t i = 0; i < b.starts.size() && !b.attractors.empty(); ++i) {
    const Attractor& a = b.attractors[b.at[i]];
    text += fmt::format("{},{},{},{},{}\n", comma_separated(units.state(b.starts[i])), b.at[i] + 1,
                        to_string(a.kind), a.kind == Kind::periodic ? std::to_string(a.periods) : "", a.word);
  }
  return text;
}

std::vector<std::vector<std::size_t>> rows_of_pixels(const std::vector<std::size_t>& ends, long columns,
                                                     std::size_t first) {
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (k % static_cast<std::size_t>(columns) == 0) {
      rows.emplace_back();
    }
    rows.back().push_back(ends[k] + first);
  }
  return rows;
}

Json pixels_schema() {
  return with({{"items", {{"type", "array"}, {"items", {{"type", "integer"}, {"minimum", 1}}}}}},
              "Of each row from below: on which attractor, 1, 2, ..., each start ends.");
}

namespace {

void write_diagram(Object& json, const Diagram& d) {
  const DiagramQuestion& q = d.question;
  const int digits = q.machine.machine.digits;
  write_origin(json, command_of(q));
  json.has("along", q.parameter, one_of({"chi", "eta", "us", "V", "omega", "p", "ur"}));
  write_parameters(json, q.machine.machine);
  json.has("starts", q.machine.starts, {{"minimum", 1}});
  json.has("seed", q.machine.seed);
  json.has("most_periods", q.machine.most_periods, {{"minimum", 1}});
  json.has("interrupted", d.interrupted, "Fewer points than were asked for.");
  json.list("points", d.points, [digits](Object& here, const DiagramPoint& point) {
    here.has("value", point.value);
    std::vector<std::pair<Attractor, std::vector<Vector4<double>>>> found;
    for (std::size_t k = 0; k < point.attractors.size(); ++k) {
      found.emplace_back(point.attractors[k], point.once[k]);
    }
    here.list("attractors", found, [digits](Object& one, const auto& attractor) {
      write_attractor(one, attractor.first, digits);
      one.has("once", attractor.second, "States when the load's phase is 0, one period apart.");
    });
    here.has("outside", point.outside.empty() ? std::nullopt : std::optional(point.outside),
             "Of the domain, in one sentence; nothing else is known then.");
  });
}

void write_basins(Object& json, const Basins& b) {
  const BasinsQuestion& q = b.question;
  const auto [i, j] = q.across;
  write_origin(json, command_of(q));
  json.has(
      "plane",
      std::array{coordinates.at(static_cast<std::size_t>(i)), coordinates.at(static_cast<std::size_t>(j))},
      {{"items", one_of({coordinates.begin(), coordinates.end()})}, {"uniqueItems", true}});
  json.has("pixels", q.pixels, with({{"items", {{"type", "integer"}, {"minimum", 2}}}}, "Columns and rows."));
  json.has("from", b.starts.front(), "The first start.");
  json.has("to", b.starts.back(), "The last one.");
  write_parameters(json, q.machine.machine);
  json.has("most_periods", q.machine.most_periods, {{"minimum", 1}});
  json.has("interrupted", b.interrupted, "Fewer starts than were asked for.");
  json.list("attractors", b.attractors,
            [&](Object& to, const Attractor& a) { write_attractor(to, a, q.machine.machine.digits); });
  json.has("at", rows_of_pixels(b.at, q.pixels[0]), pixels_schema());
}

}  // namespace

Json to_json(const Diagram& d) {
  return written(d, write_diagram);
}

Json to_json(const Basins& b) {
  return written(b, write_basins);
}

File attractors_schema() {
  Diagram along;
  Basins plane;
  along.question.machine.machine = plane.question.machine.machine = SampleOf<words::WordQuestion>::made();
  plane.starts = {Vector4<double>::Zero()};
  return schema_file("attractors", "stickslip attractors: what a machine does; with --along, with --plane",
                     one_of_schemas({schema_of_attractors(), schema_by(along, write_diagram),
                                     schema_by(plane, write_basins)}));
}

std::string plot_script(const DrawnDiagram& d, PlotFormat format) {
  Json data = {{"terminal", terminal(format, 1000, 600)}};
  data["kinds"] = Json::array();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::string table;
    for (const DrawnDiagram::State& state : d.states) {
      table += state.kind == kinds[k] ? fmt::format("{:.8g} {:.8g}\n", state.value, state.place) : "";
    }
    if (!table.empty()) {
      const bool dense = kinds[k] == Kind::irregular || kinds[k] == Kind::quasi_periodic;
      data["kinds"].push_back({{"block", fmt::format("$kind{}", k)},
                               {"kind", to_string(kinds[k])},
                               {"colour", colour(k)},
                               {"size", dense ? "0.15" : "0.3"},
                               {"table", table},
                               {"first", data["kinds"].empty()}});
    }
  }
  if (data["kinds"].empty()) {
    return "";
  }
  data["parameter"] = d.parameter;
  data["title"] = d.title;
  data["place"] = d.place;
  data["from"] = fmt::format("{:.8g}", d.from);
  data["to"] = fmt::format("{:.8g}", d.to);
  return render_file("diagram.gp", data, plain_format);
}

std::string plot_script(const Diagram& d, PlotFormat format, const Units& units) {
  DrawnDiagram drawn;
  for (const DiagramPoint& point : d.points) {
    const Units here = units_at(point, units);
    for (std::size_t i = 0; i < point.attractors.size(); ++i) {
      for (const Vector4<double>& X : point.once[i]) {
        drawn.states.push_back({point.attractors[i].kind, point.value.get_d(), here.state(X)(1)});
      }
    }
  }
  drawn.parameter = parameter_of(d.question);
  drawn.title = "x2 once a period of the load, at " +
                (d.question.taken ? units_at(d, units).machine_or("the machine", d.question.parameter)
                                  : in_greek(others(d.question)));
  drawn.place = units_at(d, units).labelled("x2", "m");
  drawn.from = d.question.from.get_d();
  drawn.to = d.question.to.get_d();
  return plot_script(drawn, format);
}

std::string plot_script(const DrawnBasins& b, PlotFormat format) {
  if (b.attractors.empty()) {
    return "";
  }
  Json data = {{"terminal", terminal(format, 900, 760)}};
  std::string table;
  for (std::size_t k = 0; k < b.starts.size(); ++k) {
    table += fmt::format("{:.8g} {:.8g} {}\n", b.starts[k][0], b.starts[k][1], b.ends[k]);
  }
  data["table"] = table;
  std::string open;
  for (std::size_t k = 0; k < b.proved.size(); ++k) {
    open += b.proved[k] != 0 ? "" : fmt::format("{:.8g} {:.8g}\n", b.starts[k][0], b.starts[k][1]);
  }
  if (!open.empty()) {
    data["open"] = {{"table", open}, {"words", "dots: followed in floating point; all else is proved"}};
  }
  data["attractors"] = Json::array();
  std::string palette;
  for (std::size_t k = 0; k < b.attractors.size(); ++k) {
    data["attractors"].push_back({{"colour", colour(k)}, {"words", b.attractors[k]}});
    palette += fmt::format("{}{} \"{}\"", k == 0 ? "" : ", ", k, colour(k));
  }
  // A palette has two colours at least.
  data["palette"] = b.attractors.size() == 1 ? palette + fmt::format(", 1 \"{}\"", colour(0)) : palette;
  data["count"] = std::max<std::size_t>(b.attractors.size(), 2);
  data["last"] = fmt::format("{}.5", std::max<std::size_t>(b.attractors.size(), 2) - 1);
  data["parameters"] = b.machine;
  data["x"] = b.x;
  data["y"] = b.y;
  // To the outer edges of the pixels.
  const auto margin = [&](std::size_t k) {
    return (b.starts.back()[k] - b.starts.front()[k]) / static_cast<double>(std::max(b.pixels[k] - 1, 1L)) /
           2;
  };
  data["left"] = fmt::format("{:.8g}", b.starts.front()[0] - margin(0));
  data["right"] = fmt::format("{:.8g}", b.starts.back()[0] + margin(0));
  data["bottom"] = fmt::format("{:.8g}", b.starts.front()[1] - margin(1));
  data["top"] = fmt::format("{:.8g}", b.starts.back()[1] + margin(1));
  return render_file("basins.gp", data, plain_format);
}

std::string plot_script(const Basins& b, PlotFormat format, const Units& units) {
  const BasinsQuestion& q = b.question;
  const auto [i, j] = q.across;
  DrawnBasins drawn;
  for (const Vector4<double>& start : b.starts) {
    const Vector4<double> X = units.state(start);
    drawn.starts.push_back({X(i), X(j)});
  }
  drawn.ends = b.at;
  for (const Attractor& a : b.attractors) {
    drawn.attractors.push_back(fmt::format("{:.1f} % {}", 100 * a.share, short_name(a)));
  }
  drawn.machine = units.machine_or(in_greek(parameter_list(q.machine.machine)));
  drawn.x = units.labelled(coordinates[static_cast<std::size_t>(i)], i < 2 ? "m" : "m/s");
  drawn.y = units.labelled(coordinates[static_cast<std::size_t>(j)], j < 2 ? "m" : "m/s");
  drawn.pixels = q.pixels;
  return plot_script(drawn, format);
}

std::string options_along(const DiagramQuestion& q) {
  return fmt::format(" --along {} {}..{} --values {} --starts {} --seed {} --most-periods {}", q.parameter,
                     to_string(q.from), to_string(q.to), q.values, q.machine.starts, q.machine.seed,
                     q.machine.most_periods);
}

std::string command_of(const DiagramQuestion& q) {
  return "stickslip attractors" + options_of(q.machine.machine) + options_along(q);
}

std::string command_of(const BasinsQuestion& q) {
  const std::string through = q.through ? " --through=" + comma_separated(*q.through) : "";
  return fmt::format("stickslip attractors{} --plane \"{}\" --pixels {}{} --most-periods {}",
                     options_of(q.machine.machine), plane_of(q), q.pixels[0], through,
                     q.machine.most_periods);
}

}  // namespace stickslip::report::orbits
