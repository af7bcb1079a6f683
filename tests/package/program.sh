#!/usr/bin/env bash
# Builds the program of the manual's page with the CMakeLists.txt beside it there; it prints what is shown. The
# machine's pkg-config knows neither GiNaC nor CLN nor HDF5, which stickslip::numeric does not need.
#
#   program.sh STAGE COMPILER PAGE
set -euo pipefail
stage=$1 compiler=$2 page=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for kind in cpp cmake; do
  sed -n "/^\`\`\`$kind$/,/^\`\`\`$/{/^\`\`\`/!p}" "$page" >"$work/$kind"
done
mv "$work/cpp" "$work/mine.cpp"
mv "$work/cmake" "$work/CMakeLists.txt"
sed -n '/^It prints$/,$p' "$page" | sed -n '/^```$/,/^```$/{/^```/!p}' >"$work/expected"
[[ -s $work/mine.cpp && -s $work/CMakeLists.txt && -s $work/expected ]] || { echo "the page shows no program"; exit 1; }
cat >"$work/pkg-config" <<EOF
#!/bin/sh
case "\$*" in *ginac*|*cln*|*hdf5*) exit 1 ;; esac
exec $(command -v pkg-config) "\$@"
EOF
chmod +x "$work/pkg-config"
cmake -S "$work" -B "$work/build" -G Ninja -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_BUILD_TYPE=Release \
  -D CMAKE_PREFIX_PATH="$stage" -D PKG_CONFIG_EXECUTABLE="$work/pkg-config" >/dev/null
cmake --build "$work/build" >/dev/null
"$work/build/mine" | diff "$work/expected" -
if objdump -p "$work/build/mine" | grep -E 'NEEDED.*(ginac|cln|hdf5|mpi)'; then exit 1; fi
