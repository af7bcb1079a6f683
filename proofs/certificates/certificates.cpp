#include "proofs/certificates/certificates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/makefile.hpp"
#include "proofs/certificates/prelude.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/certificates/statement_files.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::certificates {

namespace {

using methods::Outcome;
using methods::Record;

// Of a file: Coq has taken up to 1.5 GB for 2.8 million.
constexpr std::size_t most_characters = 4'000'000;

class Writer {
 public:
  explicit Writer(const std::vector<methods::Claim>& claims) : prover_(claims) {}

  // After all that its proof uses.
  void add(const std::string& id) {
    if (!seen_.insert(id).second) {
      return;
    }
    const Record& record = prover_.prove(id);
    std::set<std::string> uses = record.outcome.uses;
    for (const std::optional<Outcome>& other : {record.corrected, record.converse}) {
      if (other) {
        uses.insert(other->uses.begin(), other->uses.end());
      }
    }
    uses.erase(id);
    std::for_each(uses.begin(), uses.end(), [&](const std::string& used) { add(used); });
    try {
      write(record);
    } catch (const kernel::KernelError& error) {
      library_.erase(file_name(id));
      result_.uncertified.push_back({id, error.what()});
    }
  }

  [[nodiscard]] Certificates finished(const std::vector<methods::Claim>& claims,
                                      const std::set<std::string>& asked,
                                      const std::vector<kernel::Definition>& abbreviations) {
    mark_asked(asked);
    for (const auto& [name, text] : prelude()) {
      result_.files.push_back({name, text});
    }
    const Records said = in_order(claims);
    result_.files.push_back({definitions_name, definitions_file(said)});
    result_.files.push_back({auxiliary_name, auxiliary_file(definitions_of(said))});
    result_.files.push_back({statements_name, statements_file(said, abbreviations)});
    std::vector<Proved> proved;
    for (const Certificate& one : result_.certificates) {
      if (one.asked) {
        proved.push_back({one.name, one.theorems});
      }
    }
    result_.files.push_back({final_name, final_file(proved)});
    result_.files.push_back({"Makefile", makefile(result_.certificates, sizes_)});
    return std::move(result_);
  }

 private:
  // And what these rest on: a file comes after those that it imports.
  void mark_asked(const std::set<std::string>& asked) {
    std::set<std::string> names;
    for (auto one = result_.certificates.rbegin(); one != result_.certificates.rend(); ++one) {
      one->asked = asked.empty() || asked.contains(one->claim) || names.contains(one->name);
      if (one->asked) {
        names.insert(one->imports.begin(), one->imports.end());
      }
    }
  }

  // Those with certificates, in the order of the claims.
  [[nodiscard]] Records in_order(const std::vector<methods::Claim>& claims) {
    std::set<std::string> certified;
    for (const Certificate& one : result_.certificates) {
      certified.insert(one.claim);
    }
    Records records;
    for (const methods::Claim& claim : claims) {
      if (certified.contains(claim.id)) {
        records.push_back(&prover_.prove(claim.id));
      }
    }
    return records;
  }

  // What lemmas speak of, and no statement.
  [[nodiscard]] std::string auxiliary_file(const std::vector<kernel::Definition>& said) const {
    std::string text = "(* What only lemmas speak of. *)\n" + requires_({"Calculus", "Definitions"});
    for (const kernel::Definition& definition : definitions_) {
      if (std::ranges::find(said, definition) == said.end()) {
        text += "\n" + coq_definition(definition);
      }
    }
    return text;
  }

  [[nodiscard]] static std::string requires_(const std::vector<std::string>& names) {
    return fmt::format("From Stickslip Require Import {}.\nOpen Scope R_scope.\n", fmt::join(names, " "));
  }

  void write(const Record& record) {
    const std::string& id = record.claim.id;
    Certificate certificate{
        .claim = id, .name = file_name(id), .theorems = {}, .imports = {}, .says = fingerprint(record)};
    Script script(certificate.name, library_);
    for (const NamedTheorem& one : named_theorems(record)) {
      certificate.theorems.push_back(one.name);
      certificate.immediate += is_immediate(one.theorem) ? 1 : 0;
      script.add(one.name, one.theorem, one.about);
    }
    if (certificate.theorems.empty()) {
      result_.uncertified.push_back({id, without_theorem(record)});
      return;
    }
    if (const std::size_t size = script.text().size(); size > most_characters) {
      throw kernel::KernelError(fmt::format(
          "its proof takes {} million characters, more than Coq reads in 1.5 GB", size / 1'000'000));
    }
    certificate.imports = script.imports();
    for (const kernel::Definition& definition : script.definitions()) {
      if (std::find(definitions_.begin(), definitions_.end(), definition) == definitions_.end()) {
        for (const kernel::Definition& other : definitions_) {
          if (definition_name(other) == definition_name(definition)) {
            throw kernel::KernelError("two definitions have the name " + other.name());
          }
        }
        definitions_.push_back(definition);
      }
    }
    // Calculus last: its names are those of Coq's own library.
    std::vector<std::string> needed{"Algebra"};
    needed.insert(needed.end(), script.needs().begin(), script.needs().end());
    needed.insert(needed.end(), {"Calculus", "Definitions", "Auxiliary"});
    needed.insert(needed.end(), certificate.imports.begin(), certificate.imports.end());
    std::string text = fmt::format("{}\n{}", requires_(needed), script.text());
    certificate.has_intervals = script.needs().contains("Numbers");
    if (certificate.has_intervals || std::ranges::any_of(certificate.imports, [&](const std::string& name) {
          return library_.slow.contains(name);
        })) {
      library_.slow.insert(certificate.name);
    }
    sizes_.emplace(certificate.name, text.size());
    result_.files.push_back({certificate.name + ".v", text});
    result_.certificates.push_back(certificate);
  }

  methods::Prover prover_;
  Library library_;
  Certificates result_;
  std::vector<kernel::Definition> definitions_;
  std::map<std::string, std::size_t> sizes_;  // of the files, in characters
  std::set<std::string> seen_;
};

}  // namespace

Certificates certificates(const std::vector<methods::Claim>& claims, const std::set<std::string>& ids,
                          const std::set<std::string>& kept,
                          const std::vector<kernel::Definition>& abbreviations) {
  for (const std::string& id : ids) {
    if (std::ranges::none_of(claims, [&](const methods::Claim& claim) { return claim.id == id; })) {
      throw InternalError(fmt::format("no claim has the id '{}'", id));
    }
  }
  Writer writer(claims);
  for (const methods::Claim& claim : claims) {
    if ((ids.empty() || ids.contains(claim.id) || kept.contains(claim.id)) && !interrupted()) {
      writer.add(claim.id);
    }
  }
  return writer.finished(claims, ids, abbreviations);
}

}  // namespace stickslip::proofs::certificates
