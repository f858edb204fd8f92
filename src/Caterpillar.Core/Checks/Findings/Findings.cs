namespace Caterpillar.Checks;

/// <summary>
/// Findings of the checks of a toolpath: for each code the first, the worst and a count, with the severity of the printer. Only those two have messages.
/// </summary>
internal sealed class Findings
{
    // What is worse by less is not told: else a slow rise would have a message for each move.
    private const double Worse = 1.02;
    private readonly Dictionary<string, Severity?> _severities = new(StringComparer.Ordinal);
    private readonly List<Finding> _all = [];
    private readonly Dictionary<string, Finding> _ofCode = new(StringComparer.Ordinal);
    private readonly Func<int, SourceLocation?> _place;
    private readonly Func<MoveEvent, SourceLocation?> _placeOfEvent;

    /// <param name="printer">Sets their severities.</param>
    /// <param name="place">The place of a move; null = unknown.</param>
    /// <param name="placeOfEvent">The same of an event.</param>
    public Findings(Printer printer, Func<int, SourceLocation?> place, Func<MoveEvent, SourceLocation?> placeOfEvent)
    {
        foreach (var rule in CheckCodes.All) _severities[rule.Code] = rule.Severity;
        foreach (var own in printer.CheckSeverities) _severities[own.Code] = own.Severity;
        _place = place;
        _placeOfEvent = placeOfEvent;
    }

    public Findings(Printer printer, Toolpath toolpath)
        : this(printer, move => PlaceIn(toolpath, move), what => PlaceIn(toolpath, what))
    {
    }

    /// <summary>True if one of these codes is not off.</summary>
    public bool LooksFor(IEnumerable<string> codes) => codes.Any(c => _severities[c] is not null);

    /// <summary>Adds a finding at a move; the larger its size, the worse it is among those of its code.</summary>
    public void Add(string code, int move, Func<string> message, double size = 0) => Add(code, () => _place(move), message, size);

    public void Add(string code, Func<SourceLocation?> place, Func<string> message, double size = 0)
    {
        if (_severities[code] is { } severity) Add(code, severity, place, () => Made(message()), size);
    }

    /// <summary>Adds a finding whose message names the place of another move. That part of the message is made in the end, as places are.</summary>
    public void AddNaming(string code, int move, Func<Func<string>> message, double size = 0)
    {
        if (_severities[code] is { } severity) Add(code, severity, () => _place(move), message, size);
    }

    /// <summary>Adds a finding at an event that stands for several.</summary>
    public void Add(string code, MoveEvent what, Func<string> message, int count)
    {
        Add(code, () => _placeOfEvent(what), message);
        if (_ofCode.TryGetValue(code, out var finding)) finding.Count = count;
    }

    /// <summary>Adds a finding of a check of the user at a move.</summary>
    public void Add(Diagnostic found, int move) => Add(found.Code, found.Severity, () => _place(move), () => Made(found.Message), 0);

    /// <summary>The place of a move.</summary>
    public SourceLocation? PlaceOf(int move) => _place(move);

    /// <summary>The place of another move in brackets, for a message; nothing if it is unknown.</summary>
    public string InBrackets(int move) => move >= 0 && _place(move) is { } place ? $" ({place with { Origin = null, Step = null }})" : "";

    /// <summary>The place of an event.</summary>
    public SourceLocation? PlaceOfEvent(MoveEvent what) => _placeOfEvent(what);

    /// <summary>All findings. Their places are asked for now: the lines of a file may be known only in the end.</summary>
    /// <param name="moves">Number of moves of which each has at most one finding of a kind; 0 = no shares.</param>
    public IReadOnlyList<Diagnostic> ToList(int moves = 0)
        => _all.ConvertAll(f => f.ToDiagnostic() with { Share = moves > 0 ? Math.Min(1, f.Count / (double)moves) : 0 });

    private void Add(string code, Severity severity, Func<SourceLocation?> place, Func<Func<string>> message, double size)
    {
        if (!_ofCode.TryGetValue(code, out var first))
        {
            _ofCode.Add(code, first = new Finding(severity, code, place, message(), size));
            _all.Add(first);
            return;
        }
        first.Count++;
        if (!(first.WorstSize > 0) || !(size > first.WorstSize * Worse)) return;
        first.WorstSize = size;
        first.WorstOfAll = new Finding(severity, code, place, message(), size);
    }

    private static Func<string> Made(string message) => () => message;

    private static SourceLocation? PlaceIn(Toolpath toolpath, MoveEvent what)
    {
        int? move = what.Move < toolpath.Count ? what.Move : null;
        int? source = what.Source >= 0 ? what.Source : null;
        return toolpath.Source == MoveSource.Lines
            ? new SourceLocation(Line: source, Move: move)
            : new SourceLocation(Step: source, Move: move, Origin: toolpath.PlaceOfStep(what.Source));
    }

    /// <summary>The place of a move: its line or step, object and layer; null if the move does not exist.</summary>
    public static SourceLocation? PlaceIn(Toolpath toolpath, int move)
    {
        // Before the first move and after the last there is none to name.
        if (move < 0 || move >= toolpath.Count) return null;
        var (source, layer) = (toolpath[move].Source, toolpath[move].Layer);
        return toolpath.Source == MoveSource.Lines
            ? new SourceLocation(Line: source > 0 ? source : null, Move: move, Origin: toolpath.PlaceOfLayer(layer))
            : new SourceLocation(Step: source >= 0 ? source : null, Move: move, Origin: toolpath.PlaceOf(move));
    }

    // The first of a code, how many there are, and the worst of them.
    private sealed class Finding(Severity severity, string code, Func<SourceLocation?> place, Func<string> message, double size)
    {
        public int Count { get; set; } = 1;

        public double WorstSize { get; set; } = size;

        public Finding? WorstOfAll { get; set; }

        public Diagnostic ToDiagnostic() => new(severity, code, message(), place(), Count) { Worst = WorstOfAll?.ToDiagnostic() };
    }
}
