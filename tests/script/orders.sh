#!/usr/bin/env bash
# Runs the scripts of script/ one after the other, in every order, on a machine that is only played: dpkg-query, apt-get,
# cmake, ctest and what else they call stand first in PATH and keep, in files, what is installed, what the tree was
# configured with, and what was built. What the real ones refuse the played ones refuse too: a target that was not
# there when the tree was configured, a program that was not built, a test whose tools are missing.
#
#   orders.sh REPOSITORY
#
# A state is what is installed and what the tree knows of it. From the fresh machine on, every script is run in every
# state that any order of scripts leads to.
set -euo pipefail
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "orders: $*" >&2
  exit 1
}

bin=$work/bin
mkdir "$bin"
player() {
  { printf '#!/bin/bash\nset -eu\n'; cat; } >"$bin/$1"
  chmod +x "$bin/$1"
}
# Packages of a use, and whether all of them are in a file.
cat >"$bin/uses" <<'EOF'
has() {
  [[ -s $2 ]] && awk -v use="$1" 'NR == FNR { there[$1]; next } $1 == use && !($2 in there) { exit 1 }' "$2" \
    "$STATE/tree/script/packages.txt"
}
tree=$STATE/tree
refuse() { echo "$*" >&2; exit 1; }
EOF

player dpkg-query <<'EOF'
installed=" $(<"$STATE/installed") "
for package; do
  [[ ${installed//$'\n'/ } != *" $package "* ]] || echo "installed $package"
done
EOF
player apt-get <<'EOF'
. "${0%/*}/uses"
while [[ $1 != update && $1 != install ]]; do shift; done
[[ $1 == update ]] && exit 0
shift
# At once: others read it while this runs.
printf '%s\n' "$@" | grep -v '^-' | sort -u "$STATE/installed" - >"$STATE/installed.$$"
mv "$STATE/installed.$$" "$STATE/installed"
echo "$*" >"$STATE/asked"
EOF
player sudo <<'EOF'
exec "$@"
EOF
player cmake <<'EOF'
. "${0%/*}/uses"
has build "$STATE/installed" || refuse "cmake: not installed, or a library is missing"
preset=fuzz targets=()
building=
while (($#)); do
  case $1 in
    --build) building=yes; [[ $2 == --preset ]] || { preset=${2#build/}; shift; } ;;
    --preset) preset=$2; shift ;;
    -B) preset=${2#build/}; shift ;;
    --target) shift; targets=("$@"); break ;;
  esac
  shift
done
here=$tree/build/$preset
if [[ ! $building ]]; then
  mkdir -p "$here"
  cp "$STATE/installed" "$here/configured"
  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$tree" >"$here/CMakeCache.txt"
  touch "$here/build.ninja"
  exit 0
fi
[[ -f $here/configured ]] || refuse "cmake: $preset is not configured"
program() { mkdir -p "$here/$(dirname "$1")"; printf '#!/bin/sh\nexit 0\n' >"$here/$1"; chmod +x "$here/$1"; }
((${#targets[@]})) || { targets=(stickslip_program); has test "$here/configured" && targets+=(test_all); }
for target in "${targets[@]}"; do
  case $target in
    stickslip_program)
      program cli/stickslip
      # What it writes, where it is told to, and says of it: no certificate at all.
      printf '%s\n' 'case "$*" in *--record*) echo "0 of 0 theorems certified, 0 axioms"; exit ;; esac' \
        'while [ $# -gt 1 ] && [ "$1" != --out ]; do shift; done' \
        '[ $# -lt 2 ] || { mkdir -p "$2" && echo all: >"$2/Makefile"; }' | sed -i '1r /dev/stdin' "$here/cli/stickslip" ;;
    stickslip_python) has python "$here/configured" || refuse "cmake: unknown target $target"; program python/$target ;;
    stickslip_bench) has bench "$here/configured" || refuse "cmake: unknown target $target"; program bench/$target ;;
    test_*) has test "$here/configured" || refuse "cmake: unknown target $target"; program "tests/$target" ;;
    fuzz_*)
      has fuzz "$STATE/installed" && has test "$here/configured" || refuse "cmake: unknown target $target, or no clang"
      program "tests/fuzz/$target" ;;
    *) refuse "cmake: unknown target $target" ;;
  esac
done
EOF
player ctest <<'EOF'
. "${0%/*}/uses"
preset= log=/dev/null full=yes
while (($#)); do
  case $1 in
    --preset) preset=$2 ;;
    --output-log) log=$2 ;;
    --label-exclude) [[ $2 == *full* ]] && full= ;;
    --label-regex) full= ;;
  esac
  shift
done
here=$tree/build/$preset
has test "$here/configured" || refuse "ctest: No tests were found"
compgen -G "$here/tests/test_*" >/dev/null || refuse "ctest: the tests are not built"
if [[ $full ]]; then
  has full "$STATE/installed" && has pdf "$here/configured" || refuse "ctest: tests fail for want of tools"
fi
echo "100% tests passed, 0 tests failed out of ${full:+1}9" | tee "$log"
EOF
player clang-format <<'EOF'
. "${0%/*}/uses"
has check "$STATE/installed" || refuse "no clang-format"
EOF
player run-clang-tidy <<'EOF'
. "${0%/*}/uses"
has check "$STATE/installed" && [[ -f $tree/build/tidy/configured ]] || refuse "no clang-tidy, or nothing to read"
EOF
player git <<'EOF'
[[ $1 == status ]] || printf 'a.cpp\0'
EOF
for tool in doxygen sphinx-build; do
  player $tool <<'EOF'
. "${0%/*}/uses"
has doc "$STATE/installed" || refuse "no Doxygen, or no Sphinx"
EOF
done
player pdflatex <<'EOF'
EOF
player pandoc <<'EOF'
. "${0%/*}/uses"
has paper "$STATE/installed" || refuse "no pandoc"
EOF
player make <<'EOF'
. "${0%/*}/uses"
has certify "$STATE/installed" || refuse "no make, or no Coq"
EOF

# What changes what the others meet: the packages and the tree of the release preset. What only adds packages or trees
# of its own is run in every state, too, but leads to none that would be new to these.
changing=("audit" "test" "test --all" "bench --benchmark_filter=x" "bootstrap pdf")
others=("build" "doc" "paper" "release" "artifact" "certify" "mutants" "tidy core" "format --check" "sanitize asan --one-in 2 core" "sanitize debug" "fuzz 1")
said_last() {
  case $1 in
    "test") grep -qx '100% tests passed, 0 tests failed out of 9 (.*script/test --all.*)' ;;
    certify) grep -qx '0 of 0 theorems certified, 0 axioms' ;;
    "test --all" | ../.ci/run) grep -qx '100% tests passed, 0 tests failed out of 19 (all tiers but the nightly one)' ;;
    *) cat >/dev/null ;;
  esac
}

declare -A seen
queue=()
runs=0
# Takes the state in $work/next in, if it is new.
take() {
  local key
  key="installed: $(tr '\n' ' ' <"$work/next/installed") configured: $(cat "$work/next/tree/build/release/configured" 2>/dev/null || true)"
  [[ -v seen[$key] ]] && return 1
  seen[$key]=$1
  queue+=("$work/state-${#seen[@]}")
  cp -r "$work/next" "${queue[-1]}"
  echo "$1" >"${queue[-1]}/way"
}
# Runs a script of the tree in $work/next, which keeps its place, as a clone does.
run() {
  local words
  read -ra words <<<"$1"
  rm -f "$work/next/asked"
  STATE=$work/next PATH=$bin:$PATH "$work/next/tree/script/${words[0]}" "${words[@]:1}" >"$work/out" 2>"$work/err" </dev/null ||
    fail "after $2: $(tail -n 3 "$work/err")"
  tail -n 1 "$work/out" | said_last "$1" || fail "after $2: the last line is $(tail -n 1 "$work/out")"
  ((++runs))
}

mkdir -p "$work/next/tree/bench" "$work/next/tree/packaging" "$work/next/tree/paper"
cp -r "$root/script" "$root/.ci" "$work/next/tree"
# Makes nothing, but needs what it would be made with, and two runs make the same.
printf '#!/bin/bash\nset -eu\nmkdir -p "$1"\nfor use in build python cluster doc release; do %s; done\n' \
  '. "${STATE%/*}/bin/uses"; has $use "$STATE/installed" || refuse "make: nothing for $use"' >"$work/next/tree/packaging/make"
printf '#!/bin/bash\n[[ -d $1 ]]\n' | tee "$work/next/tree/packaging"/check_{debian,wheels,container} >/dev/null
chmod +x "$work/next/tree/packaging"/*
echo 'import pathlib, sys; (pathlib.Path(sys.argv[1]) / "map.csv").touch()' >"$work/next/tree/packaging/artifact.py"
# Sets nothing, but needs what it would be set with; for an artifact it would do without.
echo 'import subprocess, sys; sys.argv[2].endswith("build/paper") and subprocess.run(["pandoc"], check=True)' >"$work/next/tree/paper/make.py"
# Measures nothing, but needs what it would measure.
echo 'open("build/release/bench/stickslip_bench")' >"$work/next/tree/bench/measure.py"
for room in core symbolic numeric proofs report cli; do
  mkdir -p "$work/next/tree/$room" "$work/next/tree/tests/$room"
  touch "$work/next/tree/$room/CMakeLists.txt" "$work/next/tree/tests/$room/CMakeLists.txt"
done
touch "$work/next/installed"
take "a fresh machine"
# What calls the others.
for script in ../.ci/run nightly; do
  run "$script" "a fresh machine, $script"
  rm -rf "$work/next"
  cp -r "${queue[0]}" "$work/next"
done
while ((${#queue[@]})); do
  state=${queue[0]}
  queue=("${queue[@]:1}")
  for script in "${changing[@]}" "${others[@]}"; do
    rm -rf "$work/next"
    cp -r "$state" "$work/next"
    way="$(<"$state/way"), $script"
    run "$script" "$way"
    if [[ " ${changing[*]} " == *" $script "* ]] && take "$way"; then
      run "$script" "$way, again"
      [[ -f $work/next/asked ]] && fail "after $way, again: apt-get was asked for $(<"$work/next/asked")"
    fi
  done
  rm -rf "$state"
done
((${#seen[@]} > 10)) || fail "only ${#seen[@]} states were reached: the play is broken"
echo "orders: $runs runs from ${#seen[@]} states, none fails"
