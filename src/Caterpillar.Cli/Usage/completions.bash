# bash completions for caterpillar: source this file, or put it into ~/.local/share/bash-completion/completions/caterpillar
_caterpillar() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} verb='' word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in -*) ;; *) verb=$word; break ;; esac
  done
  COMPREPLY=()
  [ "$cur" = = ] && cur=''
  case $verb in
