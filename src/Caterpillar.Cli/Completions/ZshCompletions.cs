namespace Caterpillar.Cli;

/// <summary>Completions for zsh.</summary>
internal static class ZshCompletions
{
    public static void Write(TextWriter text, CompletionTable table)
    {
        text.Write(EmbeddedText.Read("usage/completions.zsh", typeof(CompletionTable)));
        foreach (var verb in table.Verbs) text.WriteLine($"      {Quoted(verb.Name + ":" + verb.Description)}");
        text.WriteLine("    )");
        text.WriteLine("    _describe verb verbs ;;");
        text.WriteLine("  rest)");
        text.WriteLine("    case $line[1] in");
        foreach (var verb in table.Verbs)
        {
            text.WriteLine($"    {verb.Name})");
            text.Write("      _arguments -s");
            foreach (var option in verb.Options)
            {
                foreach (var name in option.Names) text.Write($" \\\n        {Quoted("*" + name + "[" + Plain(option.Description) + "]" + Value(option))}");
            }
            var rest = verb.TakesFiles ? "*:file:_files" : verb.Words.Count > 0 ? $"*:value:({string.Join(" ", verb.Words)})" : "";
            text.WriteLine(rest.Length > 0 ? $" \\\n        {Quoted(rest)} ;;" : " ;;");
        }
        text.WriteLine("    esac ;;");
        text.WriteLine("  esac");
        text.WriteLine("}");
        text.WriteLine("if [ \"$funcstack[1]\" = _caterpillar ]; then _caterpillar \"$@\"; else compdef _caterpillar caterpillar; fi");
    }

    private static string Value(CompletedOption option)
    {
        if (option.Takes.Length == 0) return "";
        var words = string.Join(" ", option.Words);
        var action = (option.Words.Count > 0, option.TakesFiles) switch
        {
            (true, true) => $"{{_alternative \"names:name:({words})\" \"files:file:_files\"}}",
            (true, false) when option.Continues => $"{{compadd -S \"\" {words}}}",
            (true, false) => $"({words})",
            (false, true) => "_files",
            _ => " ",
        };
        return ":" + Plain(option.Takes) + ":" + action;
    }

    // Brackets and colons have a meaning in specifications.
    private static string Plain(string description)
        => description.Replace("\\", "", StringComparison.Ordinal).Replace("[", "(").Replace("]", ")").Replace(":", "\\:").Replace("\"", "");

    private static string Quoted(string word) => "'" + word.Replace("'", "'\\''") + "'";
}
