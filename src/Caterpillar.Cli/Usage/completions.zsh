#compdef caterpillar
# zsh completions for caterpillar: put this file into a folder of $fpath, with the name _caterpillar
_caterpillar() {
  local -a found
  found=("${(@f)$(caterpillar completions zsh --line "${(j: :)words[1,CURRENT]}" 2>/dev/null)}")
  if [[ -z $found[1] ]]; then
    _files
  elif [[ $found[1] == *=:* ]]; then
    _describe value found -S ''
  else
    _describe value found
  fi
}
if [ "$funcstack[1]" = _caterpillar ]; then _caterpillar "$@"; else compdef _caterpillar caterpillar; fi
