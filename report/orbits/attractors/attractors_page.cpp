#include <fmt/format.h>

#include <algorithm>

#include "numeric/motion/stability.hpp"
#include "report/orbits/attractors/attractors.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/page.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace tools;
using words::WordOrbit;
using words::WordQuestion;

namespace {

constexpr std::size_t most_letters = 600;
constexpr int short_digits = 10;
constexpr int multiplier_digits = 6;

// What all pages have.
Json frame_data(const PageFrame& frame, const std::string& title, const std::string& command, int digits) {
  return page_on_motions(frame, title, command, digits, "in periods of the load",
                         "positions and velocities of both masses, in the colours of the phases, and mass 2 "
                         "once a period of the load, at load phase 0; in floating point.");
}

std::string durations(const WordOrbit& o, const Units& units) {
  return durations_in_words(o.orbit.motion.phases, units.unit(" s"), [&](const motion::Phase& phase) {
    return fmt::format("{} {}", words::letter(phase.kind), rounded(units.time(phase.duration), short_digits));
  });
}

// All that is known of an attractor.
std::vector<Row> rows_of(const Attractor& a, const Units& units) {
  std::vector<Row> rows{row_of_starts(a), {{"what is known"}, {remark(a)}}};
  if (a.kind == Kind::periodic) {
    rows.push_back({{"word"},
                    {a.word.size() <= most_letters
                         ? a.word
                         : fmt::format("{}… ({} phases)", a.word.substr(0, most_letters), a.word.size())}});
    rows.push_back({{"period"}, {fmt::format("{} of the load", a.periods)}});
  }
  if (a.orbit && a.orbit->existence.truth == Truth::proved) {
    const families::Orbit& o = a.orbit->orbit;
    rows.push_back({{"durations"}, {durations(*a.orbit, units)}});
    if (o.stability && !o.stability->multipliers.empty()) {
      const auto text = [](const motion::ComplexBall& mu) { return complex_text(mu, multiplier_digits); };
      rows.push_back({{"multipliers"}, {enumerated(o.stability->multipliers, text, "; ")}});
    }
    if (o.neighbourhood) {
      rows.push_back({{"recovers"}, {neighbourhood_in_words(*o.neighbourhood, coordinates_in(units))}});
    }
    if (const std::string contact = contact_in_words(o); !contact.empty()) {
      rows.push_back({{"nearest"}, {contact + units.unit(" (in the units of the data taken)")}});
    }
  }
  rows.push_back({{units.labelled("x1, x2, x1', x2'", "m and m/s")},
                  {state_of(units.state(a.state)) + " at load phase 0"}});
  return rows;
}

std::string tone(const Attractor& a) {
  const bool known = a.orbit && a.orbit->existence.truth == Truth::proved;
  return a.kind == Kind::grows      ? "proved"
         : a.kind != Kind::periodic ? "checked"
         : known                    ? to_string(a.orbit->orbit.admissible.truth)
                                    : "undecided";
}

// "proved, stable", or what kind of motion it seems to be.
std::string tell(const Attractor& a) {
  if (a.kind == Kind::grows) {
    return "proved";
  }
  if (a.kind != Kind::periodic) {
    return "seen in a simulation";
  }
  const bool known = a.orbit && a.orbit->existence.truth == Truth::proved;
  return !known                     ? "not proved"
         : a.orbit->orbit.stability ? "proved, " + to_string(a.orbit->orbit.stability->kind)
                                    : verdict_on(a.orbit->orbit);
}

void add_attractors(Json& data, std::vector<File>& files, const WordQuestion& machine,
                    const std::vector<Attractor>& all, const Units& units) {
  add_motions(data, files, all.size(), [&](std::size_t i) {
    const Attractor& a = all[i];
    const bool periodic = a.kind == Kind::periodic;
    const bool shown = !a.is_too_slow && i < most_pictured;
    return MotionOnPage{
        periodic ? fmt::format("{}, period {}", shortened(a.word), a.periods) : to_string(a.kind),
        tone(a),
        tell(a),
        rows_of(a, units),
        shown ? std::optional(portrait(machine, a, units)) : std::nullopt,
        {{0, 1}, units.are_SI()}};
  });
}

void add_question(Json& data, const auto& result) {
  std::vector<Row> rows = result.oscillator.rows;
  std::ranges::move(question_rows(result), std::back_inserter(rows));
  data["tables"].push_back(table("question", "Question", rows));
}

void add_json(Json& data, std::vector<File>& files, const std::string& name, Json json,
              const PageFrame& frame) {
  data["data_file"] = name;
  files.push_back(json_file(name, std::move(json), frame));
}

}  // namespace

std::vector<File> pages(const AttractorList& list, const std::optional<Basins>& basins,
                        const PageFrame& frame) {
  const WordQuestion& machine = list.question.machine;
  Json data = frame_data(frame, "What the machine does", command_of(list.question), machine.digits);
  data["tables"].push_back(table("question", "Question", rows_of(list)));
  std::vector<File> files;
  add_attractors(data, files, machine, list.attractors, frame.units);
  if (basins) {
    add_plane(data, files, told(*basins, frame.units));
  }
  add_json(data, files, "attractors.json", to_json(list), frame);
  return with_page("attractors.html", data, std::move(files));
}

std::vector<File> pages(const Basins& basins, const PageFrame& frame) {
  const WordQuestion& machine = basins.question.machine.machine;
  Json data = frame_data(frame, "Where starts in a plane end", command_of(basins.question), machine.digits);
  const ToldPlane plane = told(basins, frame.units);
  add_question(data, plane);
  std::vector<File> files;
  add_attractors(data, files, machine, basins.attractors, frame.units);
  add_plane(data, files, plane);
  add_json(data, files, "basins.json", to_json(basins), frame);
  return with_page("attractors.html", data, std::move(files));
}

std::vector<File> pages(const Diagram& diagram, const PageFrame& frame) {
  const DiagramQuestion& q = diagram.question;
  const std::string command =
      q.taken ? fmt::format("stickslip attractors --params {}{}", frame.file, options_along(q))
              : command_of(q);
  Json data =
      frame_data(frame, "What the machine does along " + q.parameter, command, q.machine.machine.digits);
  const ToldAlong along = told(diagram, frame.units);
  add_question(data, along);
  std::vector<File> files;
  add_along(data, files, along);
  if (!q.taken) {
    add_json(data, files, "diagram.json", to_json(diagram), frame);
  }
  return with_page("attractors.html", data, std::move(files));
}

}  // namespace stickslip::report::orbits
