#!/bin/sh
# Compiles NAME.tex of a report with plain latexmk, in a copy; fails when LaTeX has anything to remark.
#
#   paper.sh DIRECTORY NAME
#
# Debian's latexmk makes that possible, with texlive-latex-recommended and lmodern.
set -eu
report=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$report"/*.tex "$report"/*.pdf "$work"
cd "$work"
rm -f "$2.pdf"
latexmk -pdf -interaction=nonstopmode -halt-on-error "$2.tex" >output 2>&1 || {
  grep -a -A3 '^!' output >&2
  exit 1
}
test -s "$2.pdf"
if grep -aE 'Warning|Overfull' "$2.log" >&2; then exit 1; fi
# The report has the same document, made by the program.
cmp "$2.pdf" "$report/$2.pdf"
