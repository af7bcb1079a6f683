# Completion of stickslip in bash: commands, options, what has a name, files.
_stickslip() {
  local words
  case $((COMP_CWORD > 1)):${COMP_WORDS[1]} in
{commands}  esac
  case ${COMP_WORDS[COMP_CWORD-1]} in
{values}  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "${COMP_WORDS[COMP_CWORD]}")
}
complete -o default -F _stickslip stickslip
