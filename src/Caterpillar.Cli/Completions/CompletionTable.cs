namespace Caterpillar.Cli;

/// <summary>Verbs, options and values for the completions of shells.</summary>
internal sealed record CompletionTable(IReadOnlyList<CompletedVerb> Verbs)
{
    /// <param name="root">The program with its verbs.</param>
    public static CompletionTable Of(Command root)
    {
        var general = root.Options.Where(o => o.Recursive && !o.Hidden).ToArray();
        var verbs = root.Subcommands.Select(verb => new CompletedVerb(
            verb.Name, Brief(verb.Description!),
            verb.Options.Concat(general).Where(o => !o.Hidden).Select(CompletedOption.Of).OrderBy(o => o.Name, StringComparer.Ordinal).ToArray(),
            verb.Arguments.SelectMany(a => Words(a.GetCompletions(CompletionContext.Empty))).ToArray(),
            verb.Arguments.Any(a => a.Name is "FILE" or "MODEL" or "SCRIPT"))).ToArray();
        return new CompletionTable(verbs);
    }

    /// <summary>The first sentence, up to a colon or semicolon, without a condition ("With --import: ").</summary>
    public static string Brief(string description)
    {
        if (description.StartsWith("With --", StringComparison.Ordinal) && description.IndexOf(": ", StringComparison.Ordinal) is > 0 and var colon)
            description = char.ToUpperInvariant(description[colon + 2]) + description[(colon + 3)..];
        var end = description.AsSpan().IndexOfAny(".;:(");
        while (end > 0 && end + 1 < description.Length && description[end] == '.' && description[end + 1] != ' ')
        {
            var more = description.AsSpan(end + 1).IndexOfAny(".;:(");
            end = more < 0 ? description.Length : end + 1 + more;
        }
        return (end < 0 ? description : description[..end]).Trim().Replace('\n', ' ');
    }

    public static IEnumerable<string> Words(IEnumerable<CompletionItem> items) => items.Select(i => i.InsertText ?? i.Label).Distinct();
}

/// <summary>A verb: its options, the values of its argument, and whether it takes files.</summary>
internal sealed record CompletedVerb(string Name, string Description, IReadOnlyList<CompletedOption> Options, IReadOnlyList<string> Words, bool TakesFiles);

/// <summary>An option: its names, the long one first, and its values.</summary>
/// <param name="Names">The names with their dashes.</param>
/// <param name="Description">A few words.</param>
/// <param name="Takes">Placeholder of the value in the help; empty for a switch.</param>
/// <param name="Words">Known values.</param>
/// <param name="TakesFiles">Its values are files or folders.</param>
internal sealed record CompletedOption(IReadOnlyList<string> Names, string Description, string Takes, IReadOnlyList<string> Words, bool TakesFiles)
{
    public string Name => Names[0];

    /// <summary>Known values are only the start of a value: <c>layer_height_mm=</c>.</summary>
    public bool Continues => Words.Count > 0 && Words.All(w => w.EndsWith('='));

    public static CompletedOption Of(Option option)
    {
        var isSwitch = option.ValueType == typeof(bool) || option.Arity.MaximumNumberOfValues == 0;
        var takes = isSwitch ? "" : option.HelpName ?? option.Name.TrimStart('-').ToUpperInvariant();
        var words = isSwitch ? [] : CompletionTable.Words(option.GetCompletions(CompletionContext.Empty)).ToArray();
        var files = takes.Contains("FILE", StringComparison.Ordinal) || takes.Contains("FOLDER", StringComparison.Ordinal);
        string[] names = [option.Name, .. option.Aliases.Where(a => a.StartsWith('-') && char.IsLetter(a[^1]))];
        return new CompletedOption(names.OrderByDescending(n => n.StartsWith("--", StringComparison.Ordinal)).ToArray(),
            CompletionTable.Brief(option.Description!), takes, words, files);
    }
}
