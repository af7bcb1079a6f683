#include "report/orbits/orbit_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "core/names.hpp"
#include "model/named_data.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/attractors/many_starts.hpp"
#include "report/tools/numbers.hpp"
#include "symbolic/typeset/names.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;

namespace {

std::string none_or_counted(std::size_t count, const char * one, const char * many) {
  return count == 0 ? fmt::format("no {}", many) : counted(count, one, many);
}

}  // namespace

std::string notation(const Range& range) {
  const std::string middle = to_string(range.middle);
  return range.radius == 0 ? middle : middle + "+-" + to_string(range.radius);
}

std::string notation(const Rational& value) {
  return to_string(value);
}

Named<Range> named_parameters(const OrbitQuestion& question) {
  Named<Range> named = model::with_names(question.parameters);
  if (question.phi) {
    named.emplace_back("phi", *question.phi);
  }
  if (question.ur) {
    named.emplace_back("ur", *question.ur);
  }
  return named;
}

Named<Rational> named_parameters(const words::WordQuestion& question) {
  Named<Rational> named = model::with_names(question.data);
  named.emplace_back("ur", question.ur);
  return named;
}

std::string place_text(const std::vector<NamedBall>& where) {
  return enumerated(
      where,
      [](const NamedBall& value) { return fmt::format("{} = {}, ", value.name, to_string(value.value, 8)); },
      "");
}

std::string colour_of(PhaseKind kind) {
  return name_of<PhaseKind::stick>(kind, "#1f4e9c", "#c0392b", "#404040");
}

std::string describe(Remark remark) {
  return name_of<Remark::searched_at_middle>(
      remark,
      "$p = 0$: the load's phase means nothing, and each orbit is listed for the first of the two phases "
      "only.",
      "A natural frequency is a multiple of $omega$, so its free oscillation closes: there are also closed "
      "motions that never stick and are not in this list; for $V = 0$ it has those that are their own mirror "
      "images half a period later, and the others that obey the law are one of these with such an "
      "oscillation added.",
      "The search was interrupted: orbits may be missing, and the unresolved boxes are where.",
      "$V = 0$ and the load does not act on $x2$, for $p = 0$ or $omega = 1$: friction takes energy whenever "
      "$x2$ moves and nothing gives it back, so no such motion obeys the law.",
      "$V = 0$ and a natural frequency is an odd multiple of $omega$: a motion that never sticks has two "
      "phases of half a period, whose friction drives that mode without end, so none closes.",
      "The orbits were searched for at the middle of the parameters; each is then proved for the whole box. "
      "Other orbits may exist elsewhere in the box.");
}

std::string remark_on_ur(const OrbitList& list) {
  std::vector<Ball> found;
  bool apart = true;
  for (const Orbit& orbit : list.orbits) {
    for (const NamedBall& value : orbit.values) {
      if (value.name == "ur" && !list.question.ur) {
        apart = apart && std::none_of(found.begin(), found.end(),
                                      [&](const Ball& other) { return other.overlaps(value.value); });
        found.push_back(value.value);
      }
    }
  }
  return found.size() < 2 ? ""
         : apart ? "Each of these orbits belongs to another $u_r$, which is a result: they are not orbits of "
                   "one machine."
                 : "$u_r$ is a result, and may be another for each of these orbits.";
}

std::string searched(const OrbitQuestion& q) {
  if (asks_for_box(q)) {
    return "the orbits at the middle of the parameters, each for all members of the box";
  }
  return q.family->searched(q);
}

std::string result_of_search(const OrbitList& list) {
  const auto good = std::ranges::count_if(list.orbits, families::is_admissible);
  const std::size_t at_middle = list.open_at_middle;
  std::vector<std::string> parts;
  if (!list.orbits.empty() || at_middle == 0) {
    parts.push_back(none_or_counted(list.orbits.size(), "orbit", "orbits"));
  }
  if (!list.orbits.empty()) {
    parts.push_back(fmt::format("{} admissible", good));
  }
  if (at_middle > 0) {
    parts.push_back(none_or_counted(at_middle, "orbit", "orbits") + " not proved for the whole box");
  }
  if (at_middle == 0 || at_middle < list.unresolved.size()) {
    parts.push_back(
        none_or_counted(list.unresolved.size() - at_middle, "unresolved box", "unresolved boxes"));
  }
  const char * completeness = asks_for_box(list.question) ? ""
                              : list.complete()           ? "complete: "
                                                          : "not complete: ";
  return fmt::format("{}{}", completeness, fmt::join(parts, ", "));
}

std::vector<std::string> decisive_conditions(const Orbit& orbit) {
  std::vector<std::string> ids;
  for (const Condition& condition : orbit.conditions) {
    if (condition.verdict.truth == orbit.admissible.truth) {
      ids.push_back(condition.id);
    }
  }
  return ids;
}

std::string verdict_on(const Orbit& orbit) {
  if (is_admissible(orbit)) {
    return "admissible";
  }
  const bool refuted = orbit.admissible.truth == Truth::refuted;
  const std::string split = orbit.split.empty() ? "" : fmt::format("; split {} first", orbit.split);
  return fmt::format("{}: {}{}", refuted ? "not admissible" : "undecided",
                     fmt::join(decisive_conditions(orbit), ", "), split);
}

std::string complex_text(const ComplexBall& mu, int digits) {
  const auto part = [digits](const Ball& b) { return to_string(b, known_digits(b, digits)); };
  const bool real = mu.im.is_exact() && mu.im.contains_zero();
  return real ? part(mu.re) : fmt::format("({}) + i ({})", part(mu.re), part(mu.im));
}

std::string meaning_of_margin() {
  return "the smallest distance from a violation, found at $t$; where the distance is zero at an end of its "
         "phase by construction, the smallest quotient of it and min(1, time to that end)";
}

std::string meaning_of_units(bool in_SI) {
  return in_SI ? "margins and their times t are in the units of the data taken"
               : "by (3), $x$, $z$, their rates of change, $V$, $p$, $u_s$, $u_r$ are lengths, all in one "
                 "unit; times and $omega$ have none; $phi$ is in radians";
}

std::string unit_of(const std::string& name) {
  return name == "phi" ? "rad" : "";
}

std::string latex_of_value(const std::string& name) {
  return name == "ur_max" ? "u_{r,\\max}" : symbolic::typeset::latex_name(name);
}

std::string latex_of_value(const std::string& name, const std::string& value) {
  const std::string unit = unit_of(name);
  return fmt::format("${} = {}${}{}", latex_of_value(name), value, unit.empty() ? "" : " ", unit);
}

std::string command_of(const OrbitQuestion& question) {
  return fmt::format("stickslip orbits {}{} --digits {}{}", question.family->name, options_of(question),
                     question.digits, question.neighbourhood ? " --neighbourhood" : "");
}

std::string command_of(const attractors::WordSearch& q) {
  const std::string near = q.near ? " --near=" + comma_separated(*q.near) : "";
  return fmt::format("stickslip orbits {} --period {}{}{} --digits {}", q.word.letters(), q.periods,
                     options_of(q.machine), near, q.machine.digits);
}

}  // namespace stickslip::report::orbits
