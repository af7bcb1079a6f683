#!/bin/sh
# Has Coq compile what all certificates stand on, and the definitions and lemmas of those of 38.init.
#
#   prelude.sh PROGRAM DIRECTORY
set -eu
rm -rf "$2"
"$1" certify 38.init --out "$2" >/dev/null
make --silent --jobs=2 --directory="$2" Inverses.vo Zeros.vo Stability.vo Auxiliary.vo
