#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "numeric/motion/contact.hpp"
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

Json parameters(const OrbitQuestion& question) {
  Json json = Json::object();
  for (const NamedRange& parameter : named_parameters(question)) {
    json[parameter.name] = notation(parameter.range);
  }
  return json;
}

}  // namespace

Json to_json(const Ball& value, int digits) {
  const BallText text = to_text(value, known_digits(value, digits));
  return {{"mid", text.mid}, {"rad", text.rad}};
}

void add_values(Json& json, const std::vector<NamedBall>& values, int digits) {
  for (const NamedBall& value : values) {
    json[value.name] = to_json(value.value, digits);
  }
}

Json to_json(const Unresolved& part, int digits) {
  Json json = Json::object();
  add_values(json, part.where, digits);
  json["reason"] = plain(part.reason);
  return json;
}

Json to_json(const Condition& c) {
  Json json = {{"id", c.id}, {"statement", plain(c.statement)}, {"verdict", to_string(c.verdict.truth)}};
  if (!c.verdict.reason.empty()) {
    json["reason"] = plain(c.verdict.reason);
  }
  if (c.margin && c.margin->is_finite()) {
    json["margin"] = to_json(*c.margin, margin_digits);
  }
  if (c.at && c.at->is_finite()) {
    json["at"] = to_json(*c.at, margin_digits);
  }
  return json;
}

Json to_json(const Verdict& admissible) {
  return admissible.truth == Truth::proved    ? Json(true)
         : admissible.truth == Truth::refuted ? Json(false)
                                              : Json(nullptr);
}

void add_stability(Json& json, const Orbit& orbit, int digits) {
  const std::optional<Stability>& stability = orbit.stability;
  if (!stability) {
    return;
  }
  json["multipliers"] = list_of(stability->multipliers, [digits](const ComplexBall& mu) -> Json {
    return {{"re", to_json(mu.re, digits)}, {"im", to_json(mu.im, digits)}};
  });
  json["stability"] = to_string(stability->kind);
  if (!stability->reason.empty()) {
    json["stability_reason"] = plain(stability->reason);
  }
  const std::optional<Contact> contact = contact_of(orbit.conditions);
  if (stability->kind == StabilityKind::stable && contact) {
    json["contact"] = {{"condition", contact->condition},
                       {"margin", to_json(contact->margin, digits)},
                       {"at", to_json(contact->at, digits)}};
  }
}

namespace {

Json orbit(const Orbit& o, int digits) {
  Json json = Json::object();
  add_values(json, o.values, digits);
  json["admissible"] = to_json(o.admissible);
  if (!o.split.empty()) {
    json["split"] = o.split;
  }
  add_stability(json, o, digits);
  json["conditions"] = list_of(o.conditions, [](const Condition& c) { return to_json(c); });
  return json;
}

}  // namespace

Json to_json(const OrbitList& list) {
  const int digits = list.question.digits;
  Json json = provenance(command_of(list.question));
  json["family"] = list.question.family->name;
  json["parameters"] = parameters(list.question);
  json["complete"] = list.complete();
  json["unresolved"] =
      list_of(list.unresolved, [digits](const Unresolved& part) { return to_json(part, digits); });
  if (!list.remarks.empty()) {
    json["remarks"] = list_of(list.remarks, [](Remark remark) { return plain(describe(remark)); });
  }
  json["orbits"] = list_of(list.orbits, [digits](const Orbit& o) { return orbit(o, digits); });
  return json;
}

}  // namespace stickslip::report::orbits
