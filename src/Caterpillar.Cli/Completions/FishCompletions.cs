namespace Caterpillar.Cli;

/// <summary>Completions for fish.</summary>
internal static class FishCompletions
{
    public static void Write(TextWriter text, CompletionTable table)
    {
        text.WriteLine("# fish completions for caterpillar: put this file into ~/.config/fish/completions/caterpillar.fish");
        text.WriteLine("complete -c caterpillar -f");
        foreach (var verb in table.Verbs)
            text.WriteLine($"complete -c caterpillar -n __fish_use_subcommand -a {verb.Name} -d {Quoted(verb.Description)}");
        foreach (var verb in table.Verbs)
        {
            var line = $"complete -c caterpillar -n '__fish_seen_subcommand_from {verb.Name}'";
            if (verb.TakesFiles) text.WriteLine(line + " -F");
            if (verb.Words.Count > 0) text.WriteLine($"{line} -a {Quoted(string.Join(" ", verb.Words))}");
            foreach (var option in verb.Options)
            {
                var names = string.Join(" ", option.Names.Select(n => n.StartsWith("--", StringComparison.Ordinal) ? "-l " + n[2..] : "-s " + n[1..]));
                var value = option.Takes.Length == 0 ? "" : option.TakesFiles ? " -r -F" : " -x";
                var words = option.Words.Count > 0 ? " -a " + Quoted(string.Join(" ", option.Words)) : "";
                text.WriteLine($"{line} {names}{value}{words} -d {Quoted(option.Description)}");
            }
        }
    }

    private static string Quoted(string word) => "'" + word.Replace("\\", "\\\\").Replace("'", "\\'") + "'";
}
