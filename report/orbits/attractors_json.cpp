#include <fmt/format.h>

#include "core/decimal.hpp"
#include "report/orbits/attractors.hpp"
#include "report/orbits/parts.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::attractors;
using namespace tools;
using words::WordOrbit;
using words::WordQuestion;

namespace {

Json durations(const WordOrbit& orbit, int digits) {
  return list_of(orbit.orbit.motion.phases,
                 [digits](const motion::Phase& phase) { return to_json(phase.duration, digits); });
}

Json word_orbit(const WordOrbit& o, int digits) {
  Json json = {{"word", o.word.letters()}, {"period", o.periods}, {"durations", durations(o, digits)}};
  add_values(json, o.orbit.values, digits);
  json["admissible"] = to_json(o.orbit.admissible);
  add_stability(json, o.orbit, digits);
  json["conditions"] = Json::array();
  for (std::size_t k = 0; k < o.orbit.conditions.size(); ++k) {
    Json condition = to_json(o.orbit.conditions[k]);
    condition["phase"] = o.asked[k].phase + 1;
    json["conditions"].push_back(condition);
  }
  return json;
}

}  // namespace

Json to_json(const WordQuestion& q) {
  const motion::ExactParameters& a = q.data;
  return {{"chi", to_string(a.chi)}, {"eta", to_string(a.eta)},     {"us", to_string(a.us)},
          {"V", to_string(a.V)},     {"omega", to_string(a.omega)}, {"p", to_string(a.p)},
          {"ur", to_string(q.ur)}};
}

Json to_json(const Attractor& a, int digits) {
  Json json = {{"kind", to_string(a.kind)},
               {"share", a.share},
               {"share_interval", {a.least, a.most}},
               {"count", a.count},
               {"state", {a.state(0), a.state(1), a.state(2), a.state(3)}}};
  if (a.lyapunov) {
    json["lyapunov"] = *a.lyapunov;
  }
  if (a.kind != Kind::periodic) {
    return json;
  }
  json["period"] = a.periods;
  json["word"] = a.word;
  const Verdict existence = a.orbit ? a.orbit->existence : Verdict::undecided("no proof was tried");
  json["verdict"] = to_string(existence.truth);
  if (!existence.reason.empty()) {
    json["reason"] = plain(existence.reason);
  }
  if (existence.truth == Truth::proved) {
    json["durations"] = durations(*a.orbit, digits);
    json["admissible"] = to_json(a.orbit->orbit.admissible);
    if (!a.family.empty()) {
      json["family"] = a.family;
    }
    add_stability(json, a.orbit->orbit, digits);
  }
  return json;
}

std::string options_of(const WordQuestion& q) {
  std::string text;
  const Json all = to_json(q);
  for (const auto& [name, value] : all.items()) {
    text += fmt::format(" --{}={}", name, value.get<std::string>());
  }
  return text;
}

Json to_json(const AttractorList& list) {
  const AttractorQuestion& q = list.question;
  Json json = provenance(command_of(q));
  json["parameters"] = to_json(q.machine);
  json["starts"] = q.starts;
  json["seed"] = q.seed;
  json["most_periods"] = q.most_periods;
  json["simulated"] = list.simulated;
  json["interrupted"] = list.interrupted;
  json["followed"] = list.followed;
  const words::PureSlip slip = words::pure_slip(q.machine.data);
  if (slip.forced.is_finite()) {  // not at resonance
    json["pure_slip"] = {{"forced", to_json(slip.forced, q.machine.digits)},
                         {"verdict", to_string(slip.exists.truth)}};
  }
  json["attractors"] =
      list_of(list.attractors, [&](const Attractor& a) { return to_json(a, q.machine.digits); });
  return json;
}

Json to_json(const WordOrbits& list) {
  const WordSearch& q = list.question;
  Json json = provenance(command_of(q));
  json["word"] = q.word.letters();
  json["period"] = q.periods;
  json["parameters"] = to_json(q.machine);
  json["complete"] = list.complete();
  json["unresolved"] = list_of(
      list.unresolved, [&](const families::Unresolved& part) { return to_json(part, q.machine.digits); });
  json["orbits"] = list_of(list.orbits, [&](const WordOrbit& o) { return word_orbit(o, q.machine.digits); });
  if (!list.seen.empty()) {
    json["seen"] = list.seen;
  }
  return json;
}

std::string command_of(const AttractorQuestion& q) {
  return fmt::format("stickslip attractors{} --starts {} --seed {} --most-periods {} --digits {}",
                     options_of(q.machine), q.starts, q.seed, q.most_periods, q.machine.digits);
}

std::string command_of(const WordSearch& q) {
  const std::string near = q.near ? fmt::format(" --near={:.17g},{:.17g},{:.17g},{:.17g}", (*q.near)(0),
                                                (*q.near)(1), (*q.near)(2), (*q.near)(3))
                                  : "";
  return fmt::format("stickslip orbits {} --period {}{}{} --digits {}", q.word.letters(), q.periods,
                     options_of(q.machine), near, q.machine.digits);
}

}  // namespace stickslip::report::orbits
