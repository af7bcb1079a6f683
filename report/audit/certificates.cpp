#include "report/audit/certificates.hpp"

#include <fmt/format.h>

#include <array>

#include "proofs/certificates/prelude.hpp"
#include "proofs/certificates/statement_files.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/tools/files.hpp"
#include "report/tools/layout.hpp"
#include "report/tools/versions.hpp"

namespace stickslip::report::audit {

using namespace proofs;
using tools::Json;
namespace fs = std::filesystem;

std::string to_string(Certified::State state) {
  constexpr std::array names{"unknown", "certified", "stale", "refused", "none"};
  return names.at(static_cast<std::size_t>(state));
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
    spoiled_ = path.empty() ? "" : why_none_counts(audit, abbreviations);
  }

  [[nodiscard]] Certified state(const methods::Record& record) const {
    const auto found = claims_.find(record.claim.id);
    if (found == claims_.end()) {
      const auto reason = without_.find(record.claim.id);
      return reason == without_.end() ? Certified{State::unknown, "", "Coq was not asked"}
                                      : Certified{State::none, "", reason->second};
    }
    const Json& claim = *found->second;
    const std::string file = claim.at("file"), reason = claim.at("reason");
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
    if (record_.at("program").at("version") != tools::program_version()) {
      return "Coq certified it for another version of the program";
    }
    if (!is_sealed(record_)) {
      return "the record is not as it was made";
    }
    for (const auto& [name, says] : record_.at("coq").value("axioms", std::map<std::string, std::string>{})) {
      const auto allowed = allowed_axioms().find(name);
      if (allowed == allowed_axioms().end() || allowed->second != says) {
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
