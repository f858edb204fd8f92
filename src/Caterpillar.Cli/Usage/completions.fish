# fish completions for caterpillar: put this file into ~/.config/fish/completions/caterpillar.fish
complete -c caterpillar -a '(caterpillar completions fish --line (commandline -cp | string collect) 2>/dev/null)'
