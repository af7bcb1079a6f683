#include "report/audit/page_data.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "report/audit/summary.hpp"

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

// "Section 2" of "Section 2: the model".
std::string without_subject(const std::string& title) {
  return title.substr(0, title.find(':'));
}

// 1 for one claim, 2 for two or three, 3 for four to seven, 4 for more.
int shade(std::size_t count) {
  return std::min(4, static_cast<int>(std::bit_width(count)));
}

}  // namespace

Json uses_of_places(const Paper& paper, const Audit& audit) {
  const std::vector<PlaceRecords> places = by_place(paper, audit);
  const Uses uses = uses_between(places);
  Json parts = Json::array();
  for (const PlaceRecords& user : places) {
    Json rests_on = Json::array(), row = Json::array();
    for (const PlaceRecords& used : places) {
      const auto found = uses.find({used.id, user.id});
      const std::size_t count = found == uses.end() ? 0 : found->second;
      row.push_back({{"short", without_subject(used.title)},
                     {"count", count == 0 ? "" : std::to_string(count)},
                     {"weight", shade(count)}});
      if (count > 0) {
        rests_on.push_back({{"id", used.id}, {"title", used.title}});
      }
    }
    parts.push_back({{"id", user.id},
                     {"title", user.title},
                     {"short", without_subject(user.title)},
                     {"has_rests_on", !rests_on.empty()},
                     {"rests_on", rests_on},
                     {"row", row}});
  }
  return {{"parts", parts}};
}

}  // namespace stickslip::report::audit
