#include <fmt/format.h>

#include "core/decimal.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace tools;
using words::WordOrbit;
using words::WordQuestion;

namespace {

std::vector<BallText> durations(const WordOrbit& orbit, int digits) {
  std::vector<BallText> texts;
  for (const motion::Phase& phase : orbit.orbit.motion.phases) {
    texts.push_back(ball_text(phase.duration, digits));
  }
  return texts;
}

const Json like_durations = with({{"minItems", 2}}, "Of the phases, in the order of the word.");

void write_word_orbit(Object& json, const WordOrbit& o, int digits) {
  json.has("word", o.word.letters(), like_word());
  json.has("period", o.periods, like_periods());
  json.has("durations", durations(o, digits), like_durations);
  json.each(ball_texts(o.orbit.values, digits),
            {"Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10", "ur"});
  write_admissible(json, o.orbit.admissible);
  write_stability(json, o.orbit.stability, o.orbit.conditions, digits);
  std::vector<std::pair<motion::Condition, std::size_t>> conditions;
  for (std::size_t k = 0; k < o.orbit.conditions.size(); ++k) {
    conditions.emplace_back(o.orbit.conditions[k], o.asked[k].phase + 1);
  }
  json.list("conditions", conditions,
            [](Object& to, const auto& condition) {
              write_condition(to, condition.first);
              to.has("phase", condition.second, with({{"minimum", 1}}, "Of the word, from 1."));
            },
            {{"minItems", 1}});
  write_neighbourhood(json, o.orbit.neighbourhood);
}

}  // namespace

Json like_word() {
  return with(
      {{"pattern", "^[OST]{2,}$"}},
      "The phases of a period in their order, in the rotation that comes first in the alphabet: S slip, "
      "O overshoot, T stick.");
}

Json like_periods() {
  return with({{"minimum", 1}}, "In periods of the load.");
}

void write_parameters(Object& json, const WordQuestion& q) {
  json.object("parameters", [&](Object& to) {
    to.each(named_parameters(q), {"chi", "eta", "us", "V", "omega", "p", "ur"});
  });
}

void write_attractor(Object& json, const Attractor& a, int digits, Share share) {
  json.has("kind", a.kind, names_through(Kind::unsettled));
  if (share == Share::told) {
    json.has("share", a.share, {{"minimum", 0}, {"maximum", 1}});
    json.has("share_interval", std::array{a.least, a.most},
             with({{"items", {{"type", "number"}, {"minimum", 0}, {"maximum", 1}}}},
                  "Wilson's interval of 95 %."));
    json.has("count", a.count, with({{"minimum", 1}}, "Of the starts."));
  }
  json.has("state", a.state, "x1, x2, x1', x2' of a simulated motion when the load's phase is 0.");
  json.has("lyapunov", a.lyapunov, "Per period of the load, in the mean over the starts: a check, no proof.");
  json.keys_if(
      a.kind == Kind::periodic ? std::optional(a) : std::nullopt, [digits](Object& to, const Attractor& one) {
        to.has("period", one.periods, like_periods());
        to.has("word", one.word, like_word());
        const Verdict existence = one.orbit ? one.orbit->existence : Verdict::undecided("no proof was tried");
        to.has("verdict", existence.truth);
        to.has("reason", if_any(existence.reason));
        to.keys_if(existence.truth == Truth::proved ? one.orbit : std::nullopt, [&](Object& proved,
                                                                                    const WordOrbit& o) {
          proved.has("durations", durations(o, digits), like_durations);
          write_admissible(proved, o.orbit.admissible);
          proved.has("family", one.family.empty() ? std::nullopt : std::optional(one.family), family_names());
          write_stability(proved, o.orbit.stability, o.orbit.conditions, digits);
          write_neighbourhood(proved, o.orbit.neighbourhood);
        });
      });
  json.rules({{"if", {{"properties", {{"kind", {{"const", to_string(Kind::periodic)}}}}}}},
              {"then", {{"required", {"period", "word", "verdict"}}}}});
}

namespace {

void write_attractors(Object& json, const AttractorList& list) {
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
            [&](Object& to, const Attractor& a) { write_attractor(to, a, q.machine.digits); });
}

void write_words(Object& json, const WordOrbits& list) {
  const WordSearch& q = list.question;
  const int digits = q.machine.digits;
  write_origin(json, command_of(q));
  json.has("word", q.word.letters(), like_word());
  json.has("period", q.periods, like_periods());
  write_parameters(json, q.machine);
  json.has("complete", list.complete(), "No orbit of the word in so many periods is missing.");
  json.list("unresolved", list.unresolved, [digits](Object& to, const families::Unresolved& part) {
    to.each(ball_texts(part.where, digits), {"tau"}, {"tau1", "tau2", "phi"});
    to.has("reason", plain(part.reason));
  });
  json.list("orbits", list.orbits,
            [digits](Object& to, const WordOrbit& o) { write_word_orbit(to, o, digits); });
  json.has("seen", list.seen.empty() ? std::nullopt : std::optional(list.seen),
           "What a simulation met in place of an orbit of the word.");
}

}  // namespace

Json to_json(const AttractorList& list) {
  return written(list, write_attractors);
}

Json to_json(const WordOrbits& list) {
  return written(list, write_words);
}

Json schema_of_attractors() {
  AttractorList sample;
  sample.question.machine = SampleOf<WordQuestion>::made();
  return schema_by(sample, write_attractors);
}

File words_schema() {
  const WordOrbits sample{{SampleOf<WordQuestion>::made(), words::Word::parse("OTS"), 1, {}}, {}, {}};
  return schema_file("words", "stickslip orbits WORD: orbits through given phases, each proved",
                     schema_by(sample, write_words));
}

std::string command_of(const AttractorQuestion& q) {
  return fmt::format("stickslip attractors{} --starts {} --seed {} --most-periods {} --digits {}{}",
                     options_of(q.machine), q.starts, q.seed, q.most_periods, q.machine.digits,
                     q.neighbourhood ? " --neighbourhood" : "");
}

std::string command_of(const WordSearch& q) {
  const std::string near = q.near ? fmt::format(" --near={:.17g},{:.17g},{:.17g},{:.17g}", (*q.near)(0),
                                                (*q.near)(1), (*q.near)(2), (*q.near)(3))
                                  : "";
  return fmt::format("stickslip orbits {} --period {}{}{} --digits {}{}", q.word.letters(), q.periods,
                     options_of(q.machine), near, q.machine.digits,
                     q.neighbourhood ? " --neighbourhood" : "");
}

}  // namespace stickslip::report::orbits
