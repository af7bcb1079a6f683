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
"$1" attractors --example O --starts 40 --most-periods 2000 --json >"$2/attractors.json"
"$1" attractors --example P --starts 40 --out "$2/attractors" >/dev/null
"$1" orbits S --example S --json >"$2/slip.json"
"$1" orbits T --example P --json >"$2/stick.json"
"$1" branch symmetric --example S --omega 0.59..0.607 --out "$2/branches" --json >"$2/branches.json"
"$1" orbits ST --example S --json >"$2/list.json"
"$1" orbits OSOTSOST --period 3 --example P --json >"$2/word.json"
"$1" simulate --example O --perturb 0.01,0,0,0 --json >"$2/simulation.json"
"$1" simulate --orbit nonsticking:1 --example P --periods 3 --csv "$2/samples.csv" --json >"$2/sampled.json"
"$1" atlas symmetric --example S --omega 0.55..0.57 --p 0..0.1 --resolution 4 --out "$2/atlas.h5" --json >"$2/atlas.json"
