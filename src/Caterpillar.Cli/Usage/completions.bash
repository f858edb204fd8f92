# bash completions for caterpillar: source this file, or put it into ~/.local/share/bash-completion/completions/caterpillar
_caterpillar() {
  mapfile -t COMPREPLY < <(caterpillar completions bash --line "${COMP_LINE:0:COMP_POINT}" 2>/dev/null)
  if ((${#COMPREPLY[@]})); then
    [[ ${COMPREPLY[0]} != *= ]] || compopt -o nospace 2>/dev/null
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "${COMP_WORDS[COMP_CWORD]}")
  fi
}
complete -F _caterpillar caterpillar
