#include "report/orbits/attractors/attractors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/decimal.hpp"
#include "numeric/words/pure.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"
#include "report/tools/prose.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace numeric::motion;
using namespace tools;
using words::WordOrbit;
using words::WordQuestion;

std::string spectral_radius(const Stability& s) {
  Ball largest(0);
  for (const ComplexBall& mu : s.multipliers) {
    const Ball modulus = sqrt(mu.squared_modulus().upper());
    arb_max(largest.raw(), largest.raw(), modulus.raw(), WorkingPrecision::bits());
  }
  const double radius = largest.upper().approximate();
  std::string text = "1";
  for (int digits = 4; text == "1" && digits <= 17; ++digits) {
    text = fmt::format("{:.{}g}", radius, digits);
  }
  return text;
}

std::vector<Condition> worst(const std::vector<Condition>& conditions) {
  const auto badness = [](const Condition& c) {
    return c.verdict.truth == Truth::refuted ? 2 : c.verdict.truth == Truth::proved ? 0 : 1;
  };
  const auto is_worse = [&](const Condition& a, const Condition& b) {
    if (badness(a) != badness(b)) {
      return badness(a) > badness(b);
    }
    return a.margin && b.margin && (*b.margin - *a.margin).is_positive();
  };
  std::vector<Condition> result;
  for (const Condition& c : conditions) {
    const auto same =
        std::find_if(result.begin(), result.end(), [&](const Condition& r) { return r.id == c.id; });
    if (same == result.end()) {
      result.push_back(c);
    } else if (is_worse(c, *same)) {
      *same = c;
    }
  }
  return result;
}

std::string remark(const Attractor& a) {
  if (a.kind != Kind::periodic) {
    return remark_on_others(a);
  }
  if (!a.orbit) {
    return "not proved";
  }
  const families::Orbit& o = a.orbit->orbit;
  return remark_on_periodic(a.orbit->existence, o.admissible, verdict_on(o), o.stability) +
         (a.family.empty() ? "" : ", " + a.family);
}

std::string state_of(const model::Vector4<double>& X) {
  return fmt::format("{:.10g},{:.10g},{:.10g},{:.10g}", X(0), X(1), X(2), X(3));
}

std::string shortened(const std::string& word) {
  constexpr std::size_t most = 18;
  return word.size() <= most ? word : fmt::format("{}... ({})", word.substr(0, most), word.size());
}

std::string in_words(const Attractor& a) {
  if (a.kind != Kind::periodic) {
    return fmt::format("{}: {}", to_string(a.kind), remark(a));
  }
  return fmt::format("{} with the period {}: {}", shortened(a.word), a.periods, remark(a));
}

std::vector<Row> rows_of(const AttractorList& list) {
  const AttractorQuestion& q = list.question;
  std::vector<Row> head{
      {{"parameters"}, {parameter_list(q.machine)}},
      {{"starts"},
       {fmt::format("{}; {} periods in all{}", starts_in_words(q.starts, q.seed, q.most_periods, true),
                    list.simulated, interruption_in_words(list.interrupted, list.followed))}}};
  if (const words::PureSlip slip = words::pure_slip(q.machine.data); slip.exists.truth == Truth::proved) {
    head.push_back(
        {{"pure slip"},
         {fmt::format("proved: motions never touch the belt if the amplitudes of the two free oscillations "
                      "of x2' add up to less than V - |q2| omega = {}; they are neutral, not stable",
                      rounded(Ball(q.machine.data.V) - slip.forced, 4))}});
  }
  if (words::pure_stick(q.machine.data, q.machine.ur).truth == Truth::proved) {
    head.push_back(
        {{"pure stick"},
         {fmt::format("proved: mass 2 rests on the belt for ever where chi (1 - chi) |x2| + chi a < "
                      "ur - p/eta = {}, a the amplitude of x1 - chi x2",
                      to_string(Rational(q.machine.ur - q.machine.data.p / q.machine.data.eta)))}});
  }
  return head;
}

std::string terminal_report(const AttractorList& list, const Style& style, const Units& units) {
  const std::vector<ToldEnding> all = told(list.attractors);
  const std::string recover = neighbourhoods_of(all, coordinates_in(units), style);
  std::vector<Row> rows{
      {{"   "}, {fmt::format("x1,x2,x1',x2'{} at load phase 0", units.are_SI() ? " in m and m/s" : "")}}};
  for (std::size_t i = 0; i < list.attractors.size(); ++i) {
    rows.push_back({{std::to_string(i + 1)}, {state_of(units.state(list.attractors[i].state))}});
  }
  return headed("What the machine does", rows_of(list), style) + "\n" +
         table_of(all, "period", WithInterval::yes, style) + recover + "\n" + columns_of(rows, style.width) +
         "\n" +
         labelled(0, "share",
                  "of the starts, with Wilson's interval of 95 %; what is said to be proved is; everything "
                  "else is a check in floating point",
                  style.width) +
         (recover.empty() ? "" : labelled(0, "recovers", meaning_of_neighbourhood(), style.width));
}

namespace {

// Along a parameter in SI units, each value has its own.
Units units_of(const DiagramPoint& point, const Units& units) {
  return point.taken ? Units(*point.taken) : units;
}

// The data except for the one that varies.
std::string others(const DiagramQuestion& q) {
  auto all = named_parameters(q.machine.machine);
  std::erase_if(all, [&](const auto& one) { return one.first == q.parameter; });
  return parameter_list(all);
}

std::array<std::string, 2> plane_of(const BasinsQuestion& q) {
  const std::vector<Coordinate> all = coordinates_in({});
  return {all[static_cast<std::size_t>(q.across[0])].name, all[static_cast<std::size_t>(q.across[1])].name};
}

}  // namespace

std::vector<ToldEnding> told(const std::vector<Attractor>& all) {
  std::vector<ToldEnding> endings;
  for (const Attractor& a : all) {
    const std::string period = a.kind == Kind::periodic ? std::to_string(a.periods) : "";
    endings.push_back({static_cast<const Ending&>(a), short_name(a), period, remark(a), {}, {}});
    if (a.orbit) {
      endings.back().neighbourhood = a.orbit->orbit.neighbourhood;
      endings.back().stability = a.orbit->orbit.stability;
    }
  }
  return endings;
}

ToldAlong told(const Diagram& d, const Units& units) {
  const DiagramQuestion& q = d.question;
  const Units first = d.points.empty() ? units : units_of(d.points.front(), units);
  ToldAlong result{{{{{"parameters"}, {q.taken ? "of the machine, except for " + q.parameter : others(q)}}},
                    q.taken ? first.machine_or("the machine", q.parameter) : in_greek(others(q)),
                    coordinates_in(first),
                    1},
                   q.parameter,
                   q.parameter + (q.taken ? in_unit_of(q.parameter) : ""),
                   q.from,
                   q.to,
                   q.values,
                   q.machine.starts,
                   q.machine.seed,
                   {},
                   d.interrupted};
  for (const DiagramPoint& point : d.points) {
    const std::vector<Coordinate> here = coordinates_in(units_of(point, units));
    result.points.push_back({point.value, point.outside, told(point.attractors), {}});
    for (const auto& states : point.once) {
      result.points.back().once.emplace_back();
      for (const model::Vector4<double>& X : states) {
        result.points.back().once.back().push_back(told(X, here));
      }
    }
  }
  return result;
}

ToldPlane told(const Basins& b, const Units& units) {
  const std::string data = parameter_list(b.question.machine.machine);
  ToldPlane result{{{{{"parameters"}, {data}}}, units.machine_or(in_greek(data)), coordinates_in(units), 1},
                   b.question.across,
                   b.question.pixels,
                   {},
                   told(b.attractors),
                   b.at};
  for (const model::Vector4<double>& X : b.starts) {
    result.starts.push_back(told(X, result.oscillator.coordinates));
  }
  result.interrupted = b.interrupted;
  return result;
}

void write_attractor(Object& json, const Attractor& a, int digits, const Units& units, Share share) {
  json.has("kind", a.kind, names_through(Kind::unsettled));
  if (share == Share::told) {
    write_share(json, a);
  }
  json.has("state", units.state(a.state),
           "x1, x2, x1', x2' of a simulated motion when the load's phase is 0.");
  write_lyapunov(json, a);
  json.keys_if(
      a.kind == Kind::periodic ? std::optional(a) : std::nullopt, [&](Object& to, const Attractor& one) {
        to.has("period", one.periods, like_periods());
        to.has("word", one.word, like_word());
        const Verdict existence = one.orbit ? one.orbit->existence : Verdict::undecided("no proof was tried");
        to.has("verdict", existence.truth);
        to.has("reason", if_any(existence.reason));
        to.keys_if(existence.truth == Truth::proved ? one.orbit : std::nullopt, [&](Object& proved,
                                                                                    const WordOrbit& o) {
          write_durations(proved, o.orbit.motion, digits, units);
          write_admissible(proved, o.orbit.admissible);
          proved.has("family", one.family.empty() ? std::nullopt : std::optional(one.family), family_names());
          write_stability(proved, o.orbit.stability, o.orbit.conditions, digits);
          write_neighbourhood(proved, o.orbit.neighbourhood, units);
        });
      });
  json.rules({{"if", {{"properties", {{"kind", {{"const", to_string(Kind::periodic)}}}}}}},
              {"then", {{"required", {"period", "word", "verdict"}}}}});
}

namespace {

void write_attractors(Object& json, const AttractorList& list, const Units& units) {
  const AttractorQuestion& q = list.question;
  write_origin(json, command_of(q));
  write_parameters(json, q.machine);
  json.has("starts", q.starts, {{"minimum", 1}});
  json.has("seed", q.seed);
  json.has("most_periods", q.most_periods, {{"minimum", 1}});
  json.has("simulated", list.simulated,
           with({{"minimum", 0}}, "Periods of the load, of all starts together."));
  json.has("interrupted", list.interrupted, "Fewer points or starts than were asked for.");
  json.has(
      "followed", list.followed,
      with({{"minimum", 0}},
           "Starts that have settled or went through most_periods: all, unless it was interrupted. Shares "
           "are of these."));
  const words::PureSlip slip = words::pure_slip(q.machine.data);
  json.object_if(
      "pure_slip", slip.forced.is_finite() ? std::optional(slip) : std::nullopt,  // not at resonance
      [&](Object& to, const words::PureSlip& known) {
        to.has("forced", ball_text(known.forced, q.machine.digits));
        to.has("verdict", known.exists.truth);
      },
      "Whether some motions are proved to slip for ever: where the speed |q2| omega that the load forces is "
      "below V. Absent where omega is a natural frequency.");
  json.list("attractors", list.attractors,
            [&](Object& to, const Attractor& a) { write_attractor(to, a, q.machine.digits, units); });
}

void write_diagram(Object& json, const Diagram& d, const Units& units) {
  const DiagramQuestion& q = d.question;
  write_origin(json, command_of(q));
  json.has("along", q.parameter, one_of({"chi", "eta", "us", "V", "omega", "p", "ur"}));
  write_parameters(json, q.machine.machine);
  json.has("starts", q.machine.starts, {{"minimum", 1}});
  json.has("seed", q.machine.seed);
  json.has("most_periods", q.machine.most_periods, {{"minimum", 1}});
  json.has("interrupted", d.interrupted, "Fewer points than were asked for.");
  std::vector<DiagramPoint> points = d.points;
  for (DiagramPoint& point : points) {
    for (auto& states : point.once) {
      std::ranges::transform(states, states.begin(),
                             [here = units_of(point, units)](const auto& X) { return here.state(X); });
    }
  }
  write_points(json, points, "States when the load's phase is 0, one period apart.",
               [&](Object& one, const Attractor& a, const DiagramPoint& point) {
                 write_attractor(one, a, q.machine.machine.digits, units_of(point, units));
               });
}

void write_basins(Object& json, const Basins& b, const Units& units) {
  const BasinsQuestion& q = b.question;
  write_origin(json, command_of(q));
  json.has("plane", plane_of(q), {{"items", one_of({"x1", "x2", "x1'", "x2'"})}, {"uniqueItems", true}});
  write_pixels(json, q.pixels, std::array{units.state(b.starts.front()), units.state(b.starts.back())});
  write_parameters(json, q.machine.machine);
  json.has("most_periods", q.machine.most_periods, {{"minimum", 1}});
  json.has("interrupted", b.interrupted, "Fewer starts than were asked for.");
  json.list("attractors", b.attractors,
            [&](Object& to, const Attractor& a) { write_attractor(to, a, q.machine.machine.digits, units); });
  write_ends(json, b.at, q.pixels[0]);
}

}  // namespace

Json to_json(const AttractorList& list, const Units& units) {
  return written(list, in_units(write_attractors, units));
}

Json to_json(const Diagram& d, const Units& units) {
  return written(d, in_units(write_diagram, units));
}

Json to_json(const Basins& b, const Units& units) {
  return written(b, in_units(write_basins, units));
}

File attractors_schema() {
  AttractorList from_starts;
  Diagram along;
  Basins plane;
  from_starts.question.machine = along.question.machine.machine = plane.question.machine.machine =
      SampleOf<WordQuestion>::made();
  plane.starts = {model::Vector4<double>::Zero()};
  return schema_file(
      "attractors", "stickslip attractors: what a machine does; with --along, with --plane",
      one_of_schemas({schema_by(from_starts, in_units(write_attractors)),
                      schema_by(along, in_units(write_diagram)), schema_by(plane, in_units(write_basins))}));
}

std::string command_of(const AttractorQuestion& q) {
  return fmt::format("stickslip attractors{} --starts {} --seed {} --most-periods {} --digits {}{}",
                     options_of(q.machine), q.starts, q.seed, q.most_periods, q.machine.digits,
                     q.neighbourhood ? " --neighbourhood" : "");
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
  return fmt::format("stickslip attractors{} --plane \"{},{}\" --pixels {}{} --most-periods {}",
                     options_of(q.machine.machine), plane_of(q)[0], plane_of(q)[1], q.pixels[0], through,
                     q.machine.most_periods);
}

}  // namespace stickslip::report::orbits
