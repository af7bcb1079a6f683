#include "report/audit/graph.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "report/audit/summary.hpp"
#include "report/tools/graphviz.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace tools;

namespace {

using proofs::methods::Audit;
using proofs::methods::Outcome;
using proofs::methods::Record;

// All claims that the proofs of a record use.
std::set<std::string> used_by_proofs_of(const Record& record) {
  std::set<std::string> all = record.outcome.uses;
  for (const std::optional<Outcome>& further : {record.corrected, record.converse}) {
    if (further) {
      all.insert(further->uses.begin(), further->uses.end());
    }
  }
  return all;
}

// How many claims of one place are used by proofs of another, by both.
using Uses = std::map<std::pair<std::string, std::string>, std::size_t>;

Uses uses_between(const std::vector<PlaceRecords>& places) {
  std::map<std::string, std::string> place_of;
  for (const PlaceRecords& place : places) {
    for (const Record * record : place.records) {
      place_of[record->claim.id] = place.id;
    }
  }
  std::set<std::array<std::string, 3>> found;  // place of the used claim, place of the user, the claim
  for (const PlaceRecords& place : places) {
    for (const Record * record : place.records) {
      for (const std::string& id : used_by_proofs_of(*record)) {
        if (const auto other = place_of.find(id); other != place_of.end() && other->second != place.id) {
          found.insert({other->second, place.id, id});
        }
      }
    }
  }
  Uses uses;
  for (const auto& [from, to, id] : found) {
    ++uses[{from, to}];
  }
  return uses;
}

// A sentence over several lines of a node.
std::vector<std::string> label(const PlaceRecords& place) {
  constexpr std::size_t width = 26;
  std::vector<std::string> lines = wrapped(place.title, width);
  lines.push_back(fmt::format("{} claim{}", place.records.size(), place.records.size() == 1 ? "" : "s"));
  return lines;
}

std::string escape_dot(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  return result;
}

}  // namespace

Json uses_of_places(const Paper& paper, const Audit& audit) {
  const std::vector<PlaceRecords> places = by_place(paper, audit);
  const Uses uses = uses_between(places);
  const auto rests_on = [&](const PlaceRecords& user) {
    Json all = Json::array();
    for (const PlaceRecords& used : places) {
      if (uses.count({used.id, user.id}) > 0) {
        all.push_back({{"id", used.id}, {"title", used.title}});
      }
    }
    return all;
  };
  const auto width = [](std::size_t count) {
    return fmt::format("{:.2f}", 0.6 + 0.4 * std::sqrt(static_cast<double>(count)));
  };
  return {{"parts", list_of(places,
                            [&](const PlaceRecords& place) -> Json {
                              const Json used = rests_on(place);
                              return {{"id", place.id},
                                      {"title", place.title},
                                      {"lines", label(place)},
                                      {"rests_on", used},
                                      {"has_rests_on", !used.empty()}};
                            })},
          {"uses", list_of(uses, [&](const auto& use) -> Json {
             const auto& [ends, count] = use;
             return {{"from", ends.first}, {"to", ends.second}, {"width", width(count)}};
           })}};
}

std::string graph_script(const Json& uses) {
  return render_file("claims.dot", uses, {escape_dot, escape_dot});
}

std::string graph_svg(const Json& uses) {
  return graphviz_svg(graph_script(uses));
}

}  // namespace stickslip::report::audit
