#!/bin/sh
# Compiles NAME.tex of a report with plain latexmk, in a copy; fails when LaTeX has anything to remark.
#
#   paper.sh DIRECTORY NAME
#
# Exits with 77 when Debian's latexmk is not there, unless STICKSLIP_TOOLS is "required".
set -eu
if ! command -v latexmk >/dev/null; then
  [ "${STICKSLIP_TOOLS-}" = required ] && exit 1
  exit 77
fi
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
