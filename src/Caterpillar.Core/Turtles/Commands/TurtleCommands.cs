namespace Caterpillar.Turtles;

/// <summary>One command of the language: its names and values.</summary>
/// <param name="Action">Its action.</param>
/// <param name="Name">Its name in scripts.</param>
/// <param name="Aliases">Other names, mostly of the libraries of the papers.</param>
/// <param name="Values">Names of its numbers. Names in brackets are optional.</param>
/// <param name="Text">Name of its text, or null. In brackets if it is optional.</param>
/// <param name="Help">One sentence.</param>
internal sealed record TurtleCommandInfo(
    TurtleAction Action, string Name, IReadOnlyList<string> Aliases, IReadOnlyList<string> Values, string? Text, string Help)
{
    /// <summary>Number of required numbers.</summary>
    public int Required { get; } = Values.Count(v => !v.StartsWith("[", StringComparison.Ordinal));

    /// <summary>True if its first three numbers are coordinates that <c>keep</c> can leave unchanged.</summary>
    public bool MayKeep => Action is TurtleAction.Position or TurtleAction.Jump;

    /// <summary>For example <c>forward distance [rise]</c>.</summary>
    public string Usage => string.Join(" ",
        new[] { Name }.Concat(Values).Concat(Text is null ? []
        : [Text.StartsWith("[", StringComparison.Ordinal) ? "[\"" + Text.Trim('[', ']') + "\"]" : "\"" + Text + "\""]));

    public override string ToString() => Usage;
}

/// <summary>All commands of turtle programs, from <c>TurtleCommands.tsv</c>.</summary>
internal static class TurtleCommands
{
    /// <summary>The commands in the order of the manual.</summary>
    public static IReadOnlyList<TurtleCommandInfo> All { get; } = [.. EmbeddedText.Rows("turtles/TurtleCommands.tsv").Skip(1).Select(Read)];

    private static Dictionary<string, TurtleCommandInfo> ByName { get; }
        = All.SelectMany(c => NamesOf(c).Select(name => (Name: name, Command: c))).ToDictionary(c => c.Name, c => c.Command, StringComparer.Ordinal);

    /// <summary>All names and aliases.</summary>
    public static IEnumerable<string> Names => All.SelectMany(NamesOf);

    /// <summary>The command of a name or alias, or null.</summary>
    public static TurtleCommandInfo? Find(string name) => ByName.TryGetValue(name, out var info) ? info : null;

    /// <summary>The command of an action.</summary>
    /// <exception cref="ArgumentException">Repeat, which has no values of its own.</exception>
    public static TurtleCommandInfo Of(TurtleAction action)
        => All.FirstOrDefault(c => c.Action == action) ?? throw new ArgumentException("This action is not a single command.", nameof(action));

    private static TurtleCommandInfo Read(string[] cells)
    {
        var action = (TurtleAction)Enum.Parse(typeof(TurtleAction), cells[0]);
        return new TurtleCommandInfo(action, cells[1], Words(cells[2]), Words(cells[3]), cells[4].Length > 0 ? cells[4] : null, cells[5]);
    }

    private static IEnumerable<string> NamesOf(TurtleCommandInfo command) => [command.Name, .. command.Aliases];

    private static string[] Words(string text) => text.Split([' '], StringSplitOptions.RemoveEmptyEntries);
}
