#!/usr/bin/env bash
# The report that the installed program makes of a paper of one's own: all pages, each claim, data as the schema says, and
# nothing of another paper.
#
#   report.sh STAGE PAPER VALIDATE
set -euo pipefail
stage=$1 paper=$2 validate=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$stage/bin/stickslip" audit "$paper" --out "$work" >"$work/said"
for file in index.html paper.html statements.html style.css katex.css filter.js audit.json audit.tex; do
  [[ -s $work/$file ]] || { echo "there is no $file"; exit 1; }
done
mapfile -t claims < <(sed -n 's/^claim \([a-z.]*\) .*/\1/p' "$paper")
((${#claims[@]} >= 18)) || { echo "only these claims are made: ${claims[*]}"; exit 1; }
for claim in "${claims[@]}"; do
  grep -qF "id=\"$claim\"" "$work/statements.html" || { echo "statements.html does not have $claim"; exit 1; }
done
# What text books say are statements, what is our own are claims beside them.
for claim in motion.every closing.amplitude resonance.equation; do
  grep -qF "statements.html#$claim" "$work/paper.html" || { echo "paper.html does not lead to $claim"; exit 1; }
done
if grep -F "statements.html#closing.third" "$work/paper.html"; then exit 1; fi
for words in "Of 8 statements of text books, 1 is proved; 5 are proved wherever" "claims of our own are counted apart: 1 converse, 7 new"; do
  grep -qF "$words" "$work/index.html" || { echo "index.html does not say: $words"; exit 1; }
done
grep -qF '"origin": "textbook"' "$work/audit.json" || { echo "audit.json does not say whose claims they are"; exit 1; }
# What has to be assumed stands there; and nobody printed anything.
grep -qF "1 - omega != 0" "$work/audit.json" || { echo "the hypotheses are not said"; exit 1; }
if grep -i "as printed" "$work/index.html"; then exit 1; fi
if grep -iE 'pascal|belt|fig\. [0-9]|u_s' "$work"/*.html "$work"/audit.*; then
  echo "these speak of another paper"
  exit 1
fi
"$validate" "$stage/share/stickslip/schema" audit.schema.json "$work/audit.json"
