#include "report/audit/certificate_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/names.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/certificates/statement_files.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"
#include "report/tools/layout.hpp"

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

bool is_allowed(const std::string& axiom, const std::string& says) {
  const auto allowed = allowed_axioms().find(axiom);
  return allowed != allowed_axioms().end() && allowed->second == says;
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

std::string to_string(Certified::State state) {
  return name_of<Certified::State::none>(state, "unknown", "certified", "stale", "refused", "none");
}

namespace {

using State = Certified::State;

std::string fingerprint_of(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) ? certificates::fingerprint(tools::read_file(file)) : "none";
}

// A record, compared with what there is.
class Compared {
 public:
  Compared(const methods::Audit& audit, const fs::path& path,
           const std::vector<kernel::Definition>& abbreviations)
      : record_(path.empty() ? Json{{"claims", Json::array()}, {"without", Json::array()}}
                             : read_record(path)),
        directory_(path.parent_path()) {
    for (const Json& claim : record_.at("claims")) {
      claims_.emplace(claim.at("claim"), &claim);
      files_.emplace(fs::path(claim.at("file").get<std::string>()).stem(), &claim);
    }
    for (const Json& one : record_.at("without")) {
      without_.emplace(one.at("claim"), one.at("reason"));
    }
    forged_ = !path.empty() && !is_sealed(record_);
    spoiled_ = path.empty() ? "" : why_none_counts(audit, abbreviations);
  }

  [[nodiscard]] Certified state(const methods::Record& record) const {
    const auto found = claims_.find(record.claim.id);
    if (found == claims_.end()) {
      const auto reason = without_.find(record.claim.id);
      return forged_                    ? Certified{State::unknown, "", spoiled_}
             : reason == without_.end() ? Certified{State::unknown, "", "Coq was not asked"}
                                        : Certified{State::none, "", reason->second};
    }
    const Json& claim = *found->second;
    const std::string file = claim.at("file"), reason = claim.at("reason");
    if (claim.at("accepted") != true && forged_) {
      return {State::unknown, file, spoiled_};
    }
    if (claim.at("accepted") != true) {
      return {claim.at("accepted").is_null() ? State::unknown : State::refused, file,
              reason.empty() ? "Coq was not asked" : reason};
    }
    const std::string changed = claim.at("says") != certificates::fingerprint(record)
                                    ? "what Coq certified is another statement than this one"
                                : !spoiled_.empty() ? spoiled_
                                                    : why_changed(claim);
    if (!changed.empty()) {
      return {State::stale, file, changed};
    }
    return {State::certified, file,
            fmt::format("{} on {}", tools::counted(std::ssize(claim.at("theorems")), "theorem"),
                        tools::counted(std::ssize(record_.at("coq").at("axioms")), "axiom"))};
  }

 private:
  // Of all claims: why the record says nothing of them; empty if it does.
  [[nodiscard]] std::string why_none_counts(const methods::Audit& audit,
                                            const std::vector<kernel::Definition>& abbreviations) const {
    if (forged_) {
      return "the record is not as it was made";
    }
    if (record_.at("program").at("version") != tools::program_version()) {
      return "Coq certified it for another version of the program";
    }
    for (const auto& [name, says] : record_.at("coq").value("axioms", std::map<std::string, std::string>{})) {
      if (!is_allowed(name, says)) {
        return "it rests on " + name;
      }
    }
    std::map<std::string, std::string> written(certificates::prelude().begin(),
                                               certificates::prelude().end());
    certificates::Records said;
    for (const methods::Record& record : audit.records) {
      if (claims_.contains(record.claim.id)) {
        said.push_back(&record);
      }
    }
    written.emplace(certificates::definitions_name, certificates::definitions_file(said));
    written.emplace(certificates::statements_name, certificates::statements_file(said, abbreviations));
    std::map<std::string, const Json *> recorded;
    for (const Json& one : record_.at("foundations")) {
      recorded.emplace(one.at("file"), &one);
    }
    for (const auto& [name, text] : written) {
      const auto found = recorded.find(name);
      if (found == recorded.end() || found->second->at("text") != certificates::fingerprint(text)) {
        return name + " is not what the program writes";
      }
    }
    for (const auto& [name, one] : recorded) {
      if (fingerprint_of(directory_ / name) != one->at("text")) {
        return name + " is not the one that Coq was asked about";
      }
      // No claim loads the statements: `certify --record` alone compiles them, and apart from the directory.
      const std::string compiled = name == certificates::statements_name ? "" : one->at("compiled");
      if (!compiled.empty() && fingerprint_of((directory_ / name).replace_extension(".vo")) != compiled) {
        return "what was compiled of " + name + " is not what Coq was asked about";
      }
    }
    return "";
  }

  // Of one claim, and all that it imports; each is looked at once.
  [[nodiscard]] const std::string& why_changed(const Json& claim) const {
    const std::string file = claim.at("file");
    if (const auto known = changed_.find(file); known != changed_.end()) {
      return known->second;
    }
    std::string changed;
    if (fingerprint_of(directory_ / file) != claim.at("text") ||
        fingerprint_of((directory_ / file).replace_extension(".vo")) != claim.at("compiled")) {
      changed = file + " is not the one that Coq accepted";
    }
    for (const std::string import : claim.at("imports")) {
      if (changed.empty()) {
        const auto found = files_.find(import);
        changed = found == files_.end() || found->second->at("accepted") != true
                      ? import + ".v is not one that Coq accepted"
                      : why_changed(*found->second);
      }
    }
    return changed_.emplace(file, changed).first->second;
  }

  Json record_;
  fs::path directory_;
  std::map<std::string, const Json *> claims_, files_;
  std::map<std::string, std::string> without_;
  bool forged_ = false;  // the record is not as it was made
  std::string spoiled_;
  mutable std::map<std::string, std::string> changed_;  // by files: why, or nothing
};

}  // namespace

Certification certification(const methods::Audit& audit, const fs::path& path,
                            const std::vector<kernel::Definition>& abbreviations) {
  const Compared compared(audit, path, abbreviations);
  Certification result;
  std::map<State, long> count;
  long theorems = 0;
  for (const methods::Record& record : audit.records) {
    const long all = std::ssize(certificates::named_theorems(record));
    const Certified one =
        all == 0 ? Certified{State::none, "", certificates::without_theorem(record)} : compared.state(record);
    ++count[one.state];
    theorems += one.state == State::certified ? all : 0;
    result.claims.emplace(record.claim.id, one);
  }
  const long provable = std::ssize(audit.records) - count[State::none];
  const std::string with =
      tools::counted(provable, "claim") + (provable == 1 ? " that has theorems" : " that have theorems");
  if (path.empty()) {
    result.line = fmt::format("Coq was not asked about the {} of the kernel; script/certify asks it.", with);
    return result;
  }
  result.line = fmt::format("Certified by Coq: {} of {} of the kernel, with {}.", count[State::certified],
                            with, tools::counted(theorems, "theorem"));
  for (const auto& [state, words] : std::map<State, const char *>{
           {State::stale, "stale"}, {State::refused, "refused"}, {State::unknown, "not asked about"}}) {
    if (count[state] > 0) {
      result.line += fmt::format(" {} {}.", count[state], words);
    }
  }
  result.line += fmt::format(" The other {} have no certificate, each for its reason.", count[State::none]);
  return result;
}

void write_certificate(tools::Object& json, const Certification& certification, const std::string& claim) {
  const auto found = certification.claims.find(claim);
  const Certified one = found == certification.claims.end() ? Certified{} : found->second;
  json.has(
      "state", one.state,
      tools::with(tools::names_through(Certified::State::none),
                  "Whether Coq accepts the claim's theorems: accepted as they are now; accepted, but changed "
                  "since; not accepted; there are none; not asked."));
  json.has("file", one.file, "The certificate, in the directory of certificates; empty if there is none.");
  json.has("words", one.words, "How many theorems on how many axioms; else why it is not certified.");
}

}  // namespace stickslip::report::audit
