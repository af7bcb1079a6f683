#include "report/audit/certificates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "report/tools/files.hpp"
#include "report/tools/versions.hpp"

namespace stickslip::report::audit {

using namespace proofs;
using tools::Json;
namespace fs = std::filesystem;

namespace {

// Those of Coq's real numbers and of classical logic.
const std::set<std::string> allowed_axioms{
    "ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep", "classic"};

// The seconds that a file took.
std::string seconds_of(const fs::path& log) {
  std::istringstream lines(tools::read_file(log));
  std::string seconds;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("seconds ")) {
      seconds = line.substr(8);
    }
  }
  return seconds;
}

// What the theorems of the files that `make axioms` asked about rest on, all together; nothing where Coq did
// not say.
std::optional<std::set<std::string>> axioms_in(const fs::path& log) {
  std::istringstream lines(tools::read_file(log));
  std::optional<std::set<std::string>> axioms;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Axioms:" || line.starts_with("Closed under")) {
      axioms.emplace();
    } else if (axioms && !line.empty() && line.front() != ' ') {
      axioms->insert(line.substr(0, line.find_first_of(" :")));
    }
  }
  return axioms;
}

bool is_newer(const fs::path& file, const fs::path& than) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return !error && time >= fs::last_write_time(than, error) && !error;
}

// What one claim comes to: accepted, refused, or null, where Coq was not asked; and why.
struct Finding {
  Json accepted;
  std::string reason = {};
};

// What Coq said of the file itself. Fills in what was found.
Finding look_at(Json& claim, const fs::path& file) {
  const fs::path compiled = fs::path(file).replace_extension(".vo");
  const fs::path log_file = fs::path(file).replace_extension(".log");
  if (!is_newer(compiled, file)) {
    if (!is_newer(log_file, file)) {
      return {nullptr, "Coq was not asked"};
    }
    const std::string what = tools::read_file(log_file).find("no end within") == std::string::npos
                                 ? "Coq does not accept it"
                                 : "Coq did not come to an end in time";
    return {false, what + ": see " + log_file.filename().string()};
  }
  claim["seconds"] = seconds_of(log_file);
  const fs::path asked = file.parent_path() / "Axioms.v", answer = file.parent_path() / "Axioms.log";
  const bool is_asked = is_newer(answer, compiled) && is_newer(answer, asked) &&
                        tools::read_file(asked).find(fmt::format("(Matrices.and_also {}.theorems)",
                                                                 file.stem().string())) != std::string::npos;
  const auto axioms = is_asked ? axioms_in(answer) : std::nullopt;
  if (!axioms) {
    return {false, "Coq did not say what its theorems rest on"};
  }
  claim["axioms"] = *axioms;
  const auto foreign =
      std::ranges::find_if(*axioms, [](const std::string& axiom) { return !allowed_axioms.contains(axiom); });
  return foreign == axioms->end()
             ? Finding{true}
             : Finding{false, "it, or another of those that Axioms.v names, rests on " + *foreign};
}

// What was found of the files before, by their names without ".v".
struct Before {
  Json accepted;
  std::string root;  // the first that is not accepted of what it rests on
};

// What all certificates stand on: why it does not hold them, if it does not.
std::string below(const Json& record, const fs::path& directory) {
  for (const Json& one : record.value("foundations", Json::array())) {
    const fs::path file = directory / one.at("file").get<std::string>();
    if (!fs::exists(file) || certificates::fingerprint(tools::read_file(file)) != one.at("text")) {
      return file.filename().string() + " is not the one that was written";
    }
  }
  return "";
}

// Whether Coq made it after all that certificates stand on.
bool is_newer_than_foundations(const fs::path& compiled, const Json& record, const fs::path& directory) {
  return std::ranges::all_of(record.value("foundations", Json::array()), [&](const Json& one) {
    const fs::path file = directory / one.at("file").get<std::string>();
    return is_newer(compiled, file) && is_newer(compiled, fs::path(file).replace_extension(".vo"));
  });
}

Finding look_at(Json& claim, const fs::path& directory, const std::map<std::string, Before>& before,
                std::string& root) {
  const fs::path file = directory / claim.at("file").get<std::string>();
  if (!fs::exists(file) || certificates::fingerprint(tools::read_file(file)) != claim.at("text")) {
    return {false, "its file is not the one that was written"};
  }
  for (const std::string import : claim.at("imports")) {
    const Before& found = before.at(import);
    if (found.accepted != true) {
      root = found.root;
      return {found.accepted,
              fmt::format("it rests on {}, {}", root,
                          found.accepted.is_null() ? "of which Coq was not asked" : "which is not accepted")};
    }
  }
  const Finding finding = look_at(claim, file);
  for (const std::string import : claim.at("imports")) {
    if (finding.accepted == true &&
        !is_newer(fs::path(file).replace_extension(".vo"), directory / (import + ".vo"))) {
      return {false, "it was compiled before " + import};
    }
  }
  return finding;
}

std::string counted(std::size_t count, const char * what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

Json record_of(const certificates::Certificates& all, const Json& before) {
  std::map<std::string, const Json *> recorded;
  if (before.contains("claims")) {
    for (const Json& claim : before.at("claims")) {
      recorded.emplace(claim.at("claim"), &claim);
    }
  }
  std::set<std::string> same;  // names of files of which nothing has changed, nor of what they rest on
  std::map<std::string, std::string> texts;
  Json claims = Json::array(), without = Json::array(), foundations = Json::array();
  for (const certificates::File& file : all.files) {
    texts.emplace(file.name, certificates::fingerprint(file.text));
    if (file.name.ends_with(".v") && !file.name.starts_with("Claim_")) {
      foundations.push_back({{"file", file.name}, {"text", texts.at(file.name)}});
    }
  }
  for (const certificates::Certificate& one : all.certificates) {
    claims.push_back({{"claim", one.claim},
                      {"file", one.name + ".v"},
                      {"theorems", one.theorems},
                      {"imports", one.imports},
                      {"says", one.says},
                      {"text", texts.at(one.name + ".v")},
                      {"asked", one.asked},
                      {"accepted", nullptr},
                      {"reason", "Coq was not asked"},
                      {"seconds", ""},
                      {"axioms", Json::array()}});
    Json& claim = claims.back();
    const auto known = recorded.find(one.claim);
    if (known != recorded.end() && known->second->at("text") == claim["text"] &&
        known->second->at("says") == claim["says"] &&
        std::ranges::all_of(one.imports, [&](const std::string& import) { return same.contains(import); })) {
      same.insert(one.name);
      for (const char * key : {"accepted", "reason", "seconds", "axioms"}) {
        claim[key] = known->second->at(key);
      }
    }
  }
  for (const certificates::Uncertified& one : all.uncertified) {
    without.push_back({{"claim", one.claim}, {"reason", one.reason}});
  }
  return {{"program", {{"name", "stickslip"}, {"version", tools::program_version()}}},
          {"foundations", foundations},
          {"claims", claims},
          {"without", without}};
}

Json read_record(const fs::path& path) {
  const Json record = Json::parse(tools::read_file(path), nullptr, false);
  if (record.is_discarded() || !record.contains("claims") || !record.contains("program")) {
    throw InputOutputError(
        fmt::format("'{}' is no record of certificates; script/certify makes one", path.string()));
  }
  return record;
}

Json checked(const fs::path& directory) {
  Json record = read_record(directory / certificate_record);
  std::map<std::string, Before> before;
  const std::string spoiled = below(record, directory);
  for (Json& claim : record.at("claims")) {
    const std::string name = fs::path(claim.at("file").get<std::string>()).stem();
    std::string root = name;
    Finding finding = look_at(claim, directory, before, root);
    if (finding.accepted == true && !spoiled.empty()) {
      finding = {false, spoiled};
    } else if (finding.accepted == true &&
               !is_newer_than_foundations(directory / (name + ".vo"), record, directory)) {
      finding = {nullptr, "Coq was not asked since the lemmas below it have changed"};
    }
    claim["accepted"] = finding.accepted;
    claim["reason"] = finding.reason;
    before[name] = {finding.accepted, root};
  }
  return record;
}

namespace {

struct Count {
  std::size_t theorems = 0, certified = 0;
  std::set<std::string> axioms;
  void add(const Json& claim) {
    const std::size_t count = claim.at("theorems").size();
    theorems += count;
    if (claim.at("accepted") == true) {
      certified += count;
      axioms.insert(claim.at("axioms").begin(), claim.at("axioms").end());
    }
  }
};

}  // namespace

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
                ? fmt::format("{:<18} {:>2} {} {:>7} s {:>2} axioms\n", id, count,
                              count == 1 ? "theorem " : "theorems", claim.at("seconds").get<std::string>(),
                              claim.at("axioms").size())
                : fmt::format("certify: {}: {}\n", id, claim.at("reason").get<std::string>());
  }
  if (all.theorems > asked.theorems) {
    text += fmt::format("with all that the directory holds: {} of {}\n", all.certified, all.theorems);
  }
  return text + fmt::format("{} of {} theorems certified, {} axioms\n", asked.certified, asked.theorems,
                            asked.axioms.size());
}

bool all_accepted(const Json& record) {
  return std::ranges::all_of(record.at("claims"), [](const Json& claim) {
    return claim.at("asked") != true || claim.at("accepted") == true;
  });
}

std::string name_of(Certified::State state) {
  switch (state) {
    case Certified::State::unknown:
      return "unknown";
    case Certified::State::certified:
      return "certified";
    case Certified::State::stale:
      return "stale";
    case Certified::State::refused:
      return "refused";
    case Certified::State::none:
      return "none";
  }
  throw InternalError("a state of a certificate has no name");
}

namespace {

using State = Certified::State;

Certified certified(const methods::Record& record, const Json * claim, const Json& whole,
                    const fs::path& directory) {
  if (claim == nullptr) {
    for (const Json& one : whole.value("without", Json::array())) {
      if (one.at("claim") == record.claim.id) {
        return {State::none, "", one.at("reason")};
      }
    }
    return {State::unknown, "", "Coq was not asked"};
  }
  const std::string file = claim->at("file");
  if (claim->at("accepted") != true) {
    const std::string reason = claim->at("reason");
    return {claim->at("accepted").is_null() ? State::unknown : State::refused, file,
            reason.empty() ? "Coq was not asked" : reason};
  }
  if (claim->at("says") != certificates::fingerprint(record)) {
    return {State::stale, file, "what Coq certified is another statement than this one"};
  }
  if (whole.at("program").at("version") != tools::program_version()) {
    return {State::stale, file, "Coq certified it for another version of the program"};
  }
  if (const fs::path path = directory / file;
      !fs::exists(path) || certificates::fingerprint(tools::read_file(path)) != claim->at("text")) {
    return {State::stale, file, "its file is not the one that Coq accepted"};
  }
  return {State::certified, file,
          fmt::format("{} on {}", counted(claim->at("theorems").size(), "theorem"),
                      counted(claim->at("axioms").size(), "axiom"))};
}

}  // namespace

Certification certification(const methods::Audit& audit, const fs::path& path) {
  const Json whole = path.empty() ? Json::object() : read_record(path);
  std::map<std::string, const Json *> recorded;
  if (!path.empty()) {
    for (const Json& claim : whole.at("claims")) {
      recorded.emplace(claim.at("claim"), &claim);
    }
  }
  Certification result;
  std::map<State, std::size_t> count;
  std::size_t theorems = 0;
  for (const methods::Record& record : audit.records) {
    const auto found = recorded.find(record.claim.id);
    const std::size_t all = certificates::named_theorems(record).size();
    const Certified one = all == 0 ? Certified{State::none, "", certificates::without_theorem(record)}
                                   : certified(record, found == recorded.end() ? nullptr : found->second,
                                               whole, path.parent_path());
    ++count[one.state];
    theorems += one.state == State::certified ? all : 0;
    result.claims.emplace(record.claim.id, one);
  }
  const std::string with = counted(audit.records.size() - count[State::none], "claim");
  if (path.empty()) {
    result.line = fmt::format(
        "Coq was not asked about the {} that have theorems of the kernel; script/certify asks it.", with);
    return result;
  }
  result.line = fmt::format("Certified by Coq: {} of {} that have theorems of the kernel, with {}.",
                            count[State::certified], with, counted(theorems, "theorem"));
  for (const auto& [state, words] : std::map<State, const char *>{
           {State::stale, "stale"}, {State::refused, "refused"}, {State::unknown, "not asked about"}}) {
    if (count[state] > 0) {
      result.line += fmt::format(" {} {}.", count[state], words);
    }
  }
  result.line += fmt::format(" The other {} have no certificate, each for its reason.", count[State::none]);
  return result;
}

Json to_json(const Certification& certification, const std::string& claim) {
  const auto found = certification.claims.find(claim);
  const Certified one = found == certification.claims.end() ? Certified{} : found->second;
  return {{"state", name_of(one.state)}, {"file", one.file}, {"words", one.words}};
}

}  // namespace stickslip::report::audit
