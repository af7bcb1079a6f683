#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>
#include <utility>

#include "core/decimal.hpp"
#include "report/machines/results.hpp"
#include "report/machines/rows.hpp"
#include "report/orbits/branches/branches.hpp"
#include "report/orbits/page.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::machines {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using attractors::Kind;
using simulation::AnyState;

namespace {

Json frame(const std::string& title, const auto& result) {
  const Seen seen = seen_of(result);
  const bool autonomous = seen.oscillator().is_autonomous();
  Json data = orbits::page_on_motions(
      {}, title, command_of(result), result.question.digits,
      autonomous ? "a time, proved" : "in periods of the load",
      std::string("positions and velocities of the mass on the belt and, if there is one, of another, in the "
                  "colours of the phases") +
          (autonomous ? "; in floating point."
                      : ", and the mass on the belt once a period of the load; in floating point."));
  data["tables"].push_back(orbits::table("machine", "Machine", machine_rows(seen)));
  return data;
}

std::string durations(const MachineOrbit& orbit, const Seen& seen) {
  return orbits::durations_in_words(orbit.phases, seen.in_SI ? " s" : "", [&](const MachinePhase& phase) {
    return fmt::format("{} {}", seen.name(phase.piece), rounded(phase.duration, 10));
  });
}

// A motion with what is known of it, and its portrait: over its period; of one that is not proved over some
// periods of the load or, without one, turns of its slowest spring.
orbits::MotionOnPage on_page(const Seen& seen, const std::string& name, const MachineOrbit * orbit,
                             const std::string& tone, const std::string& tell, std::vector<Row> rows,
                             const AnyState& X, double theta, int digits) {
  const bool autonomous = seen.oscillator().is_autonomous();
  const auto o = oscillator_as<double>(seen.machine);
  const double turn = 2 * scalars::pi<double>();
  double period = autonomous ? 10 * turn : turn / o.omega;
  long periods = orbits::Portrait::most_drawn;
  if (orbit != nullptr && orbit->existence.truth == Truth::proved) {
    std::ranges::move(orbit_rows(*orbit, seen, digits), std::back_inserter(rows));
    rows.push_back({{"durations"}, {durations(*orbit, seen)}});
    if (orbit->neighbourhood) {
      rows.push_back(
          {{"recovers"}, {orbits::neighbourhood_in_words(*orbit->neighbourhood, coordinates_of(seen))}});
    }
    for (const motion::Condition& c : orbits::worst(orbit->conditions)) {
      rows.push_back({{c.id},
                      {fmt::format("{}: {}, margin {}", c.statement, to_string(c.verdict.truth),
                                   orbits::shown(c.margin))}});
    }
    periods = autonomous ? 1 : orbit->periods;
    period = autonomous ? orbit->period.approximate() : period;
  }
  for (Row& row : rows) {
    row[0].text.erase(0, row[0].text.find_first_not_of(' '));
  }
  const std::vector<std::size_t> masses = seen.shown_masses();
  orbits::PortraitLabels labels{{masses.rbegin(), masses.rend()}, seen.in_SI};
  return {name,
          tone,
          tell,
          std::move(rows),
          orbits::portrait(o, X, theta, period, periods, periods, {masses.back(), masses.front()}),
          labels};
}

std::string tone_of(const MachineOrbit& orbit) {
  return orbit.existence.truth != Truth::proved ? "undecided" : to_string(orbit.admissible.truth);
}

AnyState first_state(const MachineOrbit& orbit) {
  const Vector& state = orbit.phases.front().state;
  return state.unaryExpr([](const Ball& x) { return x.approximate(); });
}

void add_attractors(Json& data, std::vector<File>& files, const auto& result) {
  const Seen seen = seen_of(result);
  const std::vector<MachineAttractor>& attractors = result.attractors;
  const auto all = told(attractors, seen);
  orbits::add_motions(data, files, std::min(attractors.size(), orbits::most_pictured), [&](std::size_t i) {
    const MachineAttractor& a = attractors[i];
    const bool periodic = a.kind == Kind::periodic && a.orbit;
    return on_page(seen, periodic ? name_of(*a.orbit, seen.oscillator().is_autonomous()) : to_string(a.kind),
                   periodic ? &*a.orbit : nullptr, periodic ? tone_of(*a.orbit) : "checked",
                   periodic ? all[i].remark : "seen in a simulation", {orbits::row_of_starts(a)}, a.state, 0,
                   result.question.digits);
  });
}

template <class Result>
std::vector<File> with_json(Json& data, std::vector<File> files, const char * name, const Result& result) {
  data["data_file"] = name;
  files.push_back({name, to_text(to_json(result))});
  return orbits::with_page("attractors.html", data, std::move(files));
}

}  // namespace

std::vector<File> pages(const Attractors& result) {
  Json data = frame("What the machine does", result);
  std::vector<File> files;
  add_attractors(data, files, result);
  return with_json(data, std::move(files), "attractors.json", result);
}

std::vector<File> pages(const Diagram& result) {
  Json data = frame("What the machine does along " + result.parameter, result);
  const orbits::ToldAlong along = told(result);
  data["tables"].push_back(orbits::table("question", "Question", question_rows(along)));
  std::vector<File> files;
  add_along(data, files, along);
  return with_json(data, std::move(files), "diagram.json", result);
}

std::vector<File> pages(const Basins& result) {
  Json data = frame("Where starts in a plane end", result);
  std::vector<File> files;
  add_attractors(data, files, result);
  add_plane(data, files, told(result));
  return with_json(data, std::move(files), "basins.json", result);
}

std::vector<File> pages(const WordOrbits& result) {
  const Seen seen = seen_of(result);
  Json data = frame("Orbits through " + result.question.word.letters(), result);
  std::vector<File> files;
  orbits::add_motions(data, files, result.orbits.size(), [&](std::size_t i) {
    const MachineOrbit& orbit = result.orbits[i];
    return on_page(seen, name_of(orbit, seen.oscillator().is_autonomous()), &orbit, tone_of(orbit),
                   remark(orbit), {}, first_state(orbit), orbit.load.approximate(), result.question.digits);
  });
  return with_json(data, std::move(files), "orbits.json", result);
}

std::string plot_script(const Branches& result, PlotFormat format, PlotShape shape) {
  orbits::BranchCurves curves;
  const std::size_t j = result.question.machine.oscillator.rubbing;
  for (const MachineBranch& branch : result.branches) {
    curves.begin();
    for (const MachineSample& s : branch.samples) {
      curves.add(s.state, s.value.get_d(),
                 s.orbit.phases.front().state(static_cast<Eigen::Index>(j)).approximate());
    }
    curves.end();
    for (const MachineChange& change : branch.changes) {
      curves.mark(change.kind, Rational((change.first + change.last) / 2).get_d());
    }
  }
  const std::string x = fmt::format("x{}{}", j + 1, result.origin.in_SI ? " in m" : "");
  const Varied& v = result.varied;
  return curves.script({result.question.word.letters(), parameter_of(v.path, result.origin), x,
                        result.origin.file, v.from.get_d(), v.to.get_d()},
                       format, shape);
}

std::vector<File> pages(const Branches& result) {
  const std::string parameter = parameter_of(result.varied.path, result.origin);
  const std::string drawn = fmt::format("position of mass {} where the first phase begins",
                                        result.question.machine.oscillator.rubbing + 1);
  Json data = frame("Branches along " + result.varied.path, result);
  data["family"] = "Motions through " + result.question.word.letters();
  data["parameter"] = parameter;
  data["branches"] = Json::array();
  data["at_values"] = true;
  data["what_is_drawn"] = fmt::format("the {}, of each motion that was proved", drawn);
  for (const MachineBranch& branch : result.branches) {
    const orbits::BranchRows rows = rows_of(branch);
    Json one = {{"number", data["branches"].size() + 1},
                {"tone", branch.resolved() ? "proved" : "undecided"},
                {"tell", branch.resolved() ? "each motion proved" : "undecided in part"},
                {"heading", rows.heading},
                {"pieces", orbits::cells(rows.pieces, {"from", "to", "count", "state"})},
                {"changes", orbits::cells(rows.changes, {"at", "words", "verdict"})}};
    for (Json& change : one["changes"]) {
      change["tone"] = "proved";
    }
    data["branches"].push_back(std::move(one));
  }
  data["counts"] = Json::array();
  data["unresolved"] = Json::array();
  data["picture_in_words"] =
      fmt::format("The {} against {}. The tables below say the same.", drawn, parameter);
  std::vector<File> files = orbits::pictures(
      [&](PlotFormat format, PlotShape shape) { return plot_script(result, format, shape); }, "branches");
  data["picture"] = !files.empty();
  files.push_back({"branches.csv", to_csv(result)});
  files.push_back({"branches.json", to_text(to_json(result))});
  return orbits::with_page("branches.html", data, std::move(files));
}

namespace {

// What parts look like, and whether one looks so.
struct Look {
  const char * words;
  const char * colour;
  bool (*is_of)(const PartOfBox&);
};

bool exists(const PartOfBox& part) {
  return part.existence.truth == Truth::proved;
}
template <branches::State state>
bool is(const PartOfBox& part) {
  return exists(part) && part.motions.state == state;
}

constexpr std::array<Look, 6> looks{
    {{"stable", "#4eb3d3", is<branches::State::stable>},
     {"unstable", "#ef8a62", is<branches::State::unstable>},
     {"closed, but against the friction law", "#c0c0c0",
      [](const PartOfBox& part) {
        return is<branches::State::inadmissible>(part) || is<branches::State::absent>(part);
      }},
     {"1 is a multiplier", "#7b3294", is<branches::State::marginal>},
     {"there, but what they are is not decided", "#fdd49e",
      [](const PartOfBox& part) { return exists(part) && !is_decided(part.motions.state); }},
     {"not decided", "#404040", [](const PartOfBox& part) { return !exists(part); }}}};

}  // namespace

std::string plot_script(const OverBox& result, PlotFormat format, PlotShape shape, std::size_t motion) {
  if (motion >= result.motions.size()) {
    return "";
  }
  const bool narrow = shape == PlotShape::narrow;
  Json data{
      {"terminal", narrow ? terminal(format, 480, 560) : terminal(format, 900, 700)},
      {"narrow", narrow},
      {"title",
       fmt::format("What motions through {} are, {}", result.question.word.letters(), result.origin.file)},
      {"start", fmt::format("{:.17g} {:.17g}", result.data[0].start.get_d(), result.data[1].start.get_d())},
      {"kinds", Json::array()}};
  for (const auto& [k, name, from, to] :
       {std::tuple(std::size_t{0}, "x", "left", "right"), std::tuple(std::size_t{1}, "y", "bottom", "top")}) {
    data[name] = parameter_of(result.data[k].path, result.origin);
    data[from] = fmt::format("{:.17g}", result.data[k].from.get_d());
    data[to] = fmt::format("{:.17g}", result.data[k].to.get_d());
  }
  const auto is_drawn = [&](const PartOfBox& part) {
    for (std::size_t k = 2; k < part.low.size(); ++k) {
      if (result.data[k].start < part.low[k] || result.data[k].start > part.high[k]) {
        return false;
      }
    }
    return true;
  };
  for (const Look& look : looks) {
    std::string table;
    for (const PartOfBox& part : result.motions[motion].parts) {
      if (is_drawn(part) && look.is_of(part)) {
        table += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", part.low[0].get_d(), part.high[0].get_d(),
                             part.low[1].get_d(), part.high[1].get_d());
      }
    }
    if (!table.empty()) {
      data["kinds"].push_back({{"block", fmt::format("$kind{}", data["kinds"].size())},
                               {"table", table},
                               {"words", look.words},
                               {"colour", look.colour}});
    }
  }
  return render_file("box.gp", data, plain_format);
}

std::vector<File> pages(const OverBox& result) {
  const Seen seen = seen_of(result);
  Json data = frame(result.question.word.letters() + " over a box of data", result);
  data["tables"].push_back(orbits::table(
      "box", "Box", {{{"data"}, {box_of(result)}}, {{"looked for"}, {"at " + start_of(result)}}}));
  data["motions"] = Json::array();
  std::vector<File> files;
  for (std::size_t k = 0; k < result.motions.size(); ++k) {
    const OverBox::Family& family = result.motions[k];
    const BoxRows rows = rows_of(result, family);
    const std::string stem = fmt::format("box-{}", k + 1);
    Json one{{"number", k + 1},
             {"tone", rows.proved ? "proved" : "undecided"},
             {"tell", rows.proved ? "all decided" : "undecided in part"},
             {"heading", rows.heading},
             {"rows", orbits::rows_data(orbit_rows(family.at_start, seen, result.question.digits))},
             {"picture", stem},
             {"picture_in_words", fmt::format("Parts of the box. The table above says how much they are.")},
             {"what_is_drawn",
              fmt::format("the parts of the box{}, and what motions are in them",
                          result.data.size() > 2 ? " where the other data are those of the start" : "")}};
    one["kinds"] = orbits::cells(rows.kinds, {"share", "parts", "words"});
    std::ranges::move(
        orbits::pictures(
            [&](PlotFormat format, PlotShape shape) { return plot_script(result, format, shape, k); }, stem),
        std::back_inserter(files));
    data["motions"].push_back(std::move(one));
  }
  files.push_back({"box.csv", to_csv(result)});
  files.push_back({"box.json", to_text(to_json(result))});
  return orbits::with_page("box.html", data, std::move(files));
}

}  // namespace stickslip::report::machines
