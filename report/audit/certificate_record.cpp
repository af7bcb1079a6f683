#include "report/audit/certificate_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "proofs/certificates/statement_files.hpp"
#include "report/tools/files.hpp"
#include "report/tools/versions.hpp"

namespace stickslip::report::audit {

using namespace proofs;
using tools::Json;

namespace fs = std::filesystem;

namespace {

constexpr std::array parts{"program", "coq", "foundations", "claims", "without"};
// What Coq says of a claim.
constexpr std::array answers{"accepted", "reason", "seconds", "compiled", "again"};

bool is_foundation(const std::string& name) {
  return name.ends_with(".v") && !name.starts_with("Claim") && name != certificates::final_name;
}

// The fingerprints of the foundations' texts.
std::map<std::string, std::string> foundations_in(const Json& record) {
  std::map<std::string, std::string> result;
  for (const Json& one : record.value("foundations", Json::array())) {
    result.emplace(one.at("file"), one.at("text"));
  }
  return result;
}

struct Count {
  std::size_t theorems = 0, certified = 0, immediate = 0, again = 0;
  void add(const Json& claim) {
    const std::size_t count = claim.at("theorems").size();
    theorems += count;
    if (claim.at("accepted") == true) {
      certified += count;
      immediate += claim.at("immediate").get<std::size_t>();
      again += claim.at("again") == "accepted" ? count : 0;
    }
  }
};

}  // namespace

Json record_of(const certificates::Certificates& all, const Json& recorded_before) {
  const Json before = is_sealed(recorded_before) ? recorded_before : Json::object();
  std::map<std::string, const Json *> recorded;
  if (before.contains("claims")) {
    for (const Json& claim : before.at("claims")) {
      recorded.emplace(claim.at("claim"), &claim);
    }
  }
  std::map<std::string, std::string> texts;
  Json claims = Json::array(), without = Json::array(), foundations = Json::array();
  for (const certificates::File& file : all.files) {
    texts.emplace(file.name, certificates::fingerprint(file.text));
    if (is_foundation(file.name)) {
      foundations.push_back({{"file", file.name}, {"text", texts.at(file.name)}, {"compiled", ""}});
    }
  }
  const bool same_foundations = foundations_in(before) == foundations_in({{"foundations", foundations}});
  if (same_foundations) {
    foundations = before.at("foundations");
  }
  std::set<std::string> same;  // names of files of which nothing has changed, nor of what they rest on
  for (const certificates::Certificate& one : all.certificates) {
    claims.push_back({{"claim", one.claim},
                      {"file", one.name + ".v"},
                      {"theorems", one.theorems},
                      {"immediate", one.immediate},
                      {"intervals", one.many_enclosures},
                      {"imports", one.imports},
                      {"says", one.says},
                      {"text", texts.at(one.name + ".v")},
                      {"asked", one.asked},
                      {"accepted", nullptr},
                      {"reason", "Coq was not asked"},
                      {"seconds", ""},
                      {"compiled", ""},
                      {"again", ""}});
    Json& claim = claims.back();
    const auto known = recorded.find(one.claim);
    if (same_foundations && known != recorded.end() && known->second->at("text") == claim["text"] &&
        known->second->at("says") == claim["says"] &&
        std::ranges::all_of(one.imports, [&](const std::string& import) { return same.contains(import); })) {
      same.insert(one.name);
      for (const char * key : answers) {
        claim[key] = known->second->at(key);
      }
    }
  }
  for (const certificates::Uncertified& one : all.uncertified) {
    without.push_back({{"claim", one.claim}, {"reason", one.reason}});
  }
  return sealed({{"program", {{"name", "stickslip"}, {"version", tools::program_version()}}},
                 {"coq", before.value("coq", Json::object())},
                 {"foundations", foundations},
                 {"claims", claims},
                 {"without", without}});
}

Json read_record(const fs::path& path) {
  const Json record = Json::parse(tools::read_file(path), nullptr, false);
  if (record.is_discarded() ||
      !std::ranges::all_of(parts, [&](const char * part) { return record.contains(part); })) {
    throw InputOutputError(
        fmt::format("'{}' is no record of certificates; script/certify makes one", path.string()));
  }
  return record;
}

Json sealed(Json record) {
  record.erase("seal");
  const std::string seal = certificates::fingerprint(record.dump());
  record["seal"] = seal;
  return record;
}

bool is_sealed(const Json& record) {
  return record.contains("seal") && sealed(record).at("seal") == record.at("seal");
}

std::string text_of(const Json& record) {
  std::string text;
  Count asked, all;
  for (const Json& claim : record.at("claims")) {
    all.add(claim);
    if (claim.at("asked") != true) {
      continue;
    }
    asked.add(claim);
    const std::size_t count = claim.at("theorems").size();
    const std::string id = claim.at("claim");
    text += claim.at("accepted") == true
                ? fmt::format("{:<18} {:>2} {} {:>7} s{}\n", id, count, count == 1 ? "theorem " : "theorems",
                              claim.at("seconds").get<std::string>(),
                              claim.at("again") == "accepted" ? "  coqchk, too" : "")
                : fmt::format("certify: {}: {}\n", id, claim.at("reason").get<std::string>());
  }
  if (all.theorems > asked.theorems) {
    text += fmt::format("with all that the directory holds: {} of {}\n", all.certified, all.theorems);
  }
  if (asked.certified > 0) {
    text += fmt::format("{} of them by a definition or an assumption alone; coqchk accepts {}\n",
                        asked.immediate, asked.again);
  }
  return text + fmt::format("{} of {} theorems certified, {} axioms\n", asked.certified, asked.theorems,
                            asked.certified > 0 ? record.at("coq").at("axioms").size() : 0);
}

bool all_accepted(const Json& record) {
  return std::ranges::all_of(record.at("claims"), [](const Json& claim) {
    return claim.at("asked") != true || claim.at("accepted") == true;
  });
}

namespace fs = std::filesystem;

const std::map<std::string, std::string>& allowed_axioms() {
  static const std::map<std::string, std::string> axioms{
      {"ClassicalDedekindReals.sig_not_dec", "forall P : Prop, {~ ~ P} + {~ P}"},
      {"ClassicalDedekindReals.sig_forall_dec",
       "forall P : nat -> Prop, (forall n : nat, {P n} + {~ P n}) -> {n : nat | ~ P n} + {forall n : nat, P "
       "n}"},
      {"FunctionalExtensionality.functional_extensionality_dep",
       "forall (A : Type) (B : A -> Type) (f g : forall x : A, B x), (forall x : A, f x = g x) -> f = g"},
      {"Classical_Prop.classic", "forall P : Prop, P \\/ ~ P"}};
  return axioms;
}

std::map<std::string, std::string> axioms_in(const std::string& printed) {
  std::map<std::string, std::string> axioms;
  std::istringstream lines(printed);
  bool inside = false;
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Axioms:" || line.starts_with("Closed under the global context")) {
      inside = true;
      name.clear();
      continue;
    }
    if (!inside || line.empty()) {
      continue;
    }
    std::istringstream words(line);
    std::string word;
    if (line.front() != ' ') {
      words >> name;
      axioms[name];
    }
    while (words >> word) {
      if (!(axioms[name].empty() && word == ":")) {
        axioms[name] += (axioms[name].empty() ? "" : " ") + word;
      }
    }
  }
  return axioms;
}

std::string seconds_in(const fs::path& log) {
  std::error_code error;
  std::istringstream lines(fs::exists(log, error) ? tools::read_file(log) : "");
  std::string seconds;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("seconds ")) {
      seconds = line.substr(8);
    }
  }
  return seconds;
}

std::size_t line_in(const std::string& complaint) {
  const std::size_t at = complaint.find("line ");
  return at == std::string::npos ? 0 : std::strtoul(complaint.c_str() + at + 5, nullptr, 10);
}

std::string error_in(const std::string& complaint) {
  const std::size_t at = complaint.find("Error:");
  std::istringstream words(at == std::string::npos ? complaint : complaint.substr(at + 6));
  std::string line;
  for (std::string word; words >> word && line.size() < 200;) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

std::vector<std::string> required_by(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("From Stickslip Require ")) {
      std::istringstream words(line.substr(23));
      for (std::string word; words >> word;) {
        if (word != "Import" && word != "Export") {
          names.push_back(word.ends_with('.') ? word.substr(0, word.size() - 1) : word);
        }
      }
    }
  }
  return names;
}

}  // namespace stickslip::report::audit
