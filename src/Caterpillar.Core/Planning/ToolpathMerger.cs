namespace Caterpillar.Planning;

/// <summary>
/// Writes toolpaths one after the other. Between two of them the head retracts, and travels over everything that is printed. Of decoded files only what is
/// between start and end code is taken.
/// </summary>
internal sealed class ToolpathMerger
{
    private readonly MoveEmitter _emitter;
    private readonly TravelPlanner _travel;
    private readonly DiagnosticList _diagnostics = new();
    private readonly int _tools;
    private bool _started;

    /// <param name="rules">The rules.</param>
    /// <param name="top">Top of what is printed on, mm; negative infinity for the bed.</param>
    public ToolpathMerger(PlanRules rules, double top)
    {
        // Over everything, as what lies on the straight line is not known.
        var settings = rules.Settings with { ZHopType = ZHopType.AbovePrint, ZHopMinTravel = 0, RetractionMinTravel = 0 };
        rules = rules with { Settings = settings, WipeDistance = 0 };
        var counts = new PlanReport();
        _emitter = new MoveEmitter(rules, new PlanOptions(), null, counts);
        _travel = new TravelPlanner(rules, _emitter, counts, null);
        _tools = rules.Tools.Length;
        _emitter.Reached(top);
    }

    /// <summary>The merged toolpath. No value if one uses a tool that the printer does not have.</summary>
    public Result<Toolpath> Run(IReadOnlyList<Toolpath> toolpaths, IProgress<double>? progress, CancellationToken cancel)
    {
        for (var i = 0; i < toolpaths.Count && !_diagnostics.HasErrors; i++)
        {
            Add(toolpaths[i], cancel);
            progress?.Report((i + 1.0) / toolpaths.Count);
        }
        return new Result<Toolpath>(_diagnostics.HasErrors ? null : _emitter.Build(null), _diagnostics.ToList());
    }

    private void Add(Toolpath toolpath, CancellationToken cancel)
    {
        var (first, end) = (0, toolpath.Count);
        if (toolpath.Source == MoveSource.Lines && PrintCut.EndOfPrint(toolpath) is > 0 and var last)
        {
            end = last;
            first = toolpath.Moves().First(m => m.Kind == MoveKind.Print && m.Layer >= 0).Index;
            _diagnostics.Add(Severity.Note, "merge.file", "The start and end code of a file is left out, as the new file gets that of the printer.");
        }
        var entry = first;
        // The travel to the first extrusion is another one.
        while (_started && entry < end && toolpath[entry].Kind == MoveKind.Travel) entry++;
        if (entry == end) return;
        var next = toolpath.FirstEventOf(first);
        for (; _started && next < toolpath.Events.Count && toolpath.Events[next].Move < entry; next++)
        {
            if (toolpath.Events[next].Event is not (ToolEvent or HomeEvent)) _emitter.Event(toolpath.Events[next].Event);
        }
        if (_started || first > 0) Approach(toolpath[entry]);
        for (var i = entry; i < end; i++)
        {
            if ((i & 0xFFF) == 0) cancel.ThrowIfCancellationRequested();
            for (; next < toolpath.Events.Count && toolpath.Events[next].Move <= i; next++) _emitter.Event(toolpath.Events[next].Event);
            if (!Copy(toolpath, toolpath[i])) return;
        }
        for (; end == toolpath.Count && next < toolpath.Events.Count; next++) _emitter.Event(toolpath.Events[next].Event);
        _started = true;
        _travel.Primed();
    }

    private void Approach(Move entry)
    {
        _travel.RetractFor(double.PositiveInfinity);
        if (entry.Tool != _emitter.Tool && entry.Tool >= 0 && entry.Tool < _tools) _emitter.SwitchTool(entry.Tool);
        _travel.To(entry.Start, direct: true, null);
        _travel.Restore();
    }

    private bool Copy(Toolpath toolpath, Move move)
    {
        if (move.Tool < 0 || move.Tool >= _tools)
        {
            _diagnostics.Add(Severity.Error, "plan.unknown_tool",
                $"A toolpath uses tool {NumberFormatter.Format(move.Tool)}, but the printer has {PlanRun.OnlyTools(_tools)}.");
            return false;
        }
        _emitter.Copy(move, move.Layer >= 0 ? toolpath.Layers[move.Layer] : null, toolpath.VolumePerE(move.Tool), toolpath.TurnsOf(move.Index));
        return true;
    }
}
