#compdef caterpillar
# zsh completions for caterpillar: put this file into a folder of $fpath, with the name _caterpillar
_caterpillar() {
  local context state line
  typeset -A opt_args
  _arguments -C '1: :->verb' '*:: :->rest' && return
  case $state in
  verb)
    local -a verbs=(
