#!/usr/bin/env bash
# Installs a build into STAGE; what is there knows neither the build nor the sources.
#
#   install.sh BUILD SOURCE STAGE
set -euo pipefail
build=$1 source=$2 stage=$3
rm -rf "$stage"
cmake --install "$build" --prefix "$stage" >/dev/null
for file in bin/stickslip include/stickslip/numeric/orbits.hpp share/stickslip/schema/orbits.schema.json \
  share/man/man1/stickslip.1 share/doc/stickslip/README.md share/doc/stickslip/doc/index.md; do
  [[ -e $stage/$file ]] || { echo "$file is not installed"; exit 1; }
done
# Debug information, which only some builds have, names the sources.
find "$stage" -name '*.a' -o -name '*.so' -o -path '*/bin/stickslip' | xargs strip --strip-debug
if grep -rlF -e "$build" -e "$source/" "$stage"; then
  echo "these speak of the place where the package was built"
  exit 1
fi
# Only what its own folder has, and no room under its bare name.
[[ $(ls "$stage/include") == stickslip ]] || { echo "headers lie outside include/stickslip"; exit 1; }
if grep -rn '#include "' "$stage/include"; then
  echo "these look for a header that is not under <stickslip/>"
  exit 1
fi
