// stickslip certify: proofs for Coq.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "cli/commands/commands.hpp"
#include "cli/commands/output.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "proofs/certificates/certificates.hpp"
#include "report/audit/certificate_record.hpp"
#include "report/tools/files.hpp"
#include "report/tools/json.hpp"

namespace stickslip::cli {

namespace fs = std::filesystem;
using proofs::certificates::Certificates;
using report::audit::certificate_record;

void require_certificates_only(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::is_directory(directory, ignored) || fs::is_empty(directory, ignored) ||
      fs::exists(directory / certificate_record, ignored)) {
    return;
  }
  throw UsageError(fmt::format("'{}' holds files that are not certificates: name a new or an empty directory",
                               directory.string()));
}

namespace {

// Nothing, if there is no record yet, or none that can be read: what it said is asked again.
report::tools::Json recorded(const fs::path& directory) {
  std::error_code ignored;
  const fs::path path = directory / certificate_record;
  try {
    return fs::exists(path, ignored) ? report::audit::read_record(path) : report::tools::Json::object();
  } catch (const InputOutputError&) {
    return report::tools::Json::object();
  }
}

std::set<std::string> ids_of(const std::vector<proofs::methods::Claim>& claims,
                             const std::vector<std::string>& words) {
  std::set<std::string> ids;
  for (const std::string& word : words) {
    ids.merge(proofs::methods::ids_named(claims, word));
  }
  return ids;
}

// Of the directory's certificates those that are still claims: they stay beside those asked for.
std::set<std::string> kept_in(const fs::path& directory, const std::vector<proofs::methods::Claim>& claims) {
  std::set<std::string> kept;
  for (const report::tools::Json& one : recorded(directory).value("claims", report::tools::Json::array())) {
    const std::string id = one.at("claim");
    if (std::ranges::any_of(claims, [&](const auto& claim) { return claim.id == id; })) {
      kept.insert(id);
    }
  }
  return kept;
}

// What Coq said.
ExitCode record(const fs::path& directory) {
  const report::tools::Json json = report::audit::checked(directory);
  report::tools::write_files(directory, {{certificate_record, report::tools::to_text(json)}});
  print(report::audit::text_of(json));
  return report::audit::all_accepted(json) ? exit_decided : exit_refuted;
}

}  // namespace

void write_certificates(const fs::path& directory, const Certificates& certificates) {
  std::vector<report::tools::File> changed;
  std::set<std::string> names;
  std::error_code ignored;
  for (const proofs::certificates::File& file : certificates.files) {
    names.insert(file.name);
    const fs::path path = directory / file.name;
    if (!fs::exists(path, ignored) || report::tools::read_file(path) != file.text) {
      changed.push_back({file.name, file.text});
    }
  }
  changed.push_back({certificate_record,
                     report::tools::to_text(report::audit::record_of(certificates, recorded(directory)))});
  report::tools::write_files(directory, changed);
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const fs::path& path = entry.path();
    if (path.filename().string().starts_with("Claim") && path.extension() == ".v" &&
        !names.contains(path.filename().string())) {
      for (const char * extension : {".v", ".vo", ".vok", ".vos", ".glob", ".log"}) {
        fs::remove(fs::path(path).replace_extension(extension), ignored);
      }
    }
  }
}

ExitCode run(const CertifyOptions& options, const proofs::methods::Paper& paper) {
  if (!options.record.empty()) {
    return record(options.record);
  }
  const std::set<std::string> ids = ids_of(paper.claims, options.words);
  const fs::path directory(options.out);
  report::tools::require_writable(directory);
  require_certificates_only(directory);
  const std::set<std::string> kept = ids.empty() ? ids : kept_in(directory, paper.claims);
  Certificates certificates;
  {
    const Interruptible scope;
    const Progress progress("proving and writing certificates");
    certificates = proofs::certificates::certificates(paper.claims, ids, kept, paper.abbreviations);
    if (interrupted()) {
      tell("stickslip: interrupted: nothing was written");
      return exit_interrupted;
    }
  }
  write_certificates(directory, certificates);
  std::size_t theorems = 0, statements = 0;
  for (const proofs::certificates::Certificate& certificate : certificates.certificates) {
    if (certificate.asked) {
      theorems += certificate.theorems.size();
      ++statements;
    }
  }
  std::string text =
      fmt::format("{} theorems of {} statements are in {}: make -k -j there has Coq check them\n", theorems,
                  statements, options.out);
  bool lacking = false;
  std::map<std::string, std::vector<std::string>> without;
  for (const proofs::certificates::Uncertified& one : certificates.uncertified) {
    if (ids.empty() || ids.contains(one.claim)) {
      without[one.reason].push_back(one.claim);
      lacking = lacking || !ids.empty();
    }
  }
  for (const auto& [reason, claims] : without) {
    text += fmt::format("without certificate, {}: {}\n", reason, fmt::join(claims, ", "));
  }
  print(text);
  return lacking ? exit_undecided : exit_decided;
}

}  // namespace stickslip::cli
