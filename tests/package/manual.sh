#!/usr/bin/env bash
# The manual pages and the completion that are installed know every command and every option that the help names.
#
#   manual.sh STAGE
set -euo pipefail
stage=$1
program=$stage/bin/stickslip
. "$stage/share/bash-completion/completions/stickslip"
# What is completed after these words, the last of which is not finished.
completed() {
  COMP_WORDS=(stickslip "$@") COMP_CWORD=$#
  _stickslip
  printf '%s\n' "${COMPREPLY[@]}"
}
mapfile -t commands < <("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p')
((${#commands[@]} > 5)) || { echo "only these commands are known: ${commands[*]}"; exit 1; }
for command in "${commands[@]}"; do
  grep -qx "$command" <(completed "${command:0:4}") || { echo "$command is not completed"; exit 1; }
  page=$(sed 's/\\-/-/g' "$stage/share/man/man1/stickslip-$command.1")
  mapfile -t options < <("$program" "$command" --help | grep -oE '^  (-h,)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
  ((${#options[@]} > 1)) || { echo "$command has only these options: ${options[*]}"; exit 1; }
  for option in "${options[@]}"; do
    grep -qF -- "$option\\fR" <<<"$page" || { echo "the page of $command does not name $option"; exit 1; }
    grep -qx -- "$option" <(completed "$command" "${option:0:5}") || { echo "$command $option is not completed"; exit 1; }
  done
done
# Families, examples, claims and expressions, in their places.
while read -r command begun word; do
  grep -qx -- "$word" <(completed $command "$begun") || { echo "after $command, $word is not completed"; exit 1; }
done <<EOF
orbits sym symmetric
branch over overshooting
atlas non nonsticking
check A5.un A5.unique
certify 44 44.H
latex cra cramer
latex 22.D 22.Delta
EOF
[[ $(completed orbits --example O) == O ]] || { echo "--example O is not completed"; exit 1; }
[[ $(completed latex --theorem uni) == uniqueness ]] || { echo "--theorem uniqueness is not completed"; exit 1; }
[[ -z $(completed simulate sym) ]] || { echo "simulate is no place for a family"; exit 1; }
[[ -z $(completed orbits --frob) ]] || { echo "--frob is completed"; exit 1; }
