#!/usr/bin/env bash
# Each installed header compiles alone, without a warning.
#
#   headers.sh STAGE COMPILER
set -euo pipefail
stage=$1
export COMPILER=$2 INCLUDE=$stage/include
compile() {
  echo "#include <$1>" | "$COMPILER" -std=c++20 -Wall -Wextra -pedantic -Werror -fsyntax-only -I "$INCLUDE" \
    $(pkg-config --cflags eigen3 | sed 's/-I/-isystem /g') -x c++ - || { echo "$1 does not compile alone"; return 1; }
}
export -f compile
headers=$(cd "$stage/include" && find stickslip -name '*.hpp')
[[ $(wc -l <<<"$headers") -gt 40 ]] || { echo "only these headers are installed: $headers"; exit 1; }
xargs -P "$(nproc)" -I {} bash -c 'compile {}' <<<"$headers"
