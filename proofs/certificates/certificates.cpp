#include "proofs/certificates/certificates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "proofs/certificates/prelude.hpp"
#include "proofs/certificates/script.hpp"
#include "proofs/certificates/statements.hpp"
#include "proofs/methods/prover.hpp"

namespace stickslip::proofs::certificates {

namespace {

using methods::Outcome;
using methods::Record;

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

  [[nodiscard]] Certificates finished(const std::set<std::string>& asked) {
    mark_asked(asked);
    for (const auto& [name, text] : prelude()) {
      result_.files.push_back({name, text});
    }
    std::string text = "(* The definitions that the certificates speak of. *)\n" + requires_({"Calculus"});
    for (const kernel::Definition& definition : definitions_) {
      text += "\n" + coq_definition(definition);
    }
    result_.files.push_back({"Definitions.v", text});
    result_.files.push_back({"Makefile", makefile()});
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
      script.add(one.name, one.theorem, one.about);
    }
    if (certificate.theorems.empty()) {
      result_.uncertified.push_back({id, without_theorem(record)});
      return;
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
    needed.insert(needed.end(), {"Calculus", "Definitions"});
    needed.insert(needed.end(), certificate.imports.begin(), certificate.imports.end());
    std::string text = fmt::format("{}\n{}", requires_(needed), script.text());
    if (script.needs().contains("Numbers")) {
      uses_intervals_.insert(certificate.name);
    }
    if (uses_intervals_.contains(certificate.name) ||
        std::ranges::any_of(certificate.imports,
                            [&](const std::string& name) { return library_.slow.contains(name); })) {
      library_.slow.insert(certificate.name);
    }
    std::string bundle = "no_more";
    for (auto name = certificate.theorems.rbegin(); name != certificate.theorems.rend(); ++name) {
      bundle = fmt::format("and_also {} {}", *name, bundle == "no_more" ? bundle : "(" + bundle + ")");
    }
    text += fmt::format("Definition theorems := {}.\n", bundle);
    sizes_.emplace(certificate.name, text.size());
    result_.files.push_back({certificate.name + ".v", text});
    result_.certificates.push_back(certificate);
  }

  // make -k -j: a file of its own for each claim, and what coqc says of it in NAME.log, with the seconds it
  // took. make again: coqchk once more, but not where it would have to go through interval arithmetic. make
  // axioms: what all theorems that were accepted rest on, of all together, for going through Coq's libraries
  // takes as long for one as for all.
  [[nodiscard]] std::string makefile() const {
    std::vector<std::string> names;
    std::transform(result_.certificates.begin(), result_.certificates.end(), std::back_inserter(names),
                   [](const Certificate& certificate) { return certificate.name; });
    std::string text =
        "# make -k -j: has Coq check the certificates that were asked for; what it says of each is in "
        "NAME.log.\n# make axioms: then has it say in Axioms.log what those that it accepted rest on.\n"
        "# A file may take TIMEOUT seconds of processor time.\nSHELL = /bin/bash\nTIMEOUT ?= 600\n"
        "# make again: has coqchk, a second checker, go through them once more, but not those that use "
        "interval "
        "arithmetic:\n# it has no virtual machine, and would take hours.\n"
        "ifeq (,$(shell command -v coqc))\n"
        "$(error there is no coqc here: install Debian's coq, libcoq-coquelicot and libcoq-interval)\n"
        "endif\nall:";
    // The longest first, so that in the end no process waits for another.
    std::vector<std::pair<std::size_t, std::string>> asked;
    for (const Certificate& certificate : result_.certificates) {
      if (certificate.asked) {
        asked.emplace_back(sizes_.at(certificate.name), certificate.name);
      }
    }
    std::ranges::sort(asked, std::greater{});
    for (const auto& [size, name] : asked) {
      text += fmt::format(" {}.vo", name);
    }
    text +=
        "\nAGAIN = Matrices Sentences Polynomials Fractions Algebra Calculus Inverses Krawczyk Stability "
        "Definitions";
    for (const auto& [size, name] : asked) {
      text += uses_intervals_.contains(name) ? "" : " " + name;
    }
    text += fmt::format("\nCLAIMS = {}\n", fmt::join(names, " "));
    text +=
        "%.vo: %.v\n"
        "\t@TIMEFORMAT='seconds %U'; ulimit -S -t $(TIMEOUT); \\\n"
        "\t{ time coqc -w none -Q . Stickslip $< ; } > $*.log 2>&1 \\\n"
        "\t  || { [ $$? = 152 ] && echo 'no end within $(TIMEOUT) seconds' >> $*.log; rm -f $@; echo \"$*: "
        "Coq does not accept it: see $*.log\"; exit 1; }\n"
        "%.chk: %.vo\n"
        "\t@ulimit -S -t $(TIMEOUT); coqchk -silent -Q . Stickslip -norec Stickslip.$* > $*.part 2>&1 \\\n"
        "\t  && mv $*.part $@ || { echo \"$*: coqchk does not accept it within $(TIMEOUT) s: see $*.part\"; "
        "exit 1; }\n"
        "# In four parts, for what a process has loaded it need not load again; where one fails, file by "
        "file.\n"
        "PARTS = again-1 again-2 again-3 again-4\n"
        "again: $(PARTS)\n"
        "$(PARTS): again-%:\n"
        "\t@names=; part=0; for name in $(AGAIN); do part=$$((part % 4 + 1)); \\\n"
        "\t    [ $$part = $* ] && [ -e $$name.vo ] && ! [ $$name.chk -nt $$name.vo ] && names=\"$$names "
        "$$name\"; done; \\\n"
        "\t  [ -z \"$$names\" ] || { ulimit -S -t $(TIMEOUT); coqchk -silent -Q . Stickslip $$(printf ' "
        "-norec "
        "Stickslip.%s' $$names) \\\n"
        "\t      > again-$*.log 2>&1 && touch $$(printf '%s.chk ' $$names); } \\\n"
        "\t    || $(MAKE) --keep-going --silent $$(printf '%s.chk ' $$names)\n"
        ".PHONY: all again $(PARTS) axioms\n"
        "axioms:\n"
        "\t@names=\"$$(for name in $(CLAIMS); do [ -e $$name.vo ] && $(MAKE) --question --silent $$name.vo "
        "\\\n"
        "\t    2> /dev/null && echo $$name; done)\"; \\\n"
        "\t  { echo From Stickslip Require Import Matrices. From Stickslip Require Algebra $$names.; echo "
        "Lemma every : proved.; \\\n"
        "\t    for name in $$names; do echo \"apply (Matrices.and_also $$name.theorems).\"; done; \\\n"
        "\t    echo exact Matrices.no_more. Qed. Print Assumptions every.; } > Axioms.new; \\\n"
        "\t  cmp -s Axioms.new Axioms.v || { mv Axioms.new Axioms.v; rm -f Axioms.log; }; rm -f Axioms.new; "
        "\\\n"
        "\t  for name in $$names; do [ $$name.vo -nt Axioms.log ] && rm -f Axioms.log; done; \\\n"
        "\t  [ -e Axioms.log ] || { coqc -w none -Q . Stickslip Axioms.v > Axioms.part 2>&1 && mv "
        "Axioms.part \\\n"
        "\t    Axioms.log; } || { echo 'Coq does not say what the theorems rest on: see Axioms.part'; exit "
        "1; }\n"
        "Matrices.vo:\nSentences.vo:\nPolynomials.vo: Matrices.vo\nFractions.vo: Polynomials.vo\n"
        "Algebra.vo: Sentences.vo Fractions.vo\nCalculus.vo Inverses.vo Numbers.vo: "
        "Algebra.vo\nKrawczyk.vo Stability.vo Definitions.vo: Calculus.vo\n";
    for (const Certificate& certificate : result_.certificates) {
      text += fmt::format("{}.vo: Inverses.vo Numbers.vo Krawczyk.vo Stability.vo Definitions.vo",
                          certificate.name);
      for (const std::string& import : certificate.imports) {
        text += fmt::format(" {}.vo", import);
      }
      text += "\n";
    }
    return text;
  }

  methods::Prover prover_;
  Library library_;
  Certificates result_;
  std::vector<kernel::Definition> definitions_;
  std::map<std::string, std::size_t> sizes_;  // of the files, in characters
  std::set<std::string> uses_intervals_;      // files
  std::set<std::string> seen_;
};

}  // namespace

Certificates certificates(const std::vector<methods::Claim>& claims, const std::set<std::string>& ids,
                          const std::set<std::string>& kept) {
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
  return writer.finished(ids);
}

}  // namespace stickslip::proofs::certificates
