using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// What checks find along a toolpath: for each kind the first place, the worst and a count, as serious as the printer says. Messages are made for those only.
/// </summary>
internal sealed class Findings
{
    // What is worse by less is not told: else a slow rise would have a message for each move.
    private const double Worse = 1.02;
    private readonly Dictionary<string, Severity?> _severities = new(StringComparer.Ordinal);
    private readonly DiagnosticList _list = new();
    private readonly Dictionary<string, Func<SourceLocation?>> _places = new(StringComparer.Ordinal);
    private readonly Dictionary<string, (double Size, Diagnostic? Finding, Func<SourceLocation?>? Place)> _worst = new(StringComparer.Ordinal);
    private readonly Func<int, SourceLocation?> _place;
    private readonly Func<MoveEvent, SourceLocation?> _placeOfEvent;

    /// <param name="printer">Says how serious they are.</param>
    /// <param name="place">The place of a move; null where there is none to name.</param>
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

    /// <summary>Hears of each finding at a move.</summary>
    public Action<string, int>? Heard { get; init; }

    /// <summary>True if one of these codes is not off, or somebody hears of all of them.</summary>
    public bool LooksFor(IReadOnlyList<string> codes)
    {
        for (var i = 0; i < codes.Count && Heard is null; i++)
        {
            if (_severities[codes[i]] is not null) return true;
        }
        return Heard is not null;
    }

    /// <summary>Adds a finding at a move; the larger its size, the worse it is among those of its code.</summary>
    public void Add(string code, int move, Func<string> message, double size = 0)
    {
        Heard?.Invoke(code, move);
        Add(code, () => _place(move), message, size);
    }

    public void Add(string code, Func<SourceLocation?> place, Func<string> message, double size = 0)
    {
        if (_severities[code] is not { } severity) return;
        if (!_list.Contains(code, severity))
        {
            _list.Add(severity, code, message());
            _places.Add(code, place);
            if (size > 0) _worst[code] = (size, null, null);
            return;
        }
        _list.Add(severity, code, "");
        if (_worst.TryGetValue(code, out var worst) && size > worst.Size * Worse)
            _worst[code] = (size, new Diagnostic(severity, code, message()), place);
    }

    /// <summary>The place of a move.</summary>
    public SourceLocation? PlaceOf(int move) => _place(move);

    /// <summary>The place of an event.</summary>
    public SourceLocation? PlaceOfEvent(MoveEvent what) => _placeOfEvent(what);

    /// <summary>All findings. Their places are asked for now: the lines of a file may be known only in the end.</summary>
    public IReadOnlyList<Diagnostic> ToList()
    {
        var list = _list.ToList().ToArray();
        for (var i = 0; i < list.Length; i++)
        {
            list[i] = list[i] with { Source = _places[list[i].Code]() };
            if (_worst.TryGetValue(list[i].Code, out var worst) && worst.Finding is not null)
                list[i] = list[i] with { Worst = worst.Finding with { Source = worst.Place!() } };
        }
        return list;
    }

    private static SourceLocation? PlaceIn(Toolpath toolpath, MoveEvent what)
    {
        int? move = what.Move < toolpath.Count ? what.Move : null;
        int? source = what.Source >= 0 ? what.Source : null;
        return toolpath.Source == MoveSource.Lines
            ? new SourceLocation(Line: source, Move: move)
            : new SourceLocation(Step: source, Move: move, Origin: toolpath.PlaceOfStep(what.Source));
    }

    /// <summary>Where a move comes from: its line or step, object and layer; null where there is no such move.</summary>
    public static SourceLocation? PlaceIn(Toolpath toolpath, int move)
    {
        // Before the first move and after the last there is none to name.
        if (move < 0 || move >= toolpath.Count) return null;
        var (source, layer) = (toolpath[move].Source, toolpath[move].Layer);
        return toolpath.Source == MoveSource.Lines
            ? new SourceLocation(Line: source > 0 ? source : null, Move: move, Origin: toolpath.PlaceOfLayer(layer))
            : new SourceLocation(Step: source >= 0 ? source : null, Move: move, Origin: toolpath.PlaceOf(move));
    }
}
