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
  if (stability) {
    json["stability"] = {{"kind", to_string(stability->kind)}, {"reason", stability->reason}};
    json["multipliers"] = list_of(stability->multipliers,
                                  [](const ComplexBall& mu) { return complex_text(mu, multiplier_digits); });
  }
}

Json orbit(const OrbitList& list, std::size_t i) {
  const Orbit& o = list.orbits[i];
  Json json = {
      {"number", i + 1},
      {"total", list.orbits.size()},
      {"verdict", to_string(o.admissible.truth)},
      {"tell", verdict_on(o)},
      {"split", o.split.empty() ? Json(nullptr) : Json(o.split)},
      {"split_latex", latex_of_value(o.split)},
      {"values",
       list_of(o.values, [&](const NamedBall& named) { return value(named, list.question.digits); })},
      {"conditions", list_of(o.conditions, condition)}};
  add_stability(json, o.stability);
  return json;
}

Json unresolved(const Unresolved& part) {
  const auto value = [](const NamedBall& named) -> Json {
    return {{"latex", latex_of_value(named.name)}, {"value", to_string(named.value, 8)}};
  };
  return {{"where", list_of(part.where, value)}, {"reason", part.reason}};
}

}  // namespace

Json orbit_data(const OrbitList& list) {
  const auto parameter = [](const auto& one) -> Json {
    return {{"latex", latex_of_value(one.first)}, {"value_latex", latex_of(one.second)}};
  };
  Json json = {{"title", list.question.family->title},
               {"searched", searched(list.question)},
               {"result", result_of_search(list)},
               {"command", command_of(list.question)},
               {"parameters", list_of(named_parameters(list.question), parameter)},
               {"remarks", list_of(list.remarks, describe)},
               {"unresolved", list_of(list.unresolved, unresolved)},
               {"orbits", Json::array()}};
  if (const std::string on_ur = remark_on_ur(list); !on_ur.empty()) {
    json["remarks"].push_back(on_ur);
  }
  for (std::size_t i = 0; i < list.orbits.size(); ++i) {
    json["orbits"].push_back(orbit(list, i));
  }
  return json;
}

}  // namespace stickslip::report::orbits
