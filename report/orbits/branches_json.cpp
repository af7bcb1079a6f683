#include <array>

#include "core/decimal.hpp"
#include "numeric/families/family.hpp"
#include "report/orbits/branches.hpp"
#include "report/orbits/orbit_words.hpp"
#include "report/orbits/parts.hpp"

namespace stickslip::report::orbits {

using namespace numeric;
using namespace numeric::branches;
using namespace tools;

namespace {

Json change_data(const Change& change, const BranchQuestion& q) {
  static constexpr std::array names{"", "condition", "multiplier", "duration", "frequency"};
  Json json = {{"kind", to_string(change.kind)}};
  if (!change.what.empty()) {
    json[names.at(static_cast<std::size_t>(change.kind))] = change.what;
  }
  json["words"] = change.words;
  json["at"] = to_json(change.at, 20);
  if (const auto time = time_of(q, change)) {
    json["time"] = to_json(*time, 20);
  }
  json["verdict"] = to_string(change.verdict.truth);
  if (!change.verdict.reason.empty()) {
    json["reason"] = change.verdict.reason;
  }
  return json;
}

Json branch_data(const Branch& branch, const BranchQuestion& q) {
  Json json = {{"from", to_json(branch.first.at, 20)},
               {"to", to_json(branch.last.at, 20)},
               {"closed", branch.closed},
               {"ends", Json::array()},
               {"pieces", Json::array()},
               {"changes", list_of(branch.changes, [&](const Change& c) { return change_data(c, q); })},
               {"samples", Json::array()}};
  for (const BranchEnd * end : {&branch.first, &branch.last}) {
    json["ends"].push_back({{"at", to_json(end->at, 20)},
                            {"kind", to_string(end->kind)},
                            {"reason", end->words},
                            {"resolved", end->resolved()}});
  }
  for (const Piece& piece : branch.pieces) {
    Json one = {{"from", to_json(piece.first, 20)},
                {"to", to_json(piece.last, 20)},
                {"state", to_string(piece.state)}};
    if (!piece.condition.empty()) {
      one["violates"] = piece.condition;
    }
    json["pieces"].push_back(one);
    for (const Sample& sample : piece.samples) {
      Json here = {{"value", sample.value}, {"state", to_string(piece.state)}};
      const SampleValues start = values_of(q, sample);
      for (std::size_t k = 0; k < start.durations.size(); ++k) {
        here[q.orbits.family->durations[k]] = start.durations[k];
      }
      here["phi"] = start.phi;
      here["x10"] = start.x10;
      here["x20"] = start.x20;
      here["xdot10"] = start.xdot10;
      json["samples"].push_back(here);
    }
  }
  return json;
}

}  // namespace

Json to_json(const BranchList& list) {
  const BranchQuestion& q = list.question;
  Json json = provenance(command_of(q));
  json["family"] = q.orbits.family->name;
  json["parameter"] = q.parameter;
  json["interval"] = {stickslip::to_string(q.from), stickslip::to_string(q.to)};
  json["parameters"] = Json::object();
  for (const auto& [name, value] : parameters_of(q)) {
    json["parameters"][name] = value;
  }
  if (q.machine) {
    json["units"] = "si";
  }
  json["complete"] = list.complete;
  if (q.at) {
    json["at"] = stickslip::to_string(*q.at);
  }
  json["branches"] = list_of(list.branches, [&](const Branch& branch) { return branch_data(branch, q); });
  json["counts"] = list_of(list.counts, [](const Count& count) {
    return Json{{"from", to_json(count.from, 20)}, {"to", to_json(count.to, 20)},
                {"orbits", count.orbits},          {"admissible", count.admissible},
                {"stable", count.stable},          {"unsettled", count.unsettled},
                {"undecided", count.undecided},    {"more", count.more}};
  });
  json["unresolved"] = list_of(list.unresolved, [&](const UnresolvedPart& part) {
    Json one = {{"value", to_json(part.value, 20)}};
    add_values(one, where(q, part), 20);
    one["reason"] = plain(part.reason);
    one["resonance"] = part.resonance;
    return one;
  });
  json["interrupted"] = list.interrupted;
  return json;
}

}  // namespace stickslip::report::orbits
