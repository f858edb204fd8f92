namespace Caterpillar.Machines;

/// <summary>
/// Reads settings of PrusaSlicer: lines <c>key = value</c> of a preset or an exported configuration, also as comments, or a bundle of presets in sections
/// such as <c>[print:NAME]</c> with what they inherit.
/// </summary>
internal sealed class IniPresets(string file, List<Diagnostic> problems)
{
    private const int MaxDepth = 50;

    private readonly List<(string Section, int Line)> _order = [];
    private readonly Dictionary<string, Dictionary<string, string>> _sections = new(StringComparer.Ordinal);

    /// <summary>True if the first lines that are not comments are sections or assignments.</summary>
    public static bool IsIni(string text)
    {
        var lines = text.Split(['\r', '\n'], 100).Select(l => l.Trim()).Where(l => l.Length > 0 && l[0] is not ('#' or ';')).Take(5).ToArray();
        return lines.Length > 0 && lines.All(l => l[0] == '[' || Pair(l).Key is { Length: > 0 } key && key.All(c => char.IsLetterOrDigit(c) || c == '_'));
    }

    public static List<SlicerPreset> Read(string text, string file, List<Diagnostic> problems) => new IniPresets(file, problems).Read(text);

    private List<SlicerPreset> Read(string text)
    {
        var lines = text.Split('\n');
        var section = Section("", 1);
        for (var i = 0; i < lines.Length; i++)
        {
            var line = lines[i].Trim().TrimStart(';', '\uFEFF').Trim();
            if (line.Length == 0 || line[0] == '#') continue;
            if (line[0] == '[' && line[line.Length - 1] == ']') section = Section(line.Substring(1, line.Length - 2), i + 1);
            else if (Pair(line) is { Key.Length: > 0 } pair) section[pair.Key] = pair.Value;
        }
        return
        [
            .. from place in _order
               let parts = place.Section.Split([':'], 2)
               let name = parts.Length > 1 ? parts[1] : ""
               where parts[0] is "printer" or "print" or "filament" || (parts[0].Length == 0 && _sections[""].Count > 0)
               let values = name.Length == 0 ? _sections[place.Section] : Whole(parts[0], name, place.Line, 0)
               select new SlicerPreset(parts[0], name, values, name.StartsWith("*", StringComparison.Ordinal)),
        ];
    }

    private Dictionary<string, string> Section(string name, int line)
    {
        if (_sections.TryGetValue(name, out var known)) return known;
        _order.Add((name, line));
        return _sections[name] = new Dictionary<string, string>(StringComparer.Ordinal);
    }

    // Later parents replace values of earlier ones.
    private Dictionary<string, string> Whole(string kind, string name, int line, int depth)
    {
        var own = _sections[kind + ":" + name];
        var whole = new Dictionary<string, string>(StringComparer.Ordinal);
        var parents = own.TryGetValue("inherits", out var text) && depth < MaxDepth ? text.Split([';'], StringSplitOptions.RemoveEmptyEntries) : [];
        foreach (var parent in parents.Select(p => p.Trim().Trim('"')))
        {
            if (!_sections.ContainsKey(kind + ":" + parent))
            {
                problems.Add(new Diagnostic(Severity.Warning, "import.no_parent", $"{kind}:{name} inherits \"{parent}\", which the file does not contain.",
                    new SourceLocation(file, line)));
                continue;
            }
            foreach (var pair in Whole(kind, parent, line, depth + 1)) whole[pair.Key] = pair.Value;
        }
        foreach (var pair in own) whole[pair.Key] = pair.Value;
        return whole;
    }

    private static KeyValuePair<string, string> Pair(string line)
    {
        var equals = line.IndexOf('=', 0);
        return equals < 1 ? default : new KeyValuePair<string, string>(line.Substring(0, equals).Trim(), line.Substring(equals + 1).Trim());
    }
}
