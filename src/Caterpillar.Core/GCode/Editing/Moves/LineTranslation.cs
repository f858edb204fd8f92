namespace Caterpillar.GCode;

/// <summary>
/// Lines that the target of a conversion does not know, or reads in another sense: in its own words if it has any, otherwise left out and counted. The file
/// must home and heat after that, too.
/// </summary>
internal sealed class LineTranslation
{
    private const int MaxShown = 12;
    private readonly SpliceContext _context;
    private readonly FlavorRules _from;
    private readonly FlavorCommands _known;
    private readonly FlavorCommands _read;
    private readonly FlavorCommands _usual = FlavorCommands.Of(FlavorTable.Marlin2);
    private readonly ObjectMarks _objects;
    private readonly IReadOnlyList<string> _always;
    private readonly SortedDictionary<string, int> _lost = new(StringComparer.Ordinal);
    private readonly SortedDictionary<int, double> _nozzles = [];
    private double _bed = double.NaN;
    private bool _isAlways;
    private int _lostHoming;
    private int _lostHeat;
    private bool _homes;
    private bool _heats;
    private readonly int _firstPrint;

    /// <param name="context">The conversion.</param>
    /// <param name="hasStart">True if there is new start G-code, which homes and heats.</param>
    public LineTranslation(SpliceContext context, bool hasStart)
    {
        _homes = _heats = hasStart;
        (_context, _from) = (context, context.Decoding.Flavor);
        // The neutral flavor has all meanings.
        _read = FlavorCommands.Of(_from.Name == FlavorTable.Slicer.Name ? FlavorTable.Marlin2 : _from);
        _known = FlavorCommands.Of(context.Rules);
        _objects = new ObjectMarks(_from, context.Rules);
        _always = Equivalents.AlwaysOf(_from.Name, context.Rules.Name);
        _firstPrint = context.Decoding.PrintLines.First;
    }

    /// <summary>True if the target does not read the current line as the file's firmware does.</summary>
    public bool IsForeign(FileLine line)
    {
        var text = new CommandText(line.Text, _context.Line.CodeStart, _context.Line.CodeEnd);
        var there = _known.Find(text);
        var here = _read.Find(text);
        _isAlways = false;
        if (there is not { IsKnown: true } || _context.LineHomes) return there is not { IsKnown: true };
        foreach (var name in _always) _isAlways |= name.Length == text.Length && text.Begins(name, name.Length);
        if (_isAlways) return true;
        return here is { IsKnown: true } && (here.Class != there.Class || (here.Class == CommandClass.Object && _objects.Changes));
    }

    /// <summary>The current line in the words of the target, perhaps none.</summary>
    public IReadOnlyList<string> Lines(FileLine line)
    {
        var code = TextEncoding.Decode(line.Text, _context.Line.CodeStart, _context.Line.CodeEnd).Trim();
        var here = _read.Find(new CommandText(line.Text, _context.Line.CodeStart, _context.Line.CodeEnd));
        if (here?.Class == CommandClass.Object) return Counted(_objects.Lines(code), code, here);
        var events = _context.Read.LastEvents
            .SelectMany(e => EventText.Lines(e.Event, _context.Rules).Where(l => e.Event is AccelerationEvent or LimitEvent ? Says(l) : Knows(l))).ToArray();
        if (events.Length > 0) return events;
        if (here is { Class: CommandClass.Heat, Name: "M116" }) return Waits().Where(Says).ToArray();
        var lines = Equivalents.Of(code, _from.Name, _context.Rules.Name) ?? (_isAlways ? [code] : []);
        return Counted(lines.Where(Knows).ToArray(), code, here);
    }

    /// <summary>Reports what is left out, and whether the file still homes and heats.</summary>
    public void Report()
    {
        if (_lost.Count > 0)
        {
            var names = string.Join(", ", _lost.Take(MaxShown).Select(p => $"{p.Key} ({NumberFormatter.Format(p.Value)})"));
            if (_lost.Count > MaxShown) names += $" and {NumberFormatter.Format(_lost.Count - MaxShown)} more";
            var count = _lost.Values.Sum();
            _context.Diagnostics.Add(Severity.Warning, "gcode.commands_lost",
                $"{_context.Rules.Title} has no equivalent of {names}. They are left out.", count: count);
        }
        var lacks = new List<string>();
        if (_lostHoming > 0 && !_homes) lacks.Add("homes");
        if (_lostHeat > 0 && !_heats && _context.Axis.HasAmounts) lacks.Add("heats");
        if (lacks.Count == 0) return;
        _context.Diagnostics.Add(Severity.Error, "gcode.start_lost",
            $"In {_context.Rules.Title}, nothing {string.Join(" and ", lacks)} before the print. Give start G-code for this printer (--start-gcode).",
            new SourceLocation(Line: Math.Max(_lostHoming, _lostHeat)));
    }

    /// <summary>Takes what the line that was written last does before the first extrusion.</summary>
    public void Watch()
    {
        if (_context.Number > _firstPrint) return;
        foreach (var entry in _context.Written.LastEvents)
        {
            _homes |= entry.Event is HomeEvent;
            _heats |= entry.Event is NozzleTemperatureEvent { Celsius: > 0 };
        }
        foreach (var entry in _context.Read.LastEvents)
        {
            if (entry.Event is NozzleTemperatureEvent nozzle) _nozzles[nozzle.Tool ?? -1] = nozzle.Celsius;
            if (entry.Event is BedTemperatureEvent bed) _bed = bed.Celsius;
        }
    }

    private IEnumerable<string> Waits()
    {
        List<PrinterEvent> waits = [.. _nozzles.Select(n => new NozzleTemperatureEvent(n.Value, true, n.Key < 0 ? null : n.Key))];
        if (_bed > 0) waits.Insert(0, new BedTemperatureEvent(_bed, true));
        return waits.SelectMany(w => EventText.Lines(w, _context.Rules));
    }

    // Whether the target reads one of our lines in the sense of most firmwares.
    private bool Says(string line) => Knows(line) && (_usual.Find(line) is not { } usual || usual.Class == _known.Find(line)!.Class);

    private bool Knows(string line) => _known.Find(line) is { IsKnown: true };

    private IReadOnlyList<string> Counted(IReadOnlyList<string> lines, string code, FlavorCommand? here)
    {
        // What the decoder follows is in the moves.
        var isInMoves = here is { Use: CommandUse.Tracked, Class: CommandClass.Position or CommandClass.Flow or CommandClass.Mode or CommandClass.Motion };
        if (lines.Count > 0 || isInMoves || here?.Class == CommandClass.Object) return lines;
        var name = code.Split(' ')[0].ToUpperInvariant();
        _lost[name] = _lost.TryGetValue(name, out var count) ? count + 1 : 1;
        if (_context.Number >= _firstPrint) return lines;
        // A macro, which may do both.
        var isMacro = here is { Class: CommandClass.Flow } || (here is null && name.Length > 5 && char.IsLetter(name[1]));
        if (isMacro || here?.Class == CommandClass.Home) _lostHoming = _context.Number;
        if (isMacro || here?.Class == CommandClass.Heat) _lostHeat = _context.Number;
        return lines;
    }
}
