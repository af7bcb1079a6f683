#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/decimal.hpp"
#include "core/parallel.hpp"
#include "report/machines/results.hpp"
#include "report/machines/rows.hpp"
#include "report/orbits/branches.hpp"
#include "report/orbits/page.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/portraits.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::machines {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using attractors::Kind;
using simulation::AnyState;

namespace {

// Periods of the load that a motion is drawn over at most; without one, some turns of its slowest spring.
constexpr long most_drawn = 20;
constexpr double samples_in_period = 400;

Json frame(const std::string& title, const std::string& command, const Seen& seen, int digits) {
  Json data = orbits::page_data(
      {}, title, command,
      fmt::format("motions are followed in floating point; periodic ones are then proved in balls, their "
                  "values enclosed to {} significant digits, and computed with more bits wherever a verdict "
                  "needs them",
                  digits));
  data["tables"].push_back(orbits::table("machine", "Machine", machine_rows(seen)));
  data["along"] = nullptr;
  data["basins"] = nullptr;
  data["data_file"] = "";
  data["attractors"] = Json::array();
  const bool autonomous = seen.oscillator().is_autonomous();
  data["of_period"] = autonomous ? "a time, proved" : "in periods of the load";
  data["pictures"] =
      std::string(
          "positions and velocities of the mass on the belt and, if there is one, of another, "
          "in the colours of the phases") +
      (autonomous ? "; in floating point."
                  : ", and the mass on the belt once a period of the load; in floating point.");
  return data;
}

// The curve of a motion and, with a load, its states once a period.
orbits::Portrait portrait(const Seen& seen, const AnyState& X, double theta, double period, long periods) {
  const auto o = oscillator_as<double>(seen.machine);
  const auto n = static_cast<Eigen::Index>(o.size());
  const auto j = static_cast<Eigen::Index>(o.rubbing);
  const Eigen::Index other = static_cast<Eigen::Index>(seen.shown_masses().back());
  const auto of_two = [&](const AnyState& Y) {
    return model::Vector4<double>(Y(other), Y(j), Y(n + other), Y(n + j));
  };
  orbits::Portrait result;
  result.drawn = std::min(periods, most_drawn);
  const double duration = static_cast<double>(result.drawn) * period;
  const auto go_on = [](double) { return true; };
  (void)simulation::record_motion(
      o, theta, X, {duration, period / samples_in_period}, go_on,
      [&](const simulation::SampleOf<AnyState>& s) {
        result.samples.push_back({s.time, s.phase, of_two(s.X), s.r, s.u, s.energy});
      });
  if (!seen.oscillator().is_autonomous()) {
    const long count = std::min(periods, orbits::Portrait::most_states);
    (void)simulation::record_motion(
        o, theta, X, {static_cast<double>(count) * period, period}, go_on,
        [&](const simulation::SampleOf<AnyState>& s) { result.once.push_back(of_two(s.X)); });
    result.once.pop_back();
  }
  return result;
}

std::string durations(const MachineOrbit& orbit, const Seen& seen) {
  constexpr std::size_t most = 16;
  std::string text;
  for (std::size_t k = 0; k < std::min(orbit.phases.size(), most); ++k) {
    const MachinePhase& phase = orbit.phases[k];
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", seen.name(phase.piece), rounded(phase.duration, 10));
  }
  return text + (seen.in_SI ? " s" : "") +
         (orbit.phases.size() > most ? fmt::format(", and {} more", orbit.phases.size() - most) : "");
}

struct Drawn {
  Json data;
  std::vector<File> pictures;
};

// A motion with its heading, what is known of it, and its picture.
Drawn drawn(const Seen& seen, std::size_t number, const std::string& name, const MachineOrbit * orbit,
            const std::string& tone, const std::string& tell, std::vector<Row> rows, const AnyState& X,
            double theta, int digits) {
  const bool autonomous = seen.oscillator().is_autonomous();
  const auto o = oscillator_as<double>(seen.machine);
  double period = autonomous ? 10 * 6.283185307179586 : 6.283185307179586 / o.omega;
  long periods = most_drawn;
  if (orbit != nullptr && orbit->existence.truth == Truth::proved) {
    for (Row& row : orbit_rows(*orbit, seen, digits)) {
      rows.push_back(std::move(row));
    }
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
  const orbits::Portrait shown = portrait(seen, X, theta, period, periods);
  const std::string stem = fmt::format("portrait-{}", number);
  const std::vector<std::size_t> masses = seen.shown_masses();
  orbits::PortraitLabels labels;
  labels.masses = masses.size() == 1 ? std::vector<std::size_t>{masses[0]}
                                     : std::vector<std::size_t>{masses[1], masses[0]};
  labels.in_SI = seen.in_SI;
  return {{{"number", number},
           {"name", name},
           {"tone", tone},
           {"tell", tell},
           {"rows", orbits::rows_data(rows)},
           {"picture", stem},
           {"picture_in_words", orbits::picture_in_words(shown, labels)}},
          orbits::screen_pictures(
              [&](PlotFormat format, PlotShape shape) { return plot_script(shown, format, shape, labels); },
              stem)};
}

void add(Json& data, std::vector<File>& files, std::vector<Drawn> all) {
  for (Drawn& one : all) {
    data["attractors"].push_back(std::move(one.data));
    std::ranges::move(one.pictures, std::back_inserter(files));
  }
}

std::string tone_of(const MachineOrbit& orbit) {
  return orbit.existence.truth != Truth::proved ? "undecided" : to_string(orbit.admissible.truth);
}

AnyState first_state(const MachineOrbit& orbit) {
  const Vector& state = orbit.phases.front().state;
  return state.unaryExpr([](const Ball& x) { return x.approximate(); });
}

}  // namespace

namespace {

void add_attractors(Json& data, std::vector<File>& files, const Seen& seen,
                    const std::vector<MachineAttractor>& attractors, int digits) {
  constexpr std::size_t most = 24;
  const bool autonomous = seen.oscillator().is_autonomous();
  add(data, files, parallel_map(std::min(attractors.size(), most), [&](std::size_t i) {
        const MachineAttractor& a = attractors[i];
        const bool periodic = a.kind == Kind::periodic && a.orbit;
        return drawn(seen, i + 1, periodic ? name_of(*a.orbit, autonomous) : to_string(a.kind),
                     periodic ? &*a.orbit : nullptr, periodic ? tone_of(*a.orbit) : "checked",
                     periodic ? remark(a, autonomous) : "seen in a simulation",
                     {{{"starts"},
                       {fmt::format("{}: {:.1f} %, within {:.1f} and {:.1f} %", a.count, 100 * a.share,
                                    100 * a.least, 100 * a.most)}}},
                     a.state, 0, digits);
      }));
}

template <class Result>
std::vector<File> with_json(Json& data, std::vector<File> files, const char * name, const Result& result) {
  data["data_file"] = name;
  files.push_back({name, to_text(to_json(result))});
  return orbits::with_page("attractors.html", data, std::move(files));
}

}  // namespace

std::vector<File> pages(const Attractors& result) {
  const MachineAttractors& list = result.list;
  const Seen seen{list.question.machine, result.origin.in_SI};
  Json data = frame("What the machine does", command_of(result), seen, list.question.digits);
  std::vector<File> files;
  add_attractors(data, files, seen, list.attractors, list.question.digits);
  return with_json(data, std::move(files), "attractors.json", result);
}

std::vector<File> pages(const Diagram& result) {
  const MachineStarts& q = result.diagram.question;
  const Seen seen{q.machine, result.origin.in_SI};
  Json data = frame("What the machine does along " + result.parameter, command_of(result), seen, q.digits);
  data["tables"].push_back(orbits::table("question", "Question", question_rows(result)));
  data["along"] = along_data(result);
  std::vector<File> files;
  if (const std::string script = plot_script(result, PlotFormat::svg); !script.empty()) {
    data["along"]["picture"] = "diagram.svg";
    files.push_back({"diagram.svg", gnuplot(script)});
  }
  return with_json(data, std::move(files), "diagram.json", result);
}

std::vector<File> pages(const Basins& result) {
  const MachineBasins& b = result.basins;
  const Seen seen{b.question.machine, result.origin.in_SI};
  Json data = frame("Where starts in a plane end", command_of(result), seen, b.question.digits);
  std::vector<File> files;
  add_attractors(data, files, seen, b.attractors, b.question.digits);
  if (const std::string script = plot_script(result, PlotFormat::svg); !script.empty()) {
    data["basins"] = basins_data(result);
    files.push_back({"basins.svg", gnuplot(script)});
  }
  return with_json(data, std::move(files), "basins.json", result);
}

std::vector<File> pages(const WordOrbits& result) {
  const MachineWordOrbits& list = result.list;
  const Seen seen{list.question.machine, result.origin.in_SI};
  Json data =
      frame("Orbits through " + list.question.word.letters(), command_of(result), seen, list.question.digits);
  std::vector<File> files;
  add(data, files, parallel_map(list.orbits.size(), [&](std::size_t i) {
        const MachineOrbit& orbit = list.orbits[i];
        return drawn(seen, i + 1, name_of(orbit, seen.oscillator().is_autonomous()), &orbit, tone_of(orbit),
                     remark(orbit), {}, first_state(orbit), orbit.load.approximate(), list.question.digits);
      }));
  return with_json(data, std::move(files), "orbits.json", result);
}

std::string plot_script(const Branches& result, PlotFormat format, PlotShape shape) {
  orbits::BranchCurves curves;
  const std::size_t j = result.question.machine.oscillator.rubbing;
  const auto place = [&](const MachineSample& s) {
    return s.orbit.phases.front().state(static_cast<Eigen::Index>(j)).approximate();
  };
  for (const MachineBranch& branch : result.branches) {
    for (const MachineSample& s : branch.samples) {
      curves.add(s.state, s.value.get_d(), place(s));
    }
    curves.end();
    for (const MachineChange& change : branch.changes) {
      const double at = Rational((change.first + change.last) / 2).get_d();
      const auto nearest = std::ranges::min_element(
          branch.samples, {}, [&](const MachineSample& s) { return std::abs(s.value.get_d() - at); });
      if (nearest != branch.samples.end()) {
        curves.mark(change.kind, at, place(*nearest));
      }
    }
  }
  const std::string x = fmt::format("x{}{}", j + 1, result.origin.in_SI ? " in m" : "");
  return curves.script({result.question.word.letters(), parameter_of(result.parameter, result.origin), x,
                        result.origin.file, result.from.get_d(), result.to.get_d()},
                       format, shape);
}

std::vector<File> pages(const Branches& result) {
  const Seen seen{result.question.machine, result.origin.in_SI};
  Json data = frame("Branches along " + result.parameter, command_of(result), seen, result.question.digits);
  data["family"] = "Motions through " + result.question.word.letters();
  data["parameter"] = parameter_of(result.parameter, result.origin);
  data["branches"] = Json::array();
  data["at_values"] = true;
  data["what_is_drawn"] =
      fmt::format("the position of mass {} where the first phase begins, of each motion that was proved",
                  seen.oscillator().rubbing + 1);
  const auto cells = [](const std::vector<Row>& rows, const std::vector<std::string>& names) {
    return list_of(rows, [&](const Row& row) {
      Json cell;
      for (std::size_t k = 0; k < names.size(); ++k) {
        cell[names[k]] = row[k].text;
      }
      return cell;
    });
  };
  for (const MachineBranch& branch : result.branches) {
    const BranchRows rows = rows_of(branch);
    Json one = {{"number", data["branches"].size() + 1},
                {"tone", branch.resolved() ? "proved" : "undecided"},
                {"tell", branch.resolved() ? "each motion proved" : "undecided in part"},
                {"heading", rows.heading},
                {"pieces", cells(rows.pieces, {"from", "to", "count", "state"})},
                {"changes", cells(rows.changes, {"at", "words", "verdict"})}};
    for (Json& change : one["changes"]) {
      change["tone"] = "proved";
    }
    data["branches"].push_back(std::move(one));
  }
  data["counts"] = Json::array();
  data["unresolved"] = Json::array();
  data["picture_in_words"] = fmt::format(
      "The position of mass {} where the first phase begins against {}. The "
      "tables below say the same.",
      seen.oscillator().rubbing + 1, parameter_of(result.parameter, result.origin));
  std::vector<File> files = orbits::pictures(
      [&](PlotFormat format, PlotShape shape) { return plot_script(result, format, shape); }, "branches");
  data["picture"] = !files.empty();
  files.push_back({"branches.csv", to_csv(result)});
  files.push_back({"branches.json", to_text(to_json(result))});
  return orbits::with_page("branches.html", data, std::move(files));
}

}  // namespace stickslip::report::machines
