#include "numeric/families/family.hpp"
#include "numeric/motion/stability.hpp"
#include "report/orbits/attractors/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;
using attractors::WordOrbits;
using words::WordOrbit;

namespace {

// Digits of margins and of their times: as many as a reader may want, however many the orbit has.
constexpr int margin_digits = 20;

// What orbits of lists have; `always` and `sometimes` are names of their values.
void write_orbit(Object& json, const Orbit& o, int digits, const Units& units,
                 const std::vector<std::string>& always, const std::vector<std::string>& sometimes) {
  Named<BallText> values;
  for (const NamedBall& value : o.values) {
    values.emplace_back(value.name, ball_text(units.value(value, digits), digits));
  }
  json.each(values, always, sometimes);
  write_admissible(json, o.admissible);
  write_stability(json, o.stability, o.conditions, digits);
}

void write_family_orbit(Object& json, const Orbit& o, const OrbitQuestion& question) {
  const int digits = question.digits;
  write_orbit(json, o, digits, {}, {"tau", "Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10"},
              {"tau1", "T", "ur", "ur_max"});
  json.rules({{"oneOf", {{{"required", {"ur"}}}, {{"required", {"ur_max"}}}}}});
  json.has("split", o.split.empty() ? std::nullopt : std::optional(o.split),
           "For a box of parameters, the one to divide first.");
  json.list("conditions", o.conditions, write_condition, {{"minItems", 1}});
  write_neighbourhood(json, question, o);
}

void write_word_orbit(Object& json, const WordOrbit& o, int digits, const Units& units) {
  json.has("word", o.word.letters(), like_word());
  json.has("period", o.periods, like_periods());
  write_durations(json, o.orbit.motion, digits, units);
  write_orbit(json, o.orbit, digits, units,
              {"Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10", "ur"}, {});
  std::vector<std::pair<Condition, std::size_t>> conditions;
  for (std::size_t k = 0; k < o.orbit.conditions.size(); ++k) {
    conditions.emplace_back(o.orbit.conditions[k], o.asked[k].phase + 1);
  }
  json.list("conditions", conditions,
            [](Object& to, const auto& condition) {
              write_condition(to, condition.first);
              to.has("phase", condition.second, with({{"minimum", 1}}, "Of the word, from 1."));
            },
            {{"minItems", 1}});
  write_neighbourhood(json, o.orbit.neighbourhood, units);
}

void write_unresolved(Object& json, const std::vector<Unresolved>& parts, int digits,
                      const std::vector<std::string>& always = {},
                      const std::vector<std::string>& sometimes = {}) {
  json.list(
      "unresolved", parts,
      [&](Object& to, const Unresolved& part) {
        to.each(ball_texts(part.where, digits), always, sometimes);
        to.has("reason", plain(part.reason));
      },
      "Parts of the domain that the search could not decide.");
}

void write_words(Object& json, const WordOrbits& list, const Units& units) {
  const attractors::WordSearch& q = list.question;
  const int digits = q.machine.digits;
  write_origin(json, command_of(q));
  json.has("word", q.word.letters(), like_word());
  json.has("period", q.periods, like_periods());
  write_parameters(json, q.machine);
  json.has("complete", list.complete(), "No orbit of the word in so many periods is missing.");
  write_unresolved(json, list.unresolved, digits, {"tau"}, {"tau1", "tau2", "phi"});
  json.list("orbits", list.orbits,
            [&](Object& to, const WordOrbit& o) { write_word_orbit(to, o, digits, units); });
  json.has("seen", list.seen.empty() ? std::nullopt : std::optional(list.seen),
           "What a simulation met in place of an orbit of the word.");
}

}  // namespace

BallText ball_text(const Ball& value, int digits) {
  return to_text(value, known_digits(value, digits));
}

std::optional<BallText> ball_text(const std::optional<Ball>& value, int digits) {
  return value && value->is_finite() ? std::optional(ball_text(*value, digits)) : std::nullopt;
}

Named<BallText> ball_texts(const std::vector<NamedBall>& values, int digits) {
  Named<BallText> texts;
  for (const NamedBall& value : values) {
    texts.emplace_back(value.name, ball_text(value.value, digits));
  }
  return texts;
}

std::optional<std::string> if_any(const std::string& sentence) {
  return sentence.empty() ? std::nullopt : std::optional(plain(sentence));
}

Json family_names() {
  std::vector<std::string> names;
  for (const Family * family : all_families()) {
    names.push_back(family->name);
  }
  return one_of(names);
}

Json like_number_or_range() {
  return with({{"pattern", "^-?[0-9]+(\\.[0-9]+|/[0-9]+)?(\\+-[0-9]+(\\.[0-9]+|/[0-9]+)?)?$"}},
              "An exact number, or an interval written middle+-half width.");
}

Json like_word() {
  return with(
      {{"pattern", "^[OST]{2,}$"}},
      "The phases of a period in their order, in the rotation that comes first in the alphabet: S slip, "
      "O overshoot, T stick.");
}

Json like_periods() {
  return with({{"minimum", 1}}, "In periods of the load.");
}

void write_parameters(Object& json, const words::WordQuestion& q) {
  json.object("parameters", [&](Object& to) {
    to.each(named_parameters(q), {"chi", "eta", "us", "V", "omega", "p", "ur"});
  });
}

void write_durations(Object& json, const Motion& motion, int digits, const Units& units) {
  std::vector<BallText> texts;
  for (const Phase& phase : motion.phases) {
    texts.push_back(ball_text(units.time(phase.duration, digits), digits));
  }
  json.has("durations", texts, with({{"minItems", 2}}, "Of the phases, in the order of the word."));
}

void write_origin(Object& json, const std::string& command) {
  write_provenance(json, command);
  json.may_have<DataTaken>(
      "machine", write_machine,
      "The machine in SI units that the parameters are taken for, and what their units are in SI.");
}

void write_condition(Object& json, const Condition& c) {
  json.has("id", c.id);
  json.has("statement", plain(c.statement));
  json.has("verdict", c.verdict.truth);
  json.has("reason", if_any(c.verdict.reason));
  json.has("margin", ball_text(c.margin, margin_digits));
  json.has("at", ball_text(c.at, margin_digits));
}

void write_admissible(Object& json, const Verdict& admissible) {
  json.has_as("admissible", admissible.is_decided() ? Json(admissible.truth == Truth::proved) : Json(nullptr),
              {{"type", {"boolean", "null"}}}, "Whether every condition holds; null when that is undecided.");
}

void write_stability(Object& json, const std::optional<Stability>& known,
                     const std::vector<Condition>& conditions, int digits) {
  json.keys_if(known, [&](Object& to, const Stability& stability) {
    const auto multiplier = [digits](Object& one, const ComplexBall& mu) {
      one.has("re", ball_text(mu.re, digits));
      one.has("im", ball_text(mu.im, digits));
    };
    to.list("multipliers", stability.multipliers, multiplier, "Floquet multipliers.");
    to.has(
        "stability", stability.kind,
        with(names_through(StabilityKind::undecided), "Of an admissible orbit, by its Floquet multipliers."));
    to.has("stability_reason", if_any(stability.reason));
    const bool stable = stability.kind == StabilityKind::stable;
    to.object_if(
        "contact", stable ? contact_of(conditions) : std::nullopt,
        [digits](Object& near, const Contact& contact) {
          near.has("condition", contact.condition);
          near.has("margin", ball_text(contact.margin, digits));
          near.has("at", ball_text(contact.at, digits));
        },
        "Of a stable orbit the condition that is nearest to a violation: a disturbance that reaches as far "
        "may lead to another motion.");
  });
}

void write_orbits(Object& json, const OrbitList& list) {
  const OrbitQuestion& q = list.question;
  write_origin(json, command_of(q));
  json.has("family", q.family->name, family_names());
  json.object("parameters", [&](Object& to) {
    Named<std::string> parameters;
    for (const auto& [name, range] : named_parameters(q)) {
      parameters.emplace_back(name, notation(range));
    }
    to.each(parameters, {"chi", "eta", "us", "V", "omega", "p"}, {"phi", "ur"}, like_number_or_range());
  });
  json.has("complete", list.complete(), "No orbit of the family is missing.");
  write_unresolved(json, list.unresolved, q.digits);
  std::optional<std::vector<std::string>> remarks;
  for (const Remark remark : list.remarks) {
    (remarks ? *remarks : remarks.emplace()).push_back(plain(describe(remark)));
  }
  json.has("remarks", remarks);
  json.list("orbits", list.orbits, [&](Object& to, const Orbit& o) { write_family_orbit(to, o, q); });
}

Json to_json(const Condition& condition) {
  return written(condition, write_condition);
}

Json to_json(const OrbitList& list) {
  return written(list, write_orbits);
}

Json to_json(const WordOrbits& list, const Units& units) {
  return written(list, in_units(write_words, units));
}

File orbits_schema() {
  return schema_file("orbits", "stickslip orbits: all periodic orbits of a family, each proved",
                     schema_by(SampleOf<OrbitList>::made(), write_orbits));
}

File words_schema() {
  const WordOrbits sample{{SampleOf<words::WordQuestion>::made(), words::Word::parse("OTS"), 1, {}}, {}, {}};
  return schema_file("words", "stickslip orbits WORD: orbits through given phases, each proved",
                     schema_by(sample, in_units(write_words)));
}

}  // namespace stickslip::report::orbits
