namespace Caterpillar.Cli;

/// <summary>Completions for bash 4 and later.</summary>
internal static class BashCompletions
{
    public static void Write(TextWriter text, CompletionTable table)
    {
        text.Write(EmbeddedText.Read("usage/completions.bash", typeof(CompletionTable)));
        foreach (var verb in table.Verbs)
        {
            text.WriteLine($"  {verb.Name})");
            text.WriteLine("    case $prev in");
            foreach (var option in verb.Options.Where(o => o.Takes.Length > 0))
            {
                text.Write($"    {string.Join("|", option.Names)}) ");
                if (option.Continues) text.Write("compopt -o nospace 2>/dev/null; ");
                if (option.TakesFiles) text.Write("compopt -o filenames 2>/dev/null; ");
                var words = option.Words.Count > 0 ? $" -W '{string.Join(" ", option.Words)}'" : "";
                text.WriteLine(words.Length > 0 || option.TakesFiles
                    ? $"mapfile -t COMPREPLY < <(compgen{(option.TakesFiles ? " -f" : "")}{words} -- \"$cur\"); return ;;" : "return ;;");
            }
            text.WriteLine("    esac");
            text.WriteLine("    case $cur in");
            text.WriteLine($"    -*) mapfile -t COMPREPLY < <(compgen -W '{string.Join(" ", verb.Options.SelectMany(o => o.Names))}' -- \"$cur\"); return ;;");
            text.WriteLine("    esac");
            if (verb.Words.Count > 0) text.WriteLine($"    mapfile -t COMPREPLY < <(compgen -W '{string.Join(" ", verb.Words)}' -- \"$cur\")");
            if (verb.TakesFiles) text.WriteLine("    compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")");
            text.WriteLine("    return ;;");
        }
        text.WriteLine("  esac");
        text.WriteLine($"  mapfile -t COMPREPLY < <(compgen -W '{string.Join(" ", table.Verbs.Select(v => v.Name))} --help --version' -- \"$cur\")");
        text.WriteLine("}");
        text.WriteLine("complete -F _caterpillar caterpillar");
    }
}
