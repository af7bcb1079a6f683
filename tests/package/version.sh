#!/usr/bin/env bash
# The version that the package bears is the one that is cited; the manual has that of the formats.
#
#   version.sh SOURCE VERSION
set -euo pipefail
grep -qx "version: $2" "$1/CITATION.cff" || { echo "CITATION.cff does not say version: $2"; exit 1; }
grep -q "^## $2" "$1/CHANGELOG.md" || { echo "CHANGELOG.md says nothing of $2"; exit 1; }
[[ $(head -n 1 "$1/debian/changelog") == "stickslip ($2-"* ]] || { echo "debian/changelog does not begin with $2"; exit 1; }
layout=$(sed -nE 's/.* schema_version = "(.*)";/\1/p' "$1/report/tools/json.hpp")
grep -qF "now $layout |" "$1/doc/formats.md" || { echo "doc/formats.md does not say schema_version $layout"; exit 1; }
