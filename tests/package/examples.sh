#!/usr/bin/env bash
# Builds a project of examples with the installed package; each says what stands beside it in NAME.out.
#
#   examples.sh EXAMPLES STAGE COMPILER BUILD
set -euo pipefail
examples=$1 stage=$2 compiler=$3 build=$4
rm -rf "$build"
cmake -S "$examples" -B "$build" -G Ninja -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_BUILD_TYPE=Release \
  -D CMAKE_PREFIX_PATH="$stage" -D CMAKE_CXX_FLAGS="-Wall -Wextra -pedantic -Werror" >/dev/null
cmake --build "$build"
count=0
for expected in "$examples"/*.out; do
  name=$(basename "$expected" .out)
  "$build/$name" | diff "$expected" -
  count=$((count + 1))
done
[[ $count == $(find "$build" -maxdepth 1 -type f -executable | wc -l) ]] || { echo "some program has no NAME.out"; exit 1; }
