#include "report/audit/graph.hpp"

#include <map>
#include <set>

#include "report/audit/summary.hpp"
#include "report/tools/graphviz.hpp"
#include "report/tools/templates.hpp"

namespace stickslip::report::audit {

using namespace proofs::methods;
using namespace tools;

namespace {

using proofs::methods::Audit;
using proofs::methods::Record;

// By id of a claim: the ids of the claims of the audit that its proofs use.
using Uses = std::map<std::string, std::set<std::string>>;

Uses uses_in(const Audit& audit) {
  Uses uses;
  for (const Record& record : audit.records) {
    uses[record.claim.id];
  }
  for (const Record& record : audit.records) {
    std::set<std::string> all = record.outcome.uses;
    if (record.corrected) {
      all.insert(record.corrected->uses.begin(), record.corrected->uses.end());
    }
    for (const std::string& id : all) {
      if (uses.contains(id) && id != record.claim.id) {
        uses[record.claim.id].insert(id);
      }
    }
  }
  return uses;
}

void collect(const Uses& uses, const std::string& id, std::set<std::string>& reached) {
  for (const std::string& next : uses.at(id)) {
    if (reached.insert(next).second) {
      collect(uses, next, reached);
    }
  }
}

// What is used and is not used, however indirectly, by something else that is.
std::set<std::string> direct(const Uses& uses, const std::string& id) {
  std::set<std::string> indirect;
  for (const std::string& next : uses.at(id)) {
    collect(uses, next, indirect);
  }
  std::set<std::string> result;
  for (const std::string& next : uses.at(id)) {
    if (!indirect.contains(next)) {
      result.insert(next);
    }
  }
  return result;
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

std::string graph_script(const Paper& paper, const Audit& audit) {
  Json places = Json::array();
  for (const PlaceRecords& place : by_place(paper, audit)) {
    Json nodes = Json::array();
    for (const Record * record : place.records) {
      nodes.push_back({{"id", record->claim.id},
                       {"status", proofs::methods::to_string(record->status)},
                       {"words", plain(record->claim.words)}});
    }
    places.push_back({{"id", place.id}, {"title", place.title}, {"nodes", nodes}});
  }
  Json edges = Json::array();
  const Uses uses = uses_in(audit);
  for (const auto& [id, ignored] : uses) {
    for (const std::string& used : direct(uses, id)) {
      edges.push_back({{"from", used}, {"to", id}});
    }
  }
  return render_file("claims.dot", {{"places", places}, {"edges", edges}}, {escape_dot, escape_dot});
}

std::string graph_svg(const Paper& paper, const Audit& audit) {
  return graphviz_svg(graph_script(paper, audit));
}

}  // namespace stickslip::report::audit
