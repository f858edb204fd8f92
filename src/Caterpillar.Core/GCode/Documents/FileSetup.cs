namespace Caterpillar.GCode;

/// <summary>The setup of a print in the comments of its file, as <c>; key = value</c> with all keys of printer, material and settings.</summary>
public static class FileSetup
{
    private const string Block = BinaryComments.SetupBlock;

    private const string Begin = "; " + Block + " = begin";
    private const string End = "; " + Block + " = end";

    private static readonly string[] Names = [BinaryComments.FirstOfSetup, "material_name", "settings_name"];

    // Line ends within a value.
    private const string Break = "\\n";

    // Comments of hosts and thumbnails may follow.
    private const int MostLines = 100_000;

    /// <summary>True for names of files that may be G-code with a setup.</summary>
    public static bool IsName(string file)
    {
        if (file is null) throw new ArgumentNullException(nameof(file));
        var name = GzipReader.PlainName(file);
        return BinaryGCode.IsName(name) || Array.Exists([".gcode", ".gco", ".gc", ".g", ".nc"], e => name.EndsWith(e, StringComparison.OrdinalIgnoreCase));
    }

    /// <summary>Reads the setup of a file: text, gzip or binary.</summary>
    /// <inheritdoc cref="Read" path="/returns"/>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static Result<PrintSetup> ReadFile(string path)
    {
        if (!File.Exists(path)) return new("profile.not_found", $"File {path} not found.", new SourceLocation(path));
        var read = GCodeDocument.ReadFile(path);
        return read.Value is { } document ? Read(document) : new Result<PrintSetup>(null, read.Diagnostics);
    }

    /// <summary>Reads the setup of a document.</summary>
    /// <returns>
    /// The setup, or an error: <c>setup.not_in_file</c> if the file has none, <c>setup.damaged</c> if a part is missing, or an error that names the line and
    /// the key. Keys that the file does not have keep their defaults.
    /// </returns>
    public static Result<PrintSetup> Read(GCodeDocument document)
    {
        if (document is null) throw new ArgumentNullException(nameof(document));
        var number = document.LineCount;
        var last = Math.Max(number - MostLines, 0);
        while (number > last && document.Line(number).TrimEnd() != Begin) number--;
        if (number == last)
            return new("setup.not_in_file", "The file has no setup of Caterpillar in its comments. A printer can be imported from any G-code file.",
                new SourceLocation(document.Name));
        var names = new Dictionary<string, string>(StringComparer.Ordinal);
        var values = new List<(string, SourceLocation)>();
        while (true)
        {
            var line = ++number <= document.LineCount ? document.Line(number).TrimEnd() : "";
            if (line == End) break;
            var place = new SourceLocation(document.Name, number);
            var equals = line.IndexOf(" =", StringComparison.Ordinal);
            if (!line.StartsWith("; ", StringComparison.Ordinal) || equals < 0)
                return new("setup.damaged", $"The setup in the comments of the file is damaged: expected \"; key = value\" or \"{End}\".", place);
            var (key, value) = (line.Substring(2, equals - 2), Encoding.UTF8.GetString(TextEncoding.Encode(line.Substring(equals + 2))).Trim());
            if (Array.IndexOf(Names, key) >= 0 || key.StartsWith(Names[1] + "[", StringComparison.Ordinal)) names[key] = value;
            else values.Add((key + "=" + Words.Replaced(value, Break, "\n"), place with { Key = key }));
        }
        string Name(int which) => names.TryGetValue(Names[which], out var name) && name.Length > 0 ? name : "unnamed";
        var others = Enumerable.Range(1, names.Count).Select(i => SetupValues.OfTool(Names[1], i)).TakeWhile(names.ContainsKey).Select(i => names[i]);
        var plain = new PrintSetup(new Printer { Name = Name(0), Title = Name(0) }, new Material { Name = Name(1), Title = Name(1) },
            new PrintSettings { Name = Name(2), Title = Name(2) }) { ToolMaterials = new(others.Select(name => new Material { Name = name, Title = name })) };
        return SetupValues.Apply(plain, values);
    }

    /// <summary>The setup as comments.</summary>
    internal static IEnumerable<string> Lines(PrintSetup setup) =>
    [
        Begin,
        $"; {Names[0]} = {setup.Printer.Name}",
        $"; {Names[1]} = {setup.Material.Name}",
        .. setup.ToolMaterials.Select((m, i) => $"; {SetupValues.OfTool(Names[1], i + 1)} = {m.Name}"),
        $"; {Names[2]} = {setup.Settings.Name}",
        .. SetupValues.Of(setup, asGiven: true).Select(v => "; " + v.Key + " = " + Words.Replaced(v.Value, "\n", Break)),
        End,
    ];

    /// <summary>The setup among the comments of a file, names first; none if the file has none.</summary>
    internal static IReadOnlyList<KeyValuePair<string, string>> In(IReadOnlyDictionary<string, string> settings)
        => !settings.ContainsKey(Block) ? []
            : [.. Names.Concat(ProfileKeys.All.Select(k => k.Name)).Where(k => k != "title" && settings.ContainsKey(k))
                .Select(k => new KeyValuePair<string, string>(k, settings[k]))];

    /// <summary>The setup among the comments of a file, with the values of its first tool; null if the file has none.</summary>
    internal static PrintSetup? Of(IReadOnlyDictionary<string, string> settings)
    {
        var all = In(settings);
        var (names, values) = (all.TakeWhile(p => Names.Contains(p.Key)).ToArray(), all.SkipWhile(p => Names.Contains(p.Key)));
        var printer = new Printer { Title = names.FirstOrDefault().Value ?? "unnamed" };
        return names.Length == 0 ? null
            : SetupValues.Apply(new PrintSetup(printer, new Material(), new PrintSettings()), values.Select(p => p.Key + "=" + p.Value)).Value;
    }
}
