#include "report/orbits/orbits.hpp"

#include <fmt/format.h>

#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;

namespace {

constexpr int margin_digits = 5;

// A margin or its time, if known.
std::string shown(const std::optional<Ball>& ball) {
  return ball ? rounded(*ball, margin_digits) : "";
}

}  // namespace

std::string bold(const Style& style) {
  return style.colour ? "\x1b[1m" : "";
}

std::string colour_of(Truth truth, const Style& style) {
  if (!style.colour) {
    return {};
  }
  return truth == Truth::proved ? "\x1b[32m" : truth == Truth::refuted ? "\x1b[31m" : "\x1b[33m";
}

std::string stability_rows(const std::optional<Stability>& stability, int digits, const Style& style) {
  if (!stability) {
    return {};
  }
  const Stability& s = *stability;
  std::vector<Row> rows{{{"  stability"}, {to_string(s.kind) + (s.reason.empty() ? "" : ": " + s.reason)}}};
  for (const ComplexBall& mu : s.multipliers) {
    rows.push_back({{"  multiplier"}, {complex_text(mu, digits)}});
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

std::string parameter_list(const OrbitQuestion& question) {
  std::string text;
  for (const NamedRange& parameter : named_parameters(question)) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", parameter.name, notation(parameter.range));
  }
  return text;
}

std::string head(const OrbitList& list, const Style& style) {
  std::vector<Row> rows{{{"parameters"}, {parameter_list(list.question)}},
                        {{"searched"}, {searched(list.question)}},
                        {{"result"}, {result_of_search(list)}}};
  for (const Remark remark : list.remarks) {
    rows.push_back({{"remark"}, {describe(remark)}});
  }
  for (const Unresolved& part : list.unresolved) {
    std::string where;
    for (const NamedBall& value : part.where) {
      where += fmt::format("{} = {}, ", value.name, to_string(value.value, 8));
    }
    rows.push_back({{"unresolved"}, {where + part.reason}});
  }
  const Row heading{{list.question.family->title, bold(style)}};
  return columns_of({heading}, style.width) + columns_of(rows, style.width);
}

// Without those that are given: they stand in the head.
std::string values(const Orbit& orbit, const OrbitQuestion& question, const Style& style,
                   const Units& units) {
  std::vector<Row> rows;
  for (const NamedBall& value : orbit.values) {
    if ((value.name == "phi" && question.phi) || (value.name == "ur" && question.ur)) {
      continue;
    }
    rows.push_back({{"  " + value.name}, {units.text(value, question.digits)}});
  }
  return columns_of(rows, style.width);
}

}  // namespace

std::string terminal_report(const OrbitList& list, const Style& style, const Units& units) {
  std::string text = head(list, style);
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    const Orbit& orbit = list.orbits[i];
    const std::string label = fmt::format("Orbit {} of {}:", i + 1, list.orbits.size());
    const Row heading{{label, bold(style)}, {verdict_on(orbit), colour_of(orbit.admissible.truth, style)}};
    text += "\n" + columns_of({heading}, style.width) + values(orbit, list.question, style, units) +
            stability_rows(orbit.stability, list.question.digits, style) + "\n" +
            condition_rows(orbit.conditions, style);
  }
  return list.orbits.empty()
             ? text
             : text + "\n" +
                   labelled(0, "margin", meaning_of_margin() + (units.are_SI() ? units_of_conditions() : ""),
                            style.width);
}

}  // namespace stickslip::report::orbits
