#include "proofs/certificates/certificates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "proofs/certificates/coq_terms.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/certificates/statement_files.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::certificates {

namespace {

using methods::Outcome;
using methods::Record;

// Of a file: Coq has taken up to 1.5 GB for 2.8 million.
constexpr std::size_t most_characters = 4'000'000;
// From so many claims on, short ones share files of about so many characters, for Coq takes longer to load
// its libraries than to check them.
constexpr std::size_t many_claims = 100, shared_characters = 150'000;

bool uses_intervals(const std::set<std::string>& needs) {
  return needs.contains("Numbers");
}

// What encloses few numbers, and is short, coqchk, which has no virtual machine, comes to an end with.
bool has_many_enclosures(const std::string& text, const std::set<std::string>& needs) {
  constexpr std::size_t few = 5, is_short = 100'000;
  std::size_t count = 0;
  for (std::size_t at = text.find("_enclosure"); at != std::string::npos;
       at = text.find("_enclosure", at + 1)) {
    ++count;
  }
  return uses_intervals(needs) && (count > few || text.size() >= is_short || needs.contains("Zeros"));
}

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
    if (result_.certificates.size() >= many_claims) {
      share_files();
    }
    mark_asked(asked);
    for (const auto& [name, text] : prelude()) {
      result_.files.push_back({name, text});
    }
    const Records said = in_order(claims);
    result_.files.push_back({definitions_name, definitions_file(said)});
    result_.files.push_back({auxiliary_name, auxiliary_file(definitions_of(said))});
    result_.files.push_back({statements_name, statements_file(said, abbreviations)});
    const std::map<std::string, std::size_t> sizes = add_texts();
    std::vector<Proved> proved;
    for (const Certificate& one : result_.certificates) {
      if (one.asked) {
        proved.push_back({one.name, one.theorems});
      }
    }
    result_.files.push_back({final_name, final_file(proved)});
    result_.files.push_back({"Makefile", makefile(result_.certificates, sizes)});
    return std::move(result_);
  }

 private:
  // Claims that stand equally high above those that import nothing do not rest on each other: such of them
  // go together of which all, or none, load interval arithmetic, and use it; those that use it much are
  // checked alone.
  void share_files() {
    std::map<std::string, std::size_t> heights;
    std::map<std::pair<std::size_t, std::string>, std::vector<std::pair<std::string, std::size_t>>> groups;
    std::map<std::string, std::string> files;  // by claims' own names
    for (const Certificate& one : result_.certificates) {
      std::size_t height = 0;
      for (const std::string& import : one.imports) {
        height = std::max(height, heights.at(import) + 1);
      }
      heights.emplace(one.name, height);
      const Written& script = scripts_.at(one.name);
      files.emplace(one.name, one.name);
      if (!one.many_enclosures && script.text.size() < shared_characters) {
        const char * kind = uses_intervals(script.needs)       ? "_light"
                            : library_.slow.contains(one.name) ? "_slow"
                                                               : "";
        groups[{height, kind}].emplace_back(one.name, script.text.size());
      }
    }
    for (const auto& [of, members] : groups) {
      std::size_t number = 0, characters = 0;
      for (const auto& [name, size] : members) {
        if (number == 0 || characters + size > shared_characters) {
          ++number;
          characters = 0;
        }
        characters += size;
        files.at(name) = fmt::format("Claims_{}{}_{}", of.first, of.second, number);
      }
    }
    std::ranges::stable_sort(result_.certificates, {},
                             [&](const Certificate& one) { return heights.at(one.name); });
    std::map<std::string, std::set<std::string>> imports;
    for (const Certificate& one : result_.certificates) {
      for (const std::string& import : one.imports) {
        imports[files.at(one.name)].insert(files.at(import));
      }
    }
    for (Certificate& one : result_.certificates) {
      one.name = files.at(one.name);
      one.imports = imports[one.name];
    }
  }

  // The claims' files, and how long they are.
  std::map<std::string, std::size_t> add_texts() {
    std::map<std::string, std::set<std::string>> needs;
    std::map<std::string, std::string> texts;
    for (const Certificate& one : result_.certificates) {
      const Written& script = scripts_.at(file_name(one.claim));
      needs[one.name].insert(script.needs.begin(), script.needs.end());
      texts[one.name] += "\n" + script.text;
    }
    std::map<std::string, std::size_t> sizes;
    for (const Certificate& one : result_.certificates) {
      if (sizes.contains(one.name)) {
        continue;
      }
      // Calculus last: its names are those of Coq's own library.
      std::vector<std::string> needed{"Algebra"};
      needed.insert(needed.end(), needs[one.name].begin(), needs[one.name].end());
      needed.insert(needed.end(), {"Calculus", "Definitions", "Auxiliary"});
      needed.insert(needed.end(), one.imports.begin(), one.imports.end());
      result_.files.push_back({one.name + ".v", requires_(needed) + texts[one.name]});
      sizes.emplace(one.name, texts[one.name].size());
    }
    return sizes;
  }

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
    Records records;
    for (const methods::Claim& claim : claims) {
      if (scripts_.contains(file_name(claim.id))) {
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
    certificate.many_enclosures = has_many_enclosures(script.text(), script.needs());
    if (uses_intervals(script.needs()) ||
        std::ranges::any_of(certificate.imports,
                            [&](const std::string& name) { return library_.slow.contains(name); })) {
      library_.slow.insert(certificate.name);
    }
    scripts_.emplace(certificate.name, Written{script.text(), script.needs()});
    result_.certificates.push_back(certificate);
  }

  methods::Prover prover_;
  Library library_;
  Certificates result_;
  std::vector<kernel::Definition> definitions_;
  struct Written {
    std::string text;
    std::set<std::string> needs;
  };
  std::map<std::string, Written> scripts_;  // by file_name
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
