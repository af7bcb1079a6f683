#!/usr/bin/env bash
# Has Coq check the proofs that the installed program writes of a paper of one's own.
#
#   coq.sh STAGE PAPER
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1/bin/stickslip" certify "$2" --out "$work" >/dev/null
count=$(ls "$work"/Claim_*.v | wc -l)
((count >= 12)) || { echo "only $count proofs were written"; exit 1; }
make -k -C "$work"
make -C "$work" Final.vo
