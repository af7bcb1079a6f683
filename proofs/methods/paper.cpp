#include "proofs/methods/paper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "proofs/symbols/sample.hpp"

namespace stickslip::proofs::methods {

const PrintedResult& Example::result(const std::string& result_name) const {
  const auto found = std::ranges::find(results, result_name, &PrintedResult::name);
  if (found == results.end()) {
    throw InternalError(fmt::format("example {} prints no {}", name, result_name));
  }
  return *found;
}

std::vector<Coordinate> data_of(const Example& example) {
  const numeric::motion::ExactParameters& a = example.data;
  std::vector<Coordinate> data{{"chi", a.chi}, {"eta", a.eta},     {"us", a.us},
                               {"V", a.V},     {"omega", a.omega}, {"p", a.p}};
  if (example.phi) {
    data.push_back({"phi", *example.phi});
  }
  if (example.ur) {
    data.push_back({"ur", *example.ur});
  }
  return data;
}

namespace {

const Record * record_of(const Audit& audit, const std::string& id) {
  const auto found =
      std::ranges::find_if(audit.records, [&](const Record& record) { return record.claim.id == id; });
  return found == audit.records.end() ? nullptr : &*found;
}

// Whether all that the claim's proof needs beyond what it assumes holds at the data of the example.
bool all_hold_at(const Example& example, const Record& record) {
  const std::vector<Coordinate> data = data_of(example);
  return std::ranges::all_of(record.outcome.hypotheses, [&](const Hypothesis& one) {
    try {
      return symbols::evaluate<Ball>(one.nonzero, symbols::at_point(data))(0, 0).is_nonzero();
    } catch (const InternalError&) {
      return false;  // it speaks of more than the data
    }
  });
}

Status worst_of(const Paper& paper, const PrintedStatement& statement, const std::vector<std::string>& ids,
                const Audit& audit) {
  std::vector<Status> found;
  for (const std::string& id : ids) {
    const Record * record = record_of(audit, id);
    const Status status = record ? record->status : Status::undecided;
    const bool met = record && needs_something(*record) && !statement.example.empty() &&
                     all_hold_at(example_named(paper.examples, statement.example), *record);
    found.push_back(met ? Status::as_printed : status);
  }
  if (statement.kind == Kind::definition) {
    std::ranges::replace(found, Status::where_defined, Status::as_printed);
  }
  if (statement.kind != Kind::condition && std::ranges::count(found, Status::premise) < std::ssize(found)) {
    std::erase(found, Status::premise);
  }
  return *std::ranges::max_element(found);
}

}  // namespace

bool is_whole(const Paper& paper, const Audit& audit) {
  return std::ranges::all_of(paper.claims,
                             [&](const Claim& claim) { return record_of(audit, claim.id) != nullptr; });
}

bool is_stated(const Paper& paper, const std::string& claim) {
  return std::ranges::any_of(paper.statements, [&](const PrintedStatement& statement) {
    return std::ranges::find(statement.claims, claim) != statement.claims.end();
  });
}

std::vector<std::string> stating(const PrintedStatement& statement) {
  std::vector<std::string> all = statement.claims;
  all.insert(all.end(), statement.or_read.begin(), statement.or_read.end());
  return all;
}

std::vector<const PrintedStatement *> statements_in(const Paper& paper, const Audit& audit) {
  const auto known = [&](const std::string& id) { return record_of(audit, id) != nullptr; };
  const bool whole = is_whole(paper, audit);
  std::vector<const PrintedStatement *> statements;
  for (const PrintedStatement& statement : paper.statements) {
    if (whole || (!statement.claims.empty() && std::ranges::all_of(stating(statement), known))) {
      statements.push_back(&statement);
    }
  }
  return statements;
}

Status status_of(const Paper& paper, const PrintedStatement& statement, const Audit& audit) {
  if (statement.claims.empty()) {
    return Status::not_stated;
  }
  Status status = worst_of(paper, statement, statement.claims, audit);
  if (!statement.or_read.empty()) {
    const Status other = worst_of(paper, statement, statement.or_read, audit);
    const auto& [better, worse] = std::minmax(status, other);
    status = worse == Status::refuted && facts(better).stands ? Status::on_one_reading : worse;
  }
  return statement.missing.empty() || status > Status::needs_hypotheses ? status : Status::in_part;
}

const Remark * remark_on(const Paper& paper, const std::string& claim) {
  const auto found = std::ranges::find(paper.remarks, claim, &Remark::claim);
  return found == paper.remarks.end() ? nullptr : &*found;
}

std::set<std::string> ids_named(const std::vector<Claim>& claims, const std::string& word) {
  std::set<std::string> ids;
  std::vector<std::string> places;
  for (const Claim& claim : claims) {
    if (claim.id == word || claim.place == word || claim.id.starts_with(word + ".") ||
        to_string(claim.kind) == word || to_string(claim.origin) == word) {
      ids.insert(claim.id);
    }
    if (places.empty() || places.back() != claim.place) {
      places.push_back(claim.place);
    }
  }
  if (word.empty() || ids.empty()) {
    const std::string part = id_of_a_part(claims);
    throw UsageError(fmt::format(
        "there is no claim '{}': name an equation such as {}, a claim such as {}, a kind such as theorem, an "
        "origin such as paper or new, a status such as refuted, or one of the places {}",
        word, part.substr(0, part.find('.')), part, fmt::join(places, ", ")));
  }
  return ids;
}

std::string id_of_a_part(const std::vector<Claim>& claims) {
  const auto found = std::ranges::find_if(
      claims, [](const Claim& claim) { return claim.id.find('.') != std::string::npos; });
  return found == claims.end() ? "" : found->id;
}

const Example& example_named(const std::vector<Example>& examples, const std::string& name) {
  const auto found = std::ranges::find(examples, name, &Example::name);
  if (found == examples.end()) {
    throw UsageError(fmt::format("there is no example '{}': the paper's are {}", name, names_of(examples)));
  }
  return *found;
}

std::string names_of(const std::vector<Example>& examples) {
  std::string names;
  for (const Example& example : examples) {
    const bool last = &example == &examples.back();
    names += (names.empty() ? "" : last ? " or " : ", ") + example.name;
  }
  return names;
}

}  // namespace stickslip::proofs::methods
