#include "report/orbits/orbit_data.hpp"

#include "numeric/families/family.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/numbers.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::motion;
using namespace tools;

namespace {

constexpr int short_digits = 15;
constexpr int multiplier_digits = 8;

std::string latex_of(const Range& range) {
  std::string text = notation(range);
  const std::size_t sign = text.find("+-");
  return sign == std::string::npos ? text : text.replace(sign, 2, "\\pm ");
}

Json value(const NamedBall& named, int digits) {
  const BallText text = to_text(named.value, known_digits(named.value, digits));
  return {{"latex", latex_of_value(named.name)},
          {"mid", text.mid},
          {"rad", text.rad},
          {"unit", unit_of(named.name)},
          {"short", to_string(named.value, known_digits(named.value, std::min(digits, short_digits)))}};
}

Json condition(const Condition& c) {
  const bool decided = c.verdict.truth == Truth::proved || c.verdict.truth == Truth::refuted;
  return {{"id", c.id},
          {"statement", c.statement},
          {"verdict", to_string(c.verdict.truth)},
          {"verdict_words", spaced(to_string(c.verdict.truth))},
          {"margin", shown(c.margin)},
          {"at", shown(c.at)},
          {"reason_if_open", decided ? Json(nullptr) : Json(c.verdict.reason)}};
}

void add_stability(Json& json, const std::optional<Stability>& stability) {
  json["stability"] = nullptr;
  json["multipliers"] = Json::array();
  if (!stability) {
    return;
  }
  json["stability"] = {{"kind", to_string(stability->kind)}, {"reason", stability->reason}};
  for (const ComplexBall& mu : stability->multipliers) {
    json["multipliers"].push_back(complex_text(mu, multiplier_digits));
  }
}

Json orbit(const OrbitList& list, std::size_t i) {
  const Orbit& o = list.orbits[i];
  Json json = {{"number", i + 1},
               {"total", list.orbits.size()},
               {"verdict", to_string(o.admissible.truth)},
               {"tell", verdict_on(o)},
               {"split", o.split.empty() ? Json(nullptr) : Json(o.split)},
               {"split_latex", latex_of_value(o.split)},
               {"values", Json::array()},
               {"conditions", Json::array()}};
  for (const NamedBall& named : o.values) {
    json["values"].push_back(value(named, list.question.digits));
  }
  add_stability(json, o.stability);
  for (const Condition& c : o.conditions) {
    json["conditions"].push_back(condition(c));
  }
  return json;
}

Json unresolved(const Unresolved& part) {
  Json where = Json::array();
  for (const NamedBall& named : part.where) {
    where.push_back({{"latex", latex_of_value(named.name)}, {"value", to_string(named.value, 8)}});
  }
  return {{"where", where}, {"reason", part.reason}};
}

}  // namespace

Json orbit_data(const OrbitList& list) {
  Json json = {{"title", list.question.family->title}, {"searched", searched(list.question)},
               {"result", result_of_search(list)},     {"command", command_of(list.question)},
               {"parameters", Json::array()},          {"remarks", Json::array()},
               {"unresolved", Json::array()},          {"orbits", Json::array()}};
  for (const NamedRange& parameter : named_parameters(list.question)) {
    json["parameters"].push_back(
        {{"latex", latex_of_value(parameter.name)}, {"value_latex", latex_of(parameter.range)}});
  }
  for (const Remark remark : list.remarks) {
    json["remarks"].push_back(describe(remark));
  }
  if (const std::string on_ur = remark_on_ur(list); !on_ur.empty()) {
    json["remarks"].push_back(on_ur);
  }
  for (const Unresolved& part : list.unresolved) {
    json["unresolved"].push_back(unresolved(part));
  }
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    json["orbits"].push_back(orbit(list, i));
  }
  return json;
}

}  // namespace stickslip::report::orbits
