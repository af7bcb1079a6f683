#!/usr/bin/env bash
# script/audit --installed audits with the program that is installed, in a tree where nothing is built; without one it
# says so.
#
#   installed.sh SOURCE STAGE
set -euo pipefail
source=$1 stage=$2
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cp -r "$source/script" "$tree"
cat >"$tree/note.claims" <<'EOF'
paper A note
  author A. Reader
symbols a, b
claim square identity: the square
  (a + b)^2 = a^2 + 2 a b + b^2
EOF
PATH=$stage/bin:$PATH "$tree/script/audit" --installed "$tree/note.claims" >"$tree/said"
grep -q '^square ' "$tree/said" || { cat "$tree/said"; exit 1; }
[[ -s $tree/audit/index.html && ! -e $tree/build ]] || { echo "there is no report, or something was built"; exit 1; }
mkdir "$tree/bin"
for tool in bash dirname readlink; do
  ln -s "$(command -v $tool)" "$tree/bin"
done
if PATH=$tree/bin bash "$tree/script/audit" --installed >"$tree/said" 2>&1; then
  echo "it audits with a program that is not installed"
  exit 1
fi
grep -q 'no stickslip is installed' "$tree/said" || { cat "$tree/said"; exit 1; }
