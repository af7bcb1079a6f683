#include "report/orbits/orbits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "numeric/families/family.hpp"
#include "numeric/motion/stability.hpp"
#include "report/orbits/attractors/attractors.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using attractors::WordOrbits;
using attractors::WordSearch;

namespace {

std::string searched_for(const WordOrbits& list) {
  if (list.searched) {
    return "all durations of the phases, every phase of the load";
  }
  return list.question.near ? "near " + state_of(*list.question.near) : "where random starts settle";
}

std::string result_of(const WordOrbits& list) {
  if (list.orbits.empty() && !list.searched) {
    return "no orbit found: " + list.seen + (list.interrupted ? "; interrupted" : "");
  }
  if (list.orbits.empty() && !list.seen.empty()) {
    return "complete: no orbit: " + list.seen;
  }
  const auto good = std::ranges::count_if(list.orbits, families::is_admissible, &words::WordOrbit::orbit);
  const std::string count =
      fmt::format("{} {}, {} admissible", list.orbits.empty() ? "no" : std::to_string(list.orbits.size()),
                  list.orbits.size() == 1 ? "orbit" : "orbits", good);
  const std::string completeness = !list.searched ? "" : list.complete() ? "complete: " : "not complete: ";
  return completeness + count + (list.searched ? "" : "; others may exist") +
         (list.seen.empty() ? "" : ": " + list.seen) + (list.interrupted ? "; interrupted" : "");
}

}  // namespace

Listed::Listed(const OrbitList& found)
    : list(found),
      title(found.question.family->title),
      searched(orbits::searched(found.question)),
      result(result_of_search(found)),
      command(command_of(found.question)),
      durations(found.question.family->durations) {}

Listed::Listed(const WordOrbits& found)
    : searched(searched_for(found)),
      result(result_of(found)),
      command(command_of(found.question)),
      word(std::make_shared<const WordOrbits>(found)) {
  const WordSearch& q = found.question;
  const motion::ExactParameters& a = q.machine.data;
  const auto family = std::make_shared<Family>();
  family->name = q.word.letters();
  family->phases = q.word.phases();
  record = family;
  title = fmt::format("Orbits through {} in {} of the load", shortened(family->name),
                      q.periods == 1 ? "1 period" : fmt::format("{} periods", q.periods));
  for (const char letter : family->name) {
    durations.emplace_back(1, letter);
  }
  list.question = {record.get(),
                   {Range{a.chi}, Range{a.eta}, Range{a.us}, Range{a.V}, Range{a.omega}, Range{a.p}},
                   {},
                   Range{q.machine.ur},
                   q.machine.digits};
  list.unresolved = found.unresolved;
  for (const words::WordOrbit& one : found.orbits) {
    list.orbits.push_back(one.orbit);
    list.orbits.back().conditions = worst(one.orbit.conditions);
  }
}

using namespace numeric::motion;
using namespace tools;

std::string shown(const std::optional<Ball>& margin) {
  return margin ? rounded(*margin, 5) : "";
}

std::string bold(const Style& style) {
  return style.colour ? "\x1b[1m" : "";
}

std::string headed(const std::string& heading, const std::vector<Row>& rows, const Style& style) {
  return columns_of({{{heading, bold(style)}}}, style.width) + columns_of(rows, style.width);
}

std::string colour_of(Truth truth, const Style& style) {
  if (!style.colour) {
    return {};
  }
  return truth == Truth::proved ? "\x1b[32m" : truth == Truth::refuted ? "\x1b[31m" : "\x1b[33m";
}

std::string contact_in_words(const Orbit& orbit) {
  const std::optional<Contact> contact = contact_of(orbit.conditions);
  if (!orbit.stability || orbit.stability->kind != StabilityKind::stable || !contact) {
    return "";
  }
  return fmt::format("{}, by {} at t = {}: a disturbance that reaches as far may lead to another motion",
                     contact->condition, shown(contact->margin), shown(contact->at));
}

std::string condition_rows(const std::vector<Condition>& conditions, const Style& style) {
  std::vector<Row> rows{{{"  condition"}, {"verdict"}, {"margin"}, {"at t"}, {""}}};
  for (const Condition& c : conditions) {
    rows.push_back({{"  " + c.id},
                    {spaced(to_string(c.verdict.truth)), colour_of(c.verdict.truth, style)},
                    {shown(c.margin)},
                    {shown(c.at)},
                    {c.statement}});
    if (!c.verdict.is_decided()) {
      rows.push_back({{""}, {""}, {""}, {""}, {c.verdict.reason}});
    }
  }
  return columns_of(rows, style.width);
}

namespace {

constexpr std::size_t most_phases = 16;  // in a table
constexpr int digits_in_rows = 6;        // of formal solutions

std::string head(const Listed& listed, const Style& style) {
  const OrbitList& list = listed.list;
  std::vector<Row> rows{{{"parameters"}, {parameter_list(list.question)}},
                        {{"searched"}, {listed.searched}},
                        {{"result"}, {listed.result}}};
  for (const Remark remark : list.remarks) {
    rows.push_back({{"remark"}, {describe(remark)}});
  }
  if (const std::string on_ur = remark_on_ur(list); !on_ur.empty()) {
    rows.push_back({{"remark"}, {on_ur}});
  }
  for (const Unresolved& part : list.unresolved) {
    rows.push_back({{"unresolved"}, {place_text(part.where) + part.reason}});
  }
  return headed(listed.title, rows, style);
}

bool is_given(const NamedBall& value, const OrbitQuestion& question) {
  return (value.name == "phi" && question.phi) || (value.name == "ur" && question.ur);
}

// Without those that are given: they stand in the head.
std::vector<Row> values(const Listed& listed, std::size_t i, const Units& units) {
  std::vector<Row> rows;
  if (listed.word) {
    const words::WordOrbit& o = listed.word->orbits[i];
    rows = {{{"  word"}, {o.word.letters()}}, {{"  period"}, {fmt::format("{} of the load", o.periods)}}};
  }
  const OrbitQuestion& question = listed.list.question;
  for (const NamedBall& value : listed.list.orbits[i].values) {
    if (!is_given(value, question)) {
      rows.push_back({{"  " + value.name}, {units.text(value, question.digits)}});
    }
  }
  return rows;
}

std::string phases(const Motion& m, const Style& style, const Units& units) {
  const int digits = units.digits(10);
  std::vector<Row> rows{{{"  phase"},
                         {units.are_SI() ? "from t in s" : "begins at t"},
                         {units.labelled("lasts", "s")},
                         {units.labelled("x1", "m")},
                         {units.labelled("x2", "m")},
                         {units.labelled("x1'", "m/s")}}};
  for (std::size_t k = 0; k < std::min(m.phases.size(), most_phases); ++k) {
    const Phase& f = m.phases[k];
    rows.push_back({{fmt::format("  {} {}", words::letter(f.kind), to_string(f.kind))},
                    {k == 0 ? "0" : rounded(units.time(f.start), digits)},
                    {rounded(units.time(f.duration), digits)},
                    {rounded(units.length(f.Z(0) + m.oscillator.d0(0)), digits)},
                    {rounded(units.length(f.Z(1) + m.oscillator.d0(1)), digits)},
                    {rounded(units.velocity(f.Z(2)), digits)}});
  }
  if (m.phases.size() > most_phases) {
    rows.push_back(
        {{"  ..."}, {fmt::format("{} more", m.phases.size() - most_phases)}, {""}, {""}, {""}, {""}});
  }
  return columns_of(rows, style.width);
}

std::string stability_rows(const Orbit& orbit, int digits, const Style& style) {
  if (!orbit.stability) {
    return {};
  }
  const Stability& s = *orbit.stability;
  std::vector<Row> rows{{{"  stability"}, {to_string(s.kind) + (s.reason.empty() ? "" : ": " + s.reason)}}};
  for (const ComplexBall& mu : s.multipliers) {
    rows.push_back({{"  multiplier"}, {complex_text(mu, digits)}});
  }
  if (const std::string contact = contact_in_words(orbit); !contact.empty()) {
    rows.push_back({{"  nearest"}, {contact}});
  }
  return "\n" + columns_of(rows, style.width);
}

std::string all_about(const Listed& listed, std::size_t i, const Style& style, const Units& units) {
  const OrbitList& list = listed.list;
  const Orbit& orbit = list.orbits[i];
  const std::string label = fmt::format("Orbit {} of {}:", i + 1, list.orbits.size());
  const Row heading{{label, bold(style)}, {verdict_on(orbit), colour_of(orbit.admissible.truth, style)}};
  return "\n" + columns_of({heading}, style.width) + columns_of(values(listed, i, units), style.width) +
         (listed.word ? "\n" + phases(orbit.motion, style, units) : "") +
         stability_rows(orbit, units.digits(list.question.digits), style) + "\n" +
         neighbourhood_text(orbit, style, units, ur_of_neighbourhood(list.question, orbit)) +
         condition_rows(orbit.conditions, style);
}

// What tells formal solutions apart, each under a name: how long their phases last, at most six of them, and
// what else is a result.
std::vector<std::pair<std::string, NamedBall>> told_apart_by(const Listed& listed, const Orbit& orbit) {
  constexpr std::size_t most = 6;
  std::vector<std::pair<std::string, NamedBall>> values;
  for (std::size_t k = 0; k < std::min(most, orbit.motion.phases.size()); ++k) {
    values.push_back({listed.durations[k], {"tau", orbit.motion.phases[k].duration}});
  }
  for (const NamedBall& value : orbit.values) {
    if ((value.name == "phi" || value.name.starts_with("ur")) && !is_given(value, listed.list.question)) {
      values.emplace_back(value.name, value);
    }
  }
  return values;
}

// The first conditions that a formal solution violates.
Cell violated(const Orbit& orbit, const Style& style) {
  constexpr std::size_t most = 3;
  const std::vector<std::string> ids = decisive_conditions(orbit);
  const std::vector<std::string> first(ids.begin(),
                                       ids.begin() + static_cast<std::ptrdiff_t>(std::min(most, ids.size())));
  const std::string more = ids.size() > most ? fmt::format(" and {} more", ids.size() - most) : "";
  return {fmt::format("{}{}", fmt::join(first, ", "), more), colour_of(Truth::refuted, style)};
}

// In a line each.
std::string formal_solutions(const Listed& listed, const std::vector<std::size_t>& which, const Style& style,
                             const Units& units) {
  if (which.empty()) {
    return {};
  }
  std::vector<Row> rows{{{"  orbit"}}};
  for (const std::size_t i : which) {
    const Orbit& orbit = listed.list.orbits[i];
    Row row{{fmt::format("  {}", i + 1)}};
    for (const auto& [name, value] : told_apart_by(listed, orbit)) {
      row.push_back({units.short_text(value, digits_in_rows)});
      if (rows.size() == 1) {
        rows.front().push_back({name});
      }
    }
    row.push_back(violated(orbit, style));
    rows.push_back(row);
  }
  rows.front().push_back({"violates"});
  return "\n" +
         columns_of({{{"Formal solutions, not admissible", bold(style)}, {"(--all says all about them)"}}},
                    style.width) +
         columns_of(rows, style.width);
}

// Places in a list by what is known of their orbits: those to be told in full, admissible ones first and
// others before those that are not; and formal solutions, unless all are asked for in full.
struct Told {
  std::vector<std::size_t> in_full, formal;
};
Told told(const std::vector<Orbit>& orbits, InFull in_full) {
  Told result;
  const auto is = [&](std::size_t i, Truth truth) { return orbits[i].admissible.truth == truth; };
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    (is(i, Truth::refuted) && in_full == InFull::admissible ? result.formal : result.in_full).push_back(i);
  }
  const auto begin = result.in_full.begin();
  const auto refuted = std::stable_partition(begin, result.in_full.end(),
                                             [&](std::size_t i) { return !is(i, Truth::refuted); });
  std::stable_partition(begin, refuted, [&](std::size_t i) { return is(i, Truth::proved); });
  return result;
}

}  // namespace

std::string terminal_report(const Listed& listed, const Style& style, const Units& units, InFull in_full) {
  const Told these = told(listed.list.orbits, in_full);
  std::string text = head(listed, style);
  for (const std::size_t i : these.in_full) {
    text += all_about(listed, i, style, units);
  }
  text += formal_solutions(listed, these.formal, style, units);
  if (these.in_full.empty()) {
    return text;
  }
  text += "\n";
  if (std::ranges::any_of(listed.list.orbits, [](const Orbit& o) { return o.neighbourhood != nullptr; })) {
    text += labelled(0, "recovers", meaning_of_neighbourhood(), style.width);
  }
  if (listed.word) {
    text += labelled(0, "condition", "of all phases, the one nearest to a violation", style.width);
  }
  return text + labelled(0, "margin", meaning_of_margin(), style.width) +
         labelled(0, "units", meaning_of_units(units.are_SI()), style.width);
}

}  // namespace stickslip::report::orbits
