#!/bin/sh
# Makes the reports that the tests of tests/report/tools look at: the audit with what it said and its exit code, the
# errata, lists. Or makes the audit once more, beside the first, and compares the two.
#
#   report.sh PROGRAM DIRECTORY [again]
set -eu
audit() {
  # 2: something is undecided, which is for other tests to judge.
  code=0
  "$1" audit --json --out "$2" >"$2.json" 2>"$2.err" || code=$?
  echo $code >"$2.code"
  [ $code -eq 0 ] || [ $code -eq 2 ]
  cmp "$2.json" "$2/audit.json"
}
if [ "${3-}" = again ]; then
  rm -rf "$2/again"
  audit "$1" "$2/again"
  exec diff -r "$2/audit" "$2/again"
fi
rm -rf "$2"
mkdir -p "$2"
audit "$1" "$2/audit"
mkdir "$2/errata"
"$1" latex --errata >"$2/errata/errata.tex"
"$1" orbits overshooting --example O --out "$2/orbits" >/dev/null
"$1" orbits nonsticking --chi 0.3 --eta 4 --us 0.1 --V 0.1 --omega 0.6+-1e-6 --p 1 --digits 40 --out "$2/box" >/dev/null || [ $? -eq 2 ]
"$1" attractors --example P --starts 40 --out "$2/attractors" >/dev/null
"$1" branch symmetric --example S --omega 0.59..0.607 --out "$2/branches" >/dev/null
