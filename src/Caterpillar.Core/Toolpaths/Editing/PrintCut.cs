namespace Caterpillar.Toolpaths;

/// <summary>A place between two layers of a decoded print where it is cut in two. Start and end code stay outside of the print.</summary>
internal sealed class PrintCut
{
    private const double SameHeight = 1e-4;
    private const double Clearance = 5;
    private const double ZSpeed = 10;
    private readonly Toolpath _toolpath;
    private readonly int _upper;
    private readonly int _lowerEnd;
    private readonly int _printEnd;
    private readonly double _travelSpeed;

    private PrintCut(Toolpath toolpath, int lowerEnd, int upper, int printEnd, double height)
    {
        (_toolpath, _lowerEnd, _upper, _printEnd, Height) = (toolpath, lowerEnd, upper, printEnd, height);
        Retraction = LastMove(m => m.Kind == MoveKind.Retract && m.Tool == First.Tool);
        _travelSpeed = LastMove(m => m is { Kind: MoveKind.Travel, Speed: > 0 } && m.Start.Z == m.End.Z)?.Speed ?? First.Speed;
    }

    /// <summary>Top of the lower half, mm.</summary>
    public double Height { get; }

    /// <summary>Height above the lower half at which the head travels, mm.</summary>
    public double SafeHeight => Height + Clearance;

    /// <summary>Last line of the lower half, first line of the upper half, and last line of the print.</summary>
    public (int LowerEnd, int Upper, int PrintEnd) Lines => (LineOf(_lowerEnd - 1), LineOf(_upper), LineOf(_printEnd - 1));

    /// <summary>A retraction of the file. E is 0 if the firmware retracts (G10). Null = none.</summary>
    public Move? Retraction { get; }

    /// <summary>First move of the upper half.</summary>
    public Move First => _toolpath[_upper];

    /// <summary>The number after the last extrusion in a layer: the end code begins there. 0 = no layers.</summary>
    public static int EndOfPrint(Toolpath toolpath)
    {
        for (var block = toolpath.Blocks.Count - 1; block >= 0; block--)
        {
            var c = toolpath.Blocks[block].Columns;
            for (var i = c.Count - 1; i >= 0; i--)
            {
                if (IsPrinted(c, i)) return toolpath.FirstOf(block) + i + 1;
            }
        }
        return 0;
    }

    /// <summary>Finds the cut above the last layer whose top is not above <paramref name="z"/> mm.</summary>
    /// <returns>The cut, or the error <c>cut.outside</c> or <c>cut.sequential</c>.</returns>
    public static Result<PrintCut> At(Toolpath toolpath, double z)
    {
        int upper = -1, lowerEnd = 0, printEnd = 0;
        double height = 0, bottom = double.PositiveInfinity, top = 0;
        var isMixed = false;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (!IsPrinted(c, i)) continue;
                var layer = toolpath.Layers[c.Layer[i]].Z;
                (bottom, top) = (Math.Min(bottom, layer), Math.Max(top, layer));
                printEnd = toolpath.FirstOf(block) + i + 1;
                if (layer > z + SameHeight)
                {
                    if (upper < 0) upper = printEnd - 1;
                    continue;
                }
                isMixed |= upper >= 0;
                lowerEnd = printEnd;
                height = Math.Max(height, Math.Max(layer, c.Z[i]));
            }
        }
        if (isMixed)
            return new("cut.sequential", "The file prints objects one after the other, so no height divides it. Remove objects until one is left.");
        return upper >= 0 && lowerEnd > 0 ? new Result<PrintCut>(new PrintCut(toolpath, lowerEnd, upper, printEnd, height), [])
            : new Result<PrintCut>("cut.outside", printEnd == 0 ? "The file has no layers to cut between."
                : $"The layers reach from {NumberFormatter.Format(bottom, 3)} to {NumberFormatter.Format(top, 3)} mm. Cut in between.");
    }

    /// <summary>Start code, lower half, a lift to where the whole print ends, and the end code, which stays above the lower half.</summary>
    public Toolpath Lower()
    {
        var last = _toolpath[_lowerEnd - 1];
        var end = _toolpath[_printEnd - 1].End;
        var height = Math.Max(SafeHeight, end.Z);
        var block = _toolpath.BlockOf(_lowerEnd - 1);
        var editor = ToolpathBuilder.At(_toolpath, _toolpath.FirstOf(block));
        editor.Add(_toolpath.Blocks[block].Columns, 0, _lowerEnd - _toolpath.FirstOf(block));
        void Add(Vec3 to, double e, double speed, MoveKind kind) => editor.Add(to, e, 0, speed, kind, Role.Unspecified, last.Layer, last.Tool, -1, null);
        // Where the end code retracts, once is enough.
        var retracts = Retraction is not null && !Enumerable.Range(_printEnd, _toolpath.Count - _printEnd).Any(i => _toolpath[i].Kind == MoveKind.Retract);
        if (retracts) Add(last.End, Retraction!.Value.E, Retraction.Value.Speed, MoveKind.Retract);
        Add(last.End.WithZ(height), 0, ZSpeed, MoveKind.Travel);
        Add(end.WithZ(height), 0, _travelSpeed, MoveKind.Travel);
        CopyEnd(editor, height);
        var shift = _lowerEnd - _printEnd + (retracts ? 3 : 2);
        var lines = Lines;
        var events = _toolpath.Events
            .Where(e => e.Source < 0 ? e.Move < _lowerEnd || e.Move > _printEnd : e.Source <= lines.LowerEnd || e.Source > lines.PrintEnd)
            .Select(e => e.Move <= _lowerEnd ? e : e with { Move = e.Move + shift });
        return _toolpath.With([.. _toolpath.Blocks.Take(block), .. editor.ToBlocks()], events);
    }

    /// <summary>The upper half, which the head reaches from above, retracted, and the end code.</summary>
    public Toolpath Upper()
    {
        var first = First;
        var line = Lines.Upper;
        var block = _toolpath.BlockOf(_upper);
        var editor = ToolpathBuilder.At(_toolpath, _upper);
        void Add(Vec3 to, double e, double speed, MoveKind kind) => editor.Add(to, e, 0, speed, kind, Role.Unspecified, first.Layer, first.Tool, -1, null);
        Add(first.Start.WithZ(Math.Max(SafeHeight, first.Start.Z)), 0, _travelSpeed, MoveKind.Travel);
        Add(first.Start, 0, ZSpeed, MoveKind.Travel);
        if (Retraction is { } back) Add(first.Start, -back.E, back.Speed, MoveKind.Deretract);
        var shift = (Retraction is not null ? 3 : 2) - _upper;
        editor.Add(_toolpath.Blocks[block].Columns, _upper - _toolpath.FirstOf(block), _toolpath.Blocks[block].Count);
        var events = _toolpath.Events.Where(e => e.Source < 0 ? e.Move >= _upper : e.Source >= line).Select(e => e with { Move = e.Move + shift });
        return _toolpath.With([.. editor.ToBlocks(), .. _toolpath.Blocks.Skip(block + 1)], events);
    }

    // The end code, not below this height up to the first move that homes Z.
    private void CopyEnd(ToolpathBuilder editor, double height)
    {
        for (var number = _printEnd; number < _toolpath.Count; number++)
        {
            var move = _toolpath[number];
            var block = _toolpath.BlockOf(number);
            var (c, i) = (_toolpath.Blocks[block].Columns, number - _toolpath.FirstOf(block));
            if (_toolpath.HomeOf(move) is { Z: true }) height = double.NegativeInfinity;
            editor.Line = c.Line?[i] ?? 0;
            editor.Add(move.End.WithZ(Math.Max(move.End.Z, height)), move.E, move.Deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool,
                move.Source, move.Arc);
            editor.Turn(c, i);
        }
    }

    private Move? LastMove(Func<Move, bool> isWanted)
    {
        for (var i = _upper; i >= 0; i--)
        {
            if (_toolpath[i] is var move && isWanted(move)) return move;
        }
        return null;
    }

    private int LineOf(int move)
    {
        while (move > 0 && _toolpath[move].Source < 0) move--;
        return _toolpath[move].Source;
    }

    private static bool IsPrinted(ToolpathColumns c, int i) => c.Kind[i] == MoveKind.Print && c.Layer[i] >= 0 && c.Role[i] != Role.Purge;
}
