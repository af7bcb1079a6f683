#include <fmt/format.h>

#include "core/decimal.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/many_starts.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace tools;
using words::WordOrbit;
using words::WordQuestion;

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

}  // namespace

Json to_json(const AttractorList& list, const Units& units) {
  return written(list, in_units(write_attractors, units));
}

Json schema_of_attractors() {
  AttractorList sample;
  sample.question.machine = SampleOf<WordQuestion>::made();
  return schema_by(sample, in_units(write_attractors));
}

std::string command_of(const AttractorQuestion& q) {
  return fmt::format("stickslip attractors{} --starts {} --seed {} --most-periods {} --digits {}{}",
                     options_of(q.machine), q.starts, q.seed, q.most_periods, q.machine.digits,
                     q.neighbourhood ? " --neighbourhood" : "");
}

}  // namespace stickslip::report::orbits
