#!/bin/sh
# Makes the reports that the tests of tests/report/tools look at: the audit, twice, and a list of orbits.
#
#   report.sh PROGRAM DIRECTORY
set -eu
rm -rf "$2"
mkdir -p "$2"
audit() {
  # 2: something is undecided, which is for other tests to judge.
  "$1" audit --json --out "$2" >"$2.json" || [ $? -eq 2 ]
  cmp "$2.json" "$2/audit.json"
}
audit "$1" "$2/audit" &
audit "$1" "$2/again"
wait $!
"$1" orbits overshooting --example O --out "$2/orbits" >/dev/null
"$1" orbits nonsticking --chi 0.3 --eta 4 --us 0.1 --V 0.1 --omega 0.6+-1e-6 --p 1 --digits 40 --out "$2/box" >/dev/null || [ $? -eq 2 ]
"$1" attractors --example P --starts 40 --out "$2/attractors" >/dev/null
"$1" branch symmetric --example S --omega 0.59..0.607 --out "$2/branches" >/dev/null
