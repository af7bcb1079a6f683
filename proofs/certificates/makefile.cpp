#include "proofs/certificates/makefile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip::proofs::certificates {

namespace {

const char * const rules =
    R"(# make -k -j: has Coq check the certificates that were asked for; what it says of each is in NAME.log.
# make Final.vo: then has it compare their theorems with Statements.v, and say in Final.log on what they rest. A file may take TIMEOUT seconds of processor time.
SHELL = /bin/bash
TIMEOUT ?= 600
# The heaps of OCaml: a tenth less time, and less memory, than with Coq's own choice.
export OCAMLRUNPARAM ?= s=8M,o=400
ifeq (,$(shell command -v coqc))
$(error there is no coqc here: install Debian's coq, libcoq-coquelicot and libcoq-interval)
endif
all: $(ASKED:=.vo)
%.vo: %.v
	@TIMEFORMAT='seconds %U'; ulimit -S -t $(TIMEOUT); \
	{ time coqc -w none -Q . Stickslip $< ; } > $*.log 2>&1 \
	  || { [ $$? = 152 ] && echo 'no end within $(TIMEOUT) seconds' >> $*.log; rm -f $@; echo "$*: Coq does not accept it: see $*.log"; exit 1; }
.PHONY: all
Matrices.vo:
Sentences.vo:
Programs.vo:
Reading.vo:
Polynomials.vo: Matrices.vo
Fractions.vo: Polynomials.vo
Algebra.vo: Sentences.vo Fractions.vo Reading.vo
Calculus.vo Inverses.vo: Algebra.vo
Numbers.vo: Algebra.vo Programs.vo
Krawczyk.vo Stability.vo Definitions.vo: Calculus.vo
Zeros.vo: Krawczyk.vo Numbers.vo
Auxiliary.vo Statements.vo: Definitions.vo
)";

}  // namespace

std::string makefile(const std::vector<Certificate>& certificates,
                     const std::map<std::string, std::size_t>& sizes) {
  // The longest first, so that in the end no process waits for another.
  std::vector<std::pair<std::size_t, std::string>> asked;
  std::set<std::string> names;
  for (const Certificate& certificate : certificates) {
    if (certificate.asked && names.insert(certificate.name).second) {
      asked.emplace_back(sizes.at(certificate.name), certificate.name);
    }
  }
  std::ranges::sort(asked, std::greater{});
  std::string text = "ASKED =";
  for (const auto& [size, name] : asked) {
    text += " " + name;
  }
  text += std::string("\n") + rules;
  names.clear();
  for (const Certificate& certificate : certificates) {
    if (!names.insert(certificate.name).second) {
      continue;
    }
    text += fmt::format("{}.vo: Inverses.vo Zeros.vo Stability.vo Auxiliary.vo", certificate.name);
    for (const std::string& import : certificate.imports) {
      text += fmt::format(" {}.vo", import);
    }
    text += "\n";
  }
  return text + "Final.vo: Statements.vo $(ASKED:=.vo)\n";
}

}  // namespace stickslip::proofs::certificates
