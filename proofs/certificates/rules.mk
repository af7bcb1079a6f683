# make -k -j: has Coq check the certificates that were asked for; what it says of each is in NAME.log.
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
