namespace Caterpillar.Flavors;

/// <summary>Every command of every flavor, from <c>Commands.tsv</c>.</summary>
internal static class CommandTable
{
    private static readonly Lazy<(IReadOnlyList<CommandRow> Rows, IReadOnlyList<KeyValuePair<string, string>> Sources)> Table = new(Read);

    /// <summary>The rows, in their order. Of those for one command the first that fits a line counts.</summary>
    public static IReadOnlyList<CommandRow> Rows => Table.Value.Rows;

    /// <summary>Short names of the sources and what they stand for.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Sources => Table.Value.Sources;

    private static (IReadOnlyList<CommandRow> Rows, IReadOnlyList<KeyValuePair<string, string>> Sources) Read()
    {
        using var stream = typeof(CommandTable).Assembly.GetManifestResourceStream("flavors/Commands.tsv")!;
        using var reader = new StreamReader(stream);
        var rows = new List<CommandRow>();
        var sources = new List<KeyValuePair<string, string>>();
        foreach (var line in reader.ReadToEnd().Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries))
        {
            var cells = line.Split('\t');
            if (cells.Length == 7 && cells[0] != "command") rows.Add(Row(cells));
            else if (cells.Length == 2 && cells[0].Length > 1) sources.Add(new KeyValuePair<string, string>(cells[0].Substring(1), cells[1]));
        }
        return (rows, sources);
    }

    private static CommandRow Row(string[] cells)
    {
        var kind = Value<CommandClass>(cells[3]);
        var use = Value<CommandUse>(cells[4]);
        var commands = cells[0].Split(' ').Select(name => new FlavorCommand(name, cells[1], kind, use, cells[5], cells[6])).ToArray();
        return new CommandRow(commands, cells[2].Split(' '));
    }

    private static T Value<T>(string word)
        where T : struct
        => (T)Enum.Parse(typeof(T), string.Concat(word.Split('_')), true);
}

/// <summary>Commands with the same meaning, and their flavors. <c>buddy</c> and <c>fluidnc</c> are versions of Marlin 2 and Grbl.</summary>
internal sealed record CommandRow(IReadOnlyList<FlavorCommand> Commands, IReadOnlyList<string> Flavors);
