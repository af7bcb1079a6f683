#!/bin/sh
# Compiles NAME.tex of a report with pdflatex, in a copy; fails when LaTeX has anything to remark,
# or an option of a command is set so that it cannot be copied.
#
#   paper.sh DIRECTORY NAME [PAGES]
#
# With PAGES also when it has more of them, or no contents to find one's way by.
#
# Debian's texlive-latex-recommended makes that possible, with lmodern.
set -eu
report=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$report"/* "$work"
cd "$work"
rm -f "$2.pdf"
# The contents change the numbers of pages once.
for pass in 1 2 3; do
  pdflatex -interaction=nonstopmode -halt-on-error "$2.tex" >output 2>&1 || {
    grep -a -A3 '^!' output >&2
    exit 1
  }
done
test -s "$2.pdf"
# Two hyphens become a dash, which no shell takes.
if grep -n '\\texttt{[^}]*--' "$2.tex" >&2; then exit 1; fi
if grep -aE 'Warning|Overfull' "$2.log" >&2; then exit 1; fi
if [ $# -gt 2 ]; then
  pages=$(sed -n "s/^Output written on $2.pdf (\([0-9]*\) page.*/\1/p" "$2.log")
  if [ "$pages" -gt "$3" ]; then
    echo "$2.pdf has $pages pages, more than $3" >&2
    exit 1
  fi
  grep -q 'contentsline {section}' "$2.toc" || { echo "$2.pdf has no contents" >&2; exit 1; }
fi
# Where the report has that document, made by the program, it is the same.
if [ -e "$report/$2.pdf" ]; then cmp "$2.pdf" "$report/$2.pdf"; fi
