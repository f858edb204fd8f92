namespace Caterpillar.GCode;

/// <summary>
/// Figures in lines of a file of which layers were removed: numbers and counts of layers, times, progress (M73), filament, heights. Times change as the sum of
/// length by speed of all moves does.
/// </summary>
internal sealed class PartFigures
{
    private const int LongestLine = 300;
    private const double NoChange = 1e-9;
    private const string Number = @"\d+(?:\.\d+)?";

    private static readonly (string Word, Regex Line)[] Lines =
    [
        ("LAYER", Of(@"^;\s*LAYER_COUNT:(?<count>\d+)|^;\s*LAYER[: ](?<layer>\d+)|CURRENT_LAYER=(?<next>\d+)|TOTAL_LAYER=(?<count>\d+)")),
        ("ayer", Of(@"^;\s*total layers count = (?<count>\d+)|^; total layer number: (?<count>\d+)|^; layer num/total_layer_count: (?<next>\d+)/(?<count>\d+)"
            + @"|^;\s*[Ll]ayer (?<layer>\d+)|num_layers = (?<count>\d+)")),
        ("TIME", Of($@"^;(?:PRINT\.)?TIME:(?<total>{Number})|^;TIME_ELAPSED:(?<elapsed>{Number})")),
        ("time", Of(@"^; estimated printing time.* = (?<duration>.*)|^; (?:model printing|total estimated) time: (?<duration>[^;]*)"
            + @"(?:; total estimated time: (?<duration>.*))?")),
        ("ilament", Of($@"^;\s*(?:total )?[Ff]ilament (?:used|cost|length|volume|weight).*?[=:]\s*(?:(?<amount>{Number})(?:cm3|mm3|mm|m|g|[ (),;])*)+")),
        ("VOLUME_USED", Of($@"VOLUME_USED:(?<amount>{Number})")),
        ("MAXZ", Of($@"^;MAXZ:(?<top>{Number})")),
        ("max_", Of($@"max_z_height: (?<top>{Number})|max_layer_z = (?<top>{Number})")),
        ("top of the", Of($@"^;(?<top>{Number}) mm is the top of the print")),
        ("M73 ", Of($@"^M73(?: P(?<percent>{Number})| R(?<left>{Number})| Q(?<percent>{Number})| S(?<left>{Number})| L(?<next>{Number})| C\d+| D\d+)+")),
    ];

    private readonly Dictionary<int, int> _numbers = [];
    private readonly int _oldFirst;
    private readonly int _first;
    private readonly double _filament;
    private readonly double _top;
    private readonly Clock _before;
    private readonly Clock _after;

    /// <param name="before">The toolpath of the file.</param>
    /// <param name="after">The edited toolpath.</param>
    /// <param name="counts">True to number the layers of the part from the first on. Otherwise they keep their numbers.</param>
    public PartFigures(Toolpath before, Toolpath after, bool counts)
    {
        (_before, _after) = (new Clock(before), new Clock(after));
        if (ReferenceEquals(before, after)) return;
        var (old, now) = (before.NumbersOfLayers(), after.NumbersOfLayers());
        IsActive = now.Count > 0 && now.Count < old.Count;
        if (!IsActive) return;
        // Rafts have numbers below 0.
        (_oldFirst, _first) = (old[0], counts && now[0] > old[0] ? Math.Max(old[0], 0) : old[0]);
        for (var i = 0; i < now.Count; i++) _numbers[now[i]] = counts ? _first + i : now[i];
        _filament = ToolpathTotals.Of(after).DepositedE / ToolpathTotals.Of(before).DepositedE;
        _top = after.UsedLayers().Max(l => l.Z);
    }

    /// <summary>True if figures may change.</summary>
    public bool IsActive { get; }

    /// <summary>The line with the figures of the part.</summary>
    public FileLine Image(FileLine line, int number)
    {
        if (!IsActive || line.End - line.Start is < 5 or > LongestLine) return line;
        var text = TextEncoding.Decode(line.Text, line.Start, line.End);
        return Image(text, number) is var changed && changed != text ? line.WithText(TextEncoding.Encode(changed)) : line;
    }

    /// <inheritdoc cref="Image(FileLine, int)"/>
    public string Image(string line, int number)
    {
        foreach (var (word, pattern) in Lines)
        {
            if (IsActive && line.IndexOf(word, StringComparison.Ordinal) >= 0 && pattern.IsMatch(line))
                return pattern.Replace(line, m => Changed(m, pattern.GetGroupNames(), number));
        }
        return line;
    }

    // From the last group to the first, so that their places hold.
    private string Changed(Match match, string[] names, int line)
    {
        var text = match.Value;
        var captures = names.Where(n => n.Length > 1).SelectMany(n => match.Groups[n].Captures.Cast<Capture>().Select(c => (Name: n, Capture: c)));
        foreach (var (name, capture) in captures.OrderByDescending(c => c.Capture.Index))
        {
            var at = capture.Index - match.Index;
            text = text.Substring(0, at) + Changed(name, capture.Value, line) + text.Substring(at + capture.Length);
        }
        return text;
    }

    private string Changed(string name, string text, int line)
    {
        if (name == "duration") return Duration(text);
        if (!NumberReader.TryParse(text, out var value)) return text;
        double Share(double of, double all) => all > 0 ? Math.Min(of / all, 1) : 1;
        int Layer(double old) => _numbers.TryGetValue((int)old, out var now) ? now : (int)old;
        var (before, after) = (_before.At(line), _after.At(line));
        var figure = name switch
        {
            "count" => _numbers.Count,
            "layer" => Layer(value),
            "next" => Layer(value - 1 + _oldFirst) + 1 - _first,
            "total" => value * Share(_after.Total, _before.Total),
            "elapsed" => value * Share(after, before),
            "left" => value * Share(_after.Total - after, _before.Total - before),
            "percent" => 100 * Share(after, _after.Total),
            "amount" => value * _filament,
            _ => _top,
        };
        var decimals = text.IndexOf(".", StringComparison.Ordinal) is >= 0 and var dot ? text.Length - dot - 1 : name == "top" ? 3 : 0;
        return Math.Abs(figure - value) < NoChange ? text : NumberFormatter.Format(figure, decimals);
    }

    // 1d 2h 3m 4s
    private string Duration(string text)
    {
        var seconds = 0.0;
        foreach (Match part in Regex.Matches(text, @"(\d+)\s*([dhms])"))
        {
            var unit = part.Groups[2].Value switch { "d" => 86400, "h" => 3600, "m" => 60, _ => 1 };
            seconds += unit * (NumberReader.TryParse(part.Groups[1].Value, out var count) ? count : 0);
        }
        if (seconds == 0) return text;
        return FileComments.Duration((long)(seconds * _after.Total / _before.Total + 0.5));
    }

    private static Regex Of(string pattern) => new(pattern, RegexOptions.CultureInvariant);

    /// <summary>Length by speed of the moves of a toolpath, in s, forward only.</summary>
    private sealed class Clock(Toolpath toolpath)
    {
        private double? _total;
        private double _seconds;
        private int _next;

        public double Total => _total ??= toolpath.Moves().Sum(Seconds);

        /// <summary>The time before a line.</summary>
        public double At(int line)
        {
            for (; _next < toolpath.Count && toolpath[_next] is var move && move.Source < line; _next++) _seconds += Seconds(move);
            return _seconds;
        }

        private static double Seconds(Move move) => move.Speed > 0 ? (move.Length > 0 ? move.Length : Math.Abs(move.E)) / move.Speed : 0;
    }
}
