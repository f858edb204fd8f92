namespace Caterpillar.Jobs;

/// <summary>Start or end code: its valid lines, the modes that it sets and needs, and what decoding finds in it.</summary>
internal sealed class HeaderCode
{
    private const int AllAxes = 7;

    private static readonly Regex Size = new(
        @"([0-9]{2,5}(?:\.[0-9]{1,3})?)\s{0,3}(?:mm)?\s{0,3}[x×*]\s{0,3}"
        + @"([0-9]{2,5}(?:\.[0-9]{1,3})?)(?:\s{0,3}(?:mm)?\s{0,3}[x×*]\s{0,3}([0-9]{2,5}(?:\.[0-9]{1,3})?))?",
        RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);

    private readonly List<HeaderLine> _lines = [];
    private readonly DecodedGCode _decoded;

    // Axes whose position is known, as a mask.
    private int _known;
    private bool _hasMoved;

    public HeaderCode(string text, string file, DiagnosticList problems)
    {
        Read(text.TrimStart('\uFEFF').TrimEnd().Split(["\r\n", "\n", "\r"], StringSplitOptions.None), file, problems);
        foreach (var line in _lines) Follow(line);
        _decoded = GCodeDecoder.Decode(GCodeDocument.FromText(string.Join("\n", _lines.Select(l => l.Plain)))).OrThrow();
    }

    /// <summary>The lines. Invalid lines are kept as comments. The second side of a merge conflict is dropped.</summary>
    public IReadOnlyList<HeaderLine> Lines => _lines;

    /// <summary>G90 or G91, or null before either.</summary>
    public bool? Relative { get; private set; }

    /// <summary>M83 or M82, or null before either.</summary>
    public bool? RelativeE { get; private set; }

    public bool Inches { get; private set; }

    /// <summary>True if moves before the first G90 or G91 depend on the mode set before.</summary>
    public bool NeedsMode { get; private set; }

    /// <summary>True if E occurs before the first M82 or M83.</summary>
    public bool NeedsModeE { get; private set; }

    /// <summary>Minimum temperature for extrusion by M302, °C.</summary>
    public double? MinExtrusionTemperature { get; private set; }

    /// <summary>Size of the machine in a comment; Z is 0 if only X and Y are given.</summary>
    public Vec3? SizeInComment { get; private set; }

    /// <summary>The last temperature above 0 that is a number, °C.</summary>
    public double? NozzleTemperature => Hottest<NozzleTemperatureEvent>(e => e.Celsius);

    public double? BedTemperature => Hottest<BedTemperatureEvent>(e => e.Celsius);

    /// <summary>Bounds of the moves.</summary>
    public Bounds Seen => _decoded.Report.AllBounds;

    /// <summary>Number of tools, at most as many as a printer can have.</summary>
    public int ToolCount => Math.Min(64, _decoded.Toolpath.Tools.Count);

    /// <summary>Last position of the nozzle, or null if unknown.</summary>
    public Vec3? Position => _known == AllAxes && _hasMoved ? _decoded.Report.EndPosition : null;

    private void Read(string[] texts, string file, DiagnosticList problems)
    {
        // The first side of a merge conflict counts.
        var side = 0;
        for (var i = 0; i < texts.Length; i++)
        {
            var text = texts[i].TrimEnd();
            if (IsMarker(text, '<') || (IsMarker(text, '=') && side > 0) || IsMarker(text, '>'))
            {
                side = text[0] switch { '<' => 1, '=' => 2, _ => 0 };
                problems.Add(Severity.Warning, "header.merge_conflict",
                    "Merge conflict markers. The first version of each conflict is used.", new SourceLocation(file, i + 1));
                continue;
            }
            if (side == 2 || (texts.Length == 1 && text.Length == 0)) continue;
            var line = new HeaderLine(text);
            if (line.Error() is var (code, message, column))
            {
                problems.Add(Severity.Warning, code, message + " The line is kept as a comment.", new SourceLocation(file, i + 1, column));
                line = new HeaderLine("; invalid: " + text.Trim());
            }
            _lines.Add(line);
        }
    }

    private void Follow(HeaderLine line)
    {
        SizeInComment ??= SizeIn(line.Comment);
        if (line.Is('G', 20, 21)) Inches = line.Is('G', 20);
        else if (line.Is('G', 90, 91)) Relative = line.Is('G', 91);
        else if (line.Is('M', 82, 83)) RelativeE = line.Is('M', 83);
        else if (line.Is('G', 28)) _known |= Axes(line) is > 0 and var some ? some : AllAxes;
        else if (line.Is('G', 92)) _known |= Axes(line);
        // P0 switches the guard on again; S is its limit.
        else if (line.Is('M', 302) && line['P'] is not 0) MinExtrusionTemperature = line['S'] is >= 0 and <= 2000 and var least ? least : 0;
        if (!line.Is('G', 0, 1, 2, 3)) return;
        var axes = Axes(line);
        NeedsModeE |= line.Has('E') && RelativeE is null;
        NeedsMode |= axes != 0 && Relative is null;
        _hasMoved |= axes != 0;
        // A name in braces is no known position.
        if (Regex.IsMatch(line.Text, @"[XYZxyz]\s*\{")) _known = 0;
        else if (Relative != true) _known |= axes;
    }

    private double? Hottest<T>(Func<T, double> celsius)
        where T : PrinterEvent
        => _decoded.Toolpath.Events.Select(e => e.Event).OfType<T>().Select(e => (double?)celsius(e)).LastOrDefault(t => t is > 0 and <= 2000);

    private static int Axes(HeaderLine line) => (line.Has('X') ? 1 : 0) | (line.Has('Y') ? 2 : 0) | (line.Has('Z') ? 4 : 0);

    private static Vec3? SizeIn(string comment)
    {
        var match = Size.Match(comment);
        if (!match.Success) return null;
        double Part(int group) => NumberReader.TryParse(match.Groups[group].Value, out var value) && value >= 40 ? value : 0;
        return Part(1) > 0 && Part(2) > 0 ? new Vec3(Part(1), Part(2), Part(3)) : null;
    }

    private static bool IsMarker(string text, char c) => text.StartsWith(new string(c, 7), StringComparison.Ordinal) && (text.Length == 7 || text[7] == ' ');
}
