#include "report/orbits/orbits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "numeric/families/family.hpp"
#include "numeric/motion/contact.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;

std::string shown(const std::optional<Ball>& margin) {
  return margin ? rounded(*margin, 5) : "";
}

std::string bold(const Style& style) {
  return style.colour ? "\x1b[1m" : "";
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

std::string condition_rows(const std::vector<Condition>& conditions, const Style& style) {
  std::vector<Row> rows{{{"  condition"}, {"verdict"}, {"margin"}, {"at t"}, {""}}};
  for (const Condition& c : conditions) {
    rows.push_back({{"  " + c.id},
                    {spaced(to_string(c.verdict.truth)), colour_of(c.verdict.truth, style)},
                    {shown(c.margin)},
                    {shown(c.at)},
                    {c.statement}});
    if (c.verdict.truth != Truth::proved && c.verdict.truth != Truth::refuted) {
      rows.push_back({{""}, {""}, {""}, {""}, {c.verdict.reason}});
    }
  }
  return columns_of(rows, style.width);
}

namespace {

std::string head(const OrbitList& list, const Style& style) {
  std::vector<Row> rows{{{"parameters"}, {parameter_list(list.question)}},
                        {{"searched"}, {searched(list.question)}},
                        {{"result"}, {result_of_search(list)}}};
  for (const Remark remark : list.remarks) {
    rows.push_back({{"remark"}, {describe(remark)}});
  }
  if (const std::string on_ur = remark_on_ur(list); !on_ur.empty()) {
    rows.push_back({{"remark"}, {on_ur}});
  }
  for (const Unresolved& part : list.unresolved) {
    rows.push_back({{"unresolved"}, {place_text(part.where) + part.reason}});
  }
  const Row heading{{list.question.family->title, bold(style)}};
  return columns_of({heading}, style.width) + columns_of(rows, style.width);
}

bool is_given(const NamedBall& value, const OrbitQuestion& question) {
  return (value.name == "phi" && question.phi) || (value.name == "ur" && question.ur);
}

// Without those that are given: they stand in the head.
std::string values(const Orbit& orbit, const OrbitQuestion& question, const Style& style,
                   const Units& units) {
  std::vector<Row> rows;
  for (const NamedBall& value : orbit.values) {
    if (!is_given(value, question)) {
      rows.push_back({{"  " + value.name}, {units.text(value, question.digits)}});
    }
  }
  return columns_of(rows, style.width);
}

std::string all_about(const OrbitList& list, std::size_t i, const Style& style, const Units& units) {
  const Orbit& orbit = list.orbits[i];
  const std::string label = fmt::format("Orbit {} of {}:", i + 1, list.orbits.size());
  const Row heading{{label, bold(style)}, {verdict_on(orbit), colour_of(orbit.admissible.truth, style)}};
  return "\n" + columns_of({heading}, style.width) + values(orbit, list.question, style, units) +
         stability_rows(orbit, units.digits(list.question.digits), style) + "\n" +
         neighbourhood_text(orbit, style, units, ur_of_neighbourhood(list.question, orbit)) +
         condition_rows(orbit.conditions, style);
}

// What tells formal solutions apart: how long their phases last, and what else is a result.
bool tells_apart(const NamedBall& value, const OrbitQuestion& question) {
  const std::vector<std::string>& durations = question.family->durations;
  const bool result = value.name == "phi" || value.name.starts_with("ur");
  return !is_given(value, question) &&
         (result || std::find(durations.begin(), durations.end(), value.name) != durations.end());
}

// In a line each.
std::string formal_solutions(const OrbitList& list, const std::vector<std::size_t>& which, const Style& style,
                             const Units& units) {
  if (which.empty()) {
    return {};
  }
  Row names{{"  orbit"}};
  for (const NamedBall& value : list.orbits[which.front()].values) {
    if (tells_apart(value, list.question)) {
      names.push_back({value.name});
    }
  }
  names.push_back({"violates"});
  std::vector<Row> rows{names};
  for (const std::size_t i : which) {
    Row row{{fmt::format("  {}", i + 1)}};
    for (const NamedBall& value : list.orbits[i].values) {
      if (tells_apart(value, list.question)) {
        row.push_back({units.short_text(value, digits_in_rows)});
      }
    }
    row.push_back(violated(list.orbits[i], style));
    rows.push_back(row);
  }
  return table_of_formal(rows, style);
}

}  // namespace

Told told(const std::vector<Truth>& admissible, InFull in_full) {
  Told result;
  const auto is = [&](std::size_t i, Truth truth) { return admissible[i] == truth; };
  for (std::size_t i = 0; i < admissible.size(); ++i) {
    (is(i, Truth::refuted) && in_full == InFull::admissible ? result.formal : result.in_full).push_back(i);
  }
  const auto begin = result.in_full.begin();
  const auto refuted = std::stable_partition(begin, result.in_full.end(),
                                             [&](std::size_t i) { return !is(i, Truth::refuted); });
  std::stable_partition(begin, refuted, [&](std::size_t i) { return is(i, Truth::proved); });
  return result;
}

Cell violated(const Orbit& orbit, const Style& style) {
  constexpr std::size_t most = 3;
  const std::vector<std::string> ids = decisive_conditions(orbit);
  const std::vector<std::string> first(ids.begin(),
                                       ids.begin() + static_cast<std::ptrdiff_t>(std::min(most, ids.size())));
  const std::string more = ids.size() > most ? fmt::format(" and {} more", ids.size() - most) : "";
  return {fmt::format("{}{}", fmt::join(first, ", "), more), colour_of(Truth::refuted, style)};
}

std::string table_of_formal(const std::vector<Row>& rows, const Style& style) {
  return "\n" +
         columns_of({{{"Formal solutions, not admissible", bold(style)}, {"(--all says all about them)"}}},
                    style.width) +
         columns_of(rows, style.width);
}

std::string terminal_report(const OrbitList& list, const Style& style, const Units& units, InFull in_full) {
  std::vector<Truth> admissible;
  for (const Orbit& orbit : list.orbits) {
    admissible.push_back(orbit.admissible.truth);
  }
  const Told these = told(admissible, in_full);
  std::string text = head(list, style);
  for (const std::size_t i : these.in_full) {
    text += all_about(list, i, style, units);
  }
  text += formal_solutions(list, these.formal, style, units);
  return these.in_full.empty() ? text
                               : text + "\n" +
                                     (list.question.neighbourhood
                                          ? labelled(0, "recovers", meaning_of_neighbourhood(), style.width)
                                          : "") +
                                     labelled(0, "margin", meaning_of_margin(), style.width) +
                                     labelled(0, "units", meaning_of_units(units.are_SI()), style.width);
}

}  // namespace stickslip::report::orbits
