#!/usr/bin/env bash
# Has Coq check the proofs that a program on the installed package writes.
#
#   coq.sh PROGRAM
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$work" >/dev/null
count=$(ls "$work"/Claim_*.v | wc -l)
((count >= 12)) || { echo "only $count proofs were written"; exit 1; }
make -k -C "$work"
make -C "$work" Final.vo
