#!/usr/bin/env bash
# The version that the package bears is the one that is cited.
#
#   version.sh SOURCE VERSION
set -euo pipefail
grep -qx "version: $2" "$1/CITATION.cff" || { echo "CITATION.cff does not say version: $2"; exit 1; }
grep -q "^## $2" "$1/CHANGELOG.md" || { echo "CHANGELOG.md says nothing of $2"; exit 1; }
