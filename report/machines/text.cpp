#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/decimal.hpp"
#include "numeric/scalars/form.hpp"
#include "report/machines/results.hpp"
#include "report/machines/rows.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/orbits/record_json.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::machines {

using namespace numeric;
using namespace numeric::machines;
using namespace tools;
using attractors::Kind;

namespace {

std::string orbit_text(const MachineOrbit& orbit, const Seen& seen, int digits, std::size_t number,
                       const Style& style) {
  const Row title{{fmt::format("Orbit {}:", number), orbits::bold(style)},
                  {orbit.admissible.truth == Truth::proved ? "admissible" : to_string(orbit.admissible.truth),
                   orbits::colour_of(orbit.admissible.truth, style)}};
  return "\n" + columns_of({title}, style.width) + columns_of(orbit_rows(orbit, seen, digits), style.width) +
         "\n" + columns_of(phase_rows(orbit, seen), style.width) + "\n" +
         (orbit.neighbourhood
              ? columns_of(orbits::neighbourhood_rows(*orbit.neighbourhood, coordinates_of(seen)),
                           style.width) +
                    "\n"
              : "") +
         orbits::condition_rows(orbits::worst(orbit.conditions), style);
}

// What numbers in texts on orbits mean.
template <class Orbits>
std::string margins(const Orbits& all, const Seen& seen, const Style& style) {
  const bool any = std::ranges::any_of(all, [](const MachineOrbit& o) { return o.neighbourhood != nullptr; });
  return (any ? labelled(0, "recovers", orbits::meaning_of_neighbourhood(), style.width) : "") +
         labelled(0, "margin",
                  fmt::format("the least distance from a violation, along a phase divided by the time to an "
                              "end where it is zero by itself{}",
                              seen.in_SI ? "; N, m/s and s" : ""),
                  style.width);
}

std::vector<Row> starts_row(const MachineAttractors& list) {
  const MachineStarts& q = list.question;
  return {{{"starts"},
           {orbits::starts_in_words(q.starts, q.seed, q.most_periods, !q.machine.oscillator.is_autonomous()) +
            orbits::interruption_in_words(list.interrupted, list.followed)}}};
}

// The machine below a title, and what else is to be said.
std::string machine_text(const std::string& title, const Seen& seen, const Style& style,
                         const std::vector<Row>& more = {}) {
  std::vector<Row> rows = machine_rows(seen);
  rows.insert(rows.end(), more.begin(), more.end());
  return orbits::headed(title, rows, style);
}

}  // namespace

std::string terminal_report(const Attractors& list, const Style& style) {
  const Seen seen = seen_of(list);
  std::string text =
      machine_text("What the machine does", seen, style, starts_row(list)) + "\n" +
      table_of(told(list.attractors, seen), "period" + seen.unit("s"), orbits::WithInterval::yes, style);
  std::vector<MachineOrbit> proved;
  for (std::size_t i = 0; i < list.attractors.size(); ++i) {
    const MachineAttractor& a = list.attractors[i];
    if (a.orbit && a.orbit->existence.truth == Truth::proved) {
      text += orbit_text(*a.orbit, seen, list.question.digits, i + 1, style);
      proved.push_back(*a.orbit);
    }
  }
  if (list.steady) {
    text += "\n" + columns_of(rows_of(*list.steady, seen, list.question.digits), style.width);
  }
  return text + "\n" +
         labelled(
             0, "share",
             "of the starts, with Wilson's interval of 95 %; what is said to be proved is, of the machine "
             "exactly as it is given; everything else is a check in floating point",
             style.width) +
         margins(proved, seen, style);
}

std::string terminal_report(const WordOrbits& list, const Style& style) {
  const Seen seen = seen_of(list);
  const auto& q = list.question;
  std::vector<Row> more{
      {{"orbits"},
       {fmt::format("{}{}{}", list.orbits.empty() ? "none was found" : std::to_string(list.orbits.size()),
                    list.orbits.empty() && !list.seen.empty() ? ": " + list.seen : "",
                    list.interrupted ? "; interrupted" : "")}}};
  const std::string period = q.periods ? fmt::format(", period {}", *q.periods) : "";
  std::string text =
      machine_text(fmt::format("Orbits through {}{}", q.word.letters(), period), seen, style, more);
  for (std::size_t k = 0; k < list.orbits.size(); ++k) {
    text += orbit_text(list.orbits[k], seen, q.digits, k + 1, style);
  }
  return text + (list.orbits.empty() ? "" : "\n" + margins(list.orbits, seen, style));
}

namespace {

// Rows below their names, all behind two spaces.
std::string indented(const Row& names, std::vector<Row> rows, const Style& style) {
  rows.insert(rows.begin(), names);
  for (Row& row : rows) {
    row[0].text = "  " + row[0].text;
  }
  return columns_of(rows, style.width);
}

// Behind how many were followed.
std::string what_else(const FromOrbits& result) {
  return (result.seen.empty() ? "" : "; " + result.seen) + (result.interrupted ? "; interrupted" : "");
}

}  // namespace

std::string terminal_report(const Branches& result, const Style& style) {
  std::vector<Row> more{
      {{"branches"},
       {fmt::format("{} from {}{}", result.branches.size(), start_of(result.varied), what_else(result))}}};
  std::string text = machine_text(
      fmt::format("{} along {}", result.question.word.letters(), range_of(result.varied, result.origin)),
      seen_of(result), style, more);
  for (std::size_t k = 0; k < result.branches.size(); ++k) {
    const orbits::BranchRows rows = rows_of(result.branches[k]);
    text += "\n" + orbits::headed(fmt::format("Branch {}", k + 1), {}, style) +
            labelled(2, "", rows.heading, style.width);
    text += indented({{"from"}, {"to"}, {"motions"}, {"they are"}}, rows.pieces, style);
    if (!rows.changes.empty()) {
      text += indented({{"at " + result.varied.path}, {"change"}, {""}}, rows.changes, style);
    }
  }
  return text;
}

std::string terminal_report(const OverBox& result, const Style& style) {
  std::vector<Row> more{
      {{"box"}, {box_of(result)}},
      {{"motions"}, {fmt::format("{} at {}{}", result.motions.size(), start_of(result), what_else(result))}}};
  std::string text = machine_text(fmt::format("{} over a box of data", result.question.word.letters()),
                                  seen_of(result), style, more);
  for (std::size_t k = 0; k < result.motions.size(); ++k) {
    const OverBox::Family& family = result.motions[k];
    const BoxRows rows = rows_of(result, family);
    text += "\n" + orbits::headed(fmt::format("Motion {}: {}", k + 1, remark(family.at_start)), {}, style) +
            labelled(2, "", rows.heading, style.width);
    text += indented({{"of the box"}, {"parts"}, {"motions are"}}, rows.kinds, style);
  }
  return text;
}

std::string terminal_report(const Steady& result, const Style& style) {
  const Seen seen = seen_of(result);
  const int digits = result.question.digits;
  std::vector<Row> rows = rows_of(result.state, seen, digits);
  if (result.basin) {
    std::ranges::move(rows_of(*result.basin, seen, digits), std::back_inserter(rows));
  }
  return machine_text("Steady sliding", seen, style) + "\n" + columns_of(rows, style.width);
}

std::string terminal_report(const SteadyBranch& result, const Style& style) {
  const Seen seen = seen_of(result);
  std::vector<Row> rows{{{"from"}, {"to"}, {"values"}, {"steady sliding is"}}};
  const auto& samples = result.along.samples;
  const auto name = [](const SteadySliding& state) {
    return state.existence.truth == Truth::proved ? to_string(state.stability) : state.existence.reason;
  };
  for (auto now = samples.begin(); now != samples.end();) {
    const auto next =
        std::find_if(now, samples.end(), [&](const auto& s) { return name(s.state) != name(now->state); });
    rows.push_back({{rounded(Ball(now->value), 10)},
                    {rounded(Ball(std::prev(next)->value), 10)},
                    {std::to_string(next - now)},
                    {name(now->state)}});
    now = next;
  }
  std::string text =
      machine_text("Steady sliding along " + range_of(result.varied, result.origin), seen, style) + "\n" +
      columns_of(rows, style.width);
  std::vector<Row> changes = rows_of(result.along, seen);
  if (result.basins) {
    const Rectangle& r = result.basins->starts;
    text += fmt::format("\nStarts with x1 from {} to {} and x1' from {} to {} that end in it, proved\n",
                        to_string(r.x_from), to_string(r.x_to), to_string(r.y_from), to_string(r.y_to)) +
            columns_of(rows_of(*result.basins, result.varied.path), style.width) + "\n";
    std::ranges::move(end_rows(*result.basins), std::back_inserter(changes));
  }
  if (!changes.empty()) {
    changes.insert(changes.begin(), {{"at " + result.varied.path}, {"change"}});
    text += columns_of(changes, style.width);
  }
  return text;
}

std::string terminal_report(const Motion& result, const Style& style) {
  const Seen seen = seen_of(result);
  const auto& record = result.record;
  std::vector<Row> rows{
      {{"start"}, {orbits::state_in_words(result.question.start, coordinates_of(seen))}},
      {{"simulated"},
       {fmt::format("t = {:.9g}{}{}", record.done, seen.in_SI ? " s" : "",
                    record.interrupted ? "; interrupted" : "")}},
      {{"end"},
       {fmt::format("{}: {}", to_string(record.end.phase),
                    orbits::state_in_words(record.end.X, coordinates_of(seen)))}},
      {{"shares"}, {orbits::shares_in_words(record)}},
      {{"energy"}, {fmt::format("{:.6g}{} at the end", record.end.energy, seen.in_SI ? " J" : "")}},
      {{"events"}, {fmt::format("{}", record.events)}}};
  Row names{{"  event at t" + seen.unit("s")}, {"from"}, {"to"}, {"r" + seen.unit("N")}};
  for (const std::size_t mass : seen.shown_masses()) {
    names.push_back({fmt::format("x{}{}", mass + 1, seen.unit("m"))});
  }
  const auto piece = [](motion::PhaseKind kind, int number) {
    return number == 0 ? to_string(kind) : fmt::format("{}, piece {}", to_string(kind), number + 1);
  };
  return machine_text("A motion of the machine", seen, style, rows) +
         orbits::event_table(names, record, style, [&](const auto& e) {
           Row row{{fmt::format("  {:.9g}", e.time)},
                   {piece(e.before, e.piece_before)},
                   {piece(e.after, e.piece_after)},
                   {fmt::format("{:.6g}", e.r)}};
           for (const std::size_t mass : seen.shown_masses()) {
             row.push_back({fmt::format("{:.6g}", e.X(static_cast<Eigen::Index>(mass)))});
           }
           return row;
         });
}

std::string to_csv(const Branches& result) {
  std::string text = result.varied.path + ",branch,state,period";
  std::size_t phases = 0;
  for (const MachineBranch& branch : result.branches) {
    for (const MachineSample& s : branch.samples) {
      phases = std::max(phases, s.orbit.phases.size());
    }
  }
  for (std::size_t k = 0; k < phases; ++k) {
    text += fmt::format(",tau{}", k + 1);
  }
  for (const orbits::Coordinate& x : coordinates_of(seen_of(result))) {
    text += "," + x.name;
  }
  text += "\n";
  for (std::size_t b = 0; b < result.branches.size(); ++b) {
    for (const MachineSample& s : result.branches[b].samples) {
      text += fmt::format("{:.17g},{},{},{:.17g}", s.value.get_d(), b + 1, to_string(s.state),
                          s.orbit.period.approximate());
      for (std::size_t k = 0; k < phases; ++k) {
        text += k < s.orbit.phases.size() ? fmt::format(",{:.17g}", s.orbit.phases[k].duration.approximate())
                                          : ",";
      }
      for (const Ball& x : s.orbit.phases.front().state) {
        text += fmt::format(",{:.17g}", x.approximate());
      }
      text += "\n";
    }
  }
  return text;
}

std::string to_csv(const OverBox& result) {
  std::string text = "motion";
  for (const Varied& varied : result.data) {
    text += fmt::format(",{0} from,{0} to", varied.path);
  }
  text += ",existence,state,names,reason\n";
  for (std::size_t k = 0; k < result.motions.size(); ++k) {
    for (const PartOfBox& part : result.motions[k].parts) {
      text += std::to_string(k + 1);
      for (std::size_t i = 0; i < part.low.size(); ++i) {
        text += fmt::format(",{},{}", to_string(part.low[i]), to_string(part.high[i]));
      }
      text += fmt::format(",{},{},\"{}\",\"{}\"\n", to_string(part.existence.truth),
                          to_string(part.motions.state), part.motions.names, part.existence.reason);
    }
  }
  return text;
}

std::string terminal_report(const SetMotion& set, const Style& style) {
  const SetAfterQuestion& q = set.question;
  const Seen seen = seen_of(set);
  std::map<std::string, double> words;
  for (const SetAfter::Part& part : set.parts) {
    words[part.phases()] += set.share(part);
  }
  std::vector<std::pair<std::string, double>> by_share = largest_first(words);
  constexpr std::size_t most_words = 6;
  const std::size_t more = by_share.size() - std::min(by_share.size(), most_words);
  by_share.resize(by_share.size() - more);
  const std::string through =
      enumerated(by_share,
                 [](const auto& one) {
                   return fmt::format("{} ({:.3g} %)", orbits::shortened(one.first), 100 * one.second);
                 }) +
      (more > 0 ? fmt::format(" and {} more", more) : "");
  std::vector<Row> head{
      {{"after"}, {fmt::format("{:.9g}{}", q.time, seen.in_SI ? " s" : "")}},
      {{"proved"},
       {fmt::format("of {} of the starts, in {} {}{}",
                    set.open.empty() ? "all" : below(std::max(0.0, 100 * set.proved() - 1e-9), 6) + " %",
                    set.parts.size(), set.parts.size() == 1 ? "part" : "parts",
                    set.interrupted ? "; interrupted" : "")}}};
  if (!through.empty()) {
    head.push_back({{"phases"}, {through}});
  }
  for (const auto& [reason, share] : set.open) {
    head.push_back({{"open"}, {fmt::format("{:.3g} %: {}", 100 * share, reason)}});
  }
  std::string text = machine_text("Where a set of starts is after some time", seen, style, head);
  const auto all = set.hull();
  if (all.size() == 0) {
    return text;
  }
  std::vector<Row> rows{{{"  "}, {"starts from"}, {"to"}, {"then from"}, {"to"}}};
  const std::vector<orbits::Coordinate> names = coordinates_of(seen);
  for (Eigen::Index k = 0; k < all.size(); ++k) {
    rows.push_back({{"  " + orbits::named(names[static_cast<std::size_t>(k)])},
                    {fmt::format("{:.9g}", q.middle(k) - q.half(k))},
                    {fmt::format("{:.9g}", q.middle(k) + q.half(k))},
                    {below(scalars::ends(all(k)).first, 9)},
                    {above(scalars::ends(all(k)).second, 9)}});
  }
  return text + "\n" + columns_of(rows, style.width) + "\n" +
         labelled(0, "then", "contains all motions from the part of the starts that is proved", style.width);
}

}  // namespace stickslip::report::machines
