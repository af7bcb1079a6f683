#include "numeric/families/family.hpp"
#include "numeric/motion/contact.hpp"
#include "report/orbits/neighbourhood.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/orbits.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;

namespace {

// Digits of margins and of their times: as many as a reader may want, however many the orbit has.
constexpr int margin_digits = 20;

void write_orbit(Object& json, const Orbit& o, const OrbitQuestion& question) {
  const int digits = question.digits;
  json.each(ball_texts(o.values, digits),
            {"tau", "Theta", "phi", "z10", "z20", "zdot10", "x10", "x20", "xdot10"},
            {"tau1", "T", "ur", "ur_max"});
  json.rules({{"oneOf", {{{"required", {"ur"}}}, {{"required", {"ur_max"}}}}}});
  write_admissible(json, o.admissible);
  json.has("split", o.split.empty() ? std::nullopt : std::optional(o.split),
           "For a box of parameters, the one to divide first.");
  write_stability(json, o.stability, o.conditions, digits);
  json.list("conditions", o.conditions, write_condition, {{"minItems", 1}});
  write_neighbourhood(json, question, o);
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
  const bool known = admissible.truth == Truth::proved || admissible.truth == Truth::refuted;
  json.has_as("admissible", known ? Json(admissible.truth == Truth::proved) : Json(nullptr),
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
        "may "
        "lead to another motion.");
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
  json.list(
      "unresolved", list.unresolved,
      [&](Object& to, const Unresolved& part) {
        to.each(ball_texts(part.where, q.digits));
        to.has("reason", plain(part.reason));
      },
      "Parts of the domain that the search could not decide.");
  std::optional<std::vector<std::string>> remarks;
  for (const Remark remark : list.remarks) {
    (remarks ? *remarks : remarks.emplace()).push_back(plain(describe(remark)));
  }
  json.has("remarks", remarks);
  json.list("orbits", list.orbits, [&](Object& to, const Orbit& o) { write_orbit(to, o, q); });
}

Json to_json(const Condition& condition) {
  return written(condition, write_condition);
}

Json to_json(const OrbitList& list) {
  return written(list, write_orbits);
}

File orbits_schema() {
  return schema_file("orbits", "stickslip orbits: all periodic orbits of a family, each proved",
                     schema_by(SampleOf<OrbitList>::made(), write_orbits));
}

}  // namespace stickslip::report::orbits
