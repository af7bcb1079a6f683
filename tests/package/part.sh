#!/usr/bin/env bash
# Configures a project that has this one as a part by add_subdirectory, and compiles its source.
#
#   part.sh PROJECT SOURCE COMPILER BUILD
set -euo pipefail
project=$1 source=$2 compiler=$3 build=$4
rm -rf "$build"
cmake -S "$project" -B "$build" -G Ninja -D CMAKE_CXX_COMPILER="$compiler" -D STICKSLIP_SOURCE="$source" \
  -D CMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
cmake --build "$build" --target CMakeFiles/consumer.dir/consumer.cpp.o
command=$(grep -F '"command"' "$build/compile_commands.json" | grep -F consumer.cpp)
for flag in -W -fPIC -ffp-contract "-I$source "; do
  [[ $command != *" $flag"* ]] || { echo "the consumer got $flag: $command"; exit 1; }
done
if cmake --build "$build" --target help | grep -E '^(pascal2012|section3|test_|stickslip_program)'; then
  echo "the consumer got these targets"
  exit 1
fi
