namespace Caterpillar.Flavors;

/// <summary>Every command of every flavor, from <c>Commands.tsv</c>. A row is read when one of its commands is met.</summary>
internal sealed class CommandTable
{
    private static readonly Lazy<CommandTable> Shared = new(() => new CommandTable());
    private readonly string[] _lines;

    // Places of names in the table, those of a hash one after the other: the line, and the place before.
    private readonly Dictionary<uint, int> _last = [];
    private readonly List<(int Line, int Before)> _places = [];
    private readonly List<int> _prefixes = [];

    private CommandTable()
    {
        using var stream = typeof(CommandTable).Assembly.GetManifestResourceStream("flavors/Commands.tsv")!;
        using var reader = new StreamReader(stream);
        _lines = reader.ReadToEnd().Split(['\r', '\n'], StringSplitOptions.RemoveEmptyEntries);
        for (var i = Header + 1; i < _lines.Length; i++) Index(i);
    }

    /// <summary>The rows, in their order. Of those for one command the first that fits a line counts.</summary>
    public static IReadOnlyList<CommandRow> Rows => [.. Shared.Value._lines.Skip(Shared.Value.Header + 1).Select(Row)];

    /// <summary>Short names of the sources and what they stand for.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Sources
        => [.. Shared.Value._lines.Take(Shared.Value.Header).Select(l => l.Split('\t')).Where(c => c[0].Length > 1)
            .Select(c => new KeyValuePair<string, string>(c[0].Substring(1), c[1]))];

    // The line with the names of the columns, after those of the sources.
    private int Header => Array.FindIndex(_lines, l => l[0] != '#');

    /// <summary>The commands of the first flavor whose names have a hash, then those of the next; without flavors, of all.</summary>
    public static FlavorCommand[] WithHash(uint hash, string[] flavors)
    {
        var table = Shared.Value;
        if (!table._last.TryGetValue(hash, out var place)) return [];
        var lines = new List<int>();
        for (; place >= 0; place = table._places[place].Before) lines.Insert(0, table._places[place].Line);
        return table.Read(lines, flavors).Where(c => CommandText.HashOf(c.Name, 0, c.Name.Length) == hash).ToArray();
    }

    /// <summary>The commands whose names end in a star.</summary>
    public static FlavorCommand[] Prefixes(string[] flavors) => Shared.Value.Read(Shared.Value._prefixes, flavors).ToArray();

    private void Index(int line)
    {
        var text = _lines[line];
        var end = text.IndexOf("\t", StringComparison.Ordinal);
        if (text[end - 1] == '*') _prefixes.Add(line);
        for (var (start, at) = (0, 1); at <= end; at++)
        {
            if (at < end && text[at] != ' ') continue;
            var hash = CommandText.HashOf(text, start, at);
            _places.Add((line, _last.TryGetValue(hash, out var before) ? before : -1));
            _last[hash] = _places.Count - 1;
            start = at + 1;
        }
    }

    private IEnumerable<FlavorCommand> Read(List<int> lines, string[] flavors)
    {
        var rows = lines.Select(l => Row(_lines[l])).ToArray();
        if (flavors.Length == 0) return rows.SelectMany(r => r.Commands);
        return flavors.SelectMany(f => rows.Where(r => r.Flavors.Contains(f)).SelectMany(r => r.Commands));
    }

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
