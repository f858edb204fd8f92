namespace Caterpillar.Flavors;

/// <summary>Every command of every flavor, from <c>Commands.tsv</c>. A row is read when one of its commands is met.</summary>
internal sealed class CommandTable
{
    private static readonly Lazy<CommandTable> Shared = new(() => new CommandTable());
    private readonly string[] _notes;
    private readonly string[] _rows;
    private readonly ILookup<uint, string> _byHash;

    private CommandTable()
    {
        var lines = EmbeddedText.Lines("flavors/Commands.tsv");
        _notes = lines.TakeWhile(l => l[0] == '#').ToArray();
        _rows = lines.Skip(_notes.Length + 1).ToArray();
        _byHash = _rows.SelectMany(r => NamesOf(r).Select(n => (Row: r, Hash: CommandText.HashOf(n)))).ToLookup(r => r.Hash, r => r.Row);
    }

    /// <summary>The rows, in their order. Of those for one command the first that fits a line counts.</summary>
    public static IReadOnlyList<CommandRow> Rows => [.. Shared.Value._rows.Select(Row)];

    /// <summary>Short names of the sources and what they stand for.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Sources
        => [.. Shared.Value._notes.Where(l => l[1] != '\t').Select(l => l.Split('\t')).Select(c => new KeyValuePair<string, string>(c[0].Substring(1), c[1]))];

    /// <summary>The commands of the first flavor whose names have a hash, then those of the next; without flavors, of all.</summary>
    public static FlavorCommand[] WithHash(uint hash, string[] flavors)
        => Read(Shared.Value._byHash[hash], flavors).Where(c => CommandText.HashOf(c.Name) == hash).ToArray();

    /// <summary>The commands whose names end in a star.</summary>
    public static FlavorCommand[] Prefixes(string[] flavors)
        => Read(Shared.Value._rows.Where(r => NamesOf(r)[0].EndsWith("*", StringComparison.Ordinal)), flavors).ToArray();

    private static IEnumerable<FlavorCommand> Read(IEnumerable<string> lines, string[] flavors)
    {
        var rows = lines.Select(Row).ToArray();
        if (flavors.Length == 0) return rows.SelectMany(r => r.Commands);
        return flavors.SelectMany(f => rows.Where(r => r.Flavors.Contains(f)).SelectMany(r => r.Commands));
    }

    private static string[] NamesOf(string row) => row.Substring(0, row.IndexOf("\t", StringComparison.Ordinal)).Split(' ');

    private static CommandRow Row(string line)
    {
        var cells = line.Split('\t');
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
