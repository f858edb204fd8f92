namespace Caterpillar.Checks;

/// <summary>Shows moves to checks, block by block.</summary>
/// <param name="checks">Who sees them.</param>
/// <param name="tools">The tools of the moves.</param>
/// <param name="cancel">Cancels.</param>
internal sealed class CheckRun(MoveCheck[] checks, IReadOnlyList<ToolpathTool> tools, CancellationToken cancel)
{
    private const int Pulse = 4096;
    private readonly double[] _volumes = tools.Select(t => t.VolumePerE ?? double.NaN).ToArray();
    private CheckedMove _seen;
    private bool _began;
    private bool _known;
    private bool _homes;

    /// <summary>Shows a whole toolpath.</summary>
    public static void Run(Toolpath toolpath, MoveCheck[] checks, IProgress<double>? progress, CancellationToken cancel)
    {
        if (checks.Length == 0) return;
        var run = new CheckRun(checks, toolpath.Tools, cancel);
        run.Take(toolpath, progress);
        run.End(toolpath);
    }

    /// <summary>Shows the next part of a toolpath, and returns it.</summary>
    public Toolpath Take(Toolpath part, IProgress<double>? progress = null)
    {
        foreach (var block in BlocksOf(part)) Block(block, at => progress?.Report(at / (double)part.Count));
        return part;
    }

    /// <summary>The blocks of a toolpath, with their events.</summary>
    public static IEnumerable<DecodedBlock> BlocksOf(Toolpath toolpath)
    {
        var next = 0;
        var thicknesses = toolpath.Layers.Select(l => l.Thickness).ToArray();
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var (first, events) = (toolpath.FirstOf(block), new List<MoveEvent>());
            for (; next < toolpath.Events.Count && toolpath.Events[next].Move < first + columns.Count; next++) events.Add(toolpath.Events[next]);
            yield return new DecodedBlock(columns, first, events.ToArray(), toolpath.Start, thicknesses);
        }
    }

    /// <summary>The next block; <paramref name="pulse"/> gets the number of the current move now and then.</summary>
    public void Block(DecodedBlock block, Action<int> pulse)
    {
        if (!_began) (_began, _known, _seen.End) = (true, block.Start is not null, block.Start ?? Vec3.Zero);
        var c = block.Columns;
        var next = 0;
        for (var i = 0; i < c.Count; i++)
        {
            if (i % Pulse == 0)
            {
                cancel.ThrowIfCancellationRequested();
                pulse(block.First + i);
            }
            HomeEvent? home = null;
            for (; next < block.Events.Length && block.Events[next].Move <= block.First + i; next++)
            {
                home = block.Events[next].Event as HomeEvent ?? home;
                foreach (var check in checks) check.Event(block.Events[next]);
            }
            Fill(ref _seen, block, c, i);
            _seen.IsHoming = home is not null && _seen.Kind == MoveKind.Travel && _seen.E == 0 && _seen.End == home.Home(_seen.Start);
            // Where a head comes from after it has homed is the machine's own.
            _seen.StartKnown = _known && !_homes && home is null;
            _seen.HomesFromKnown = _seen.IsHoming && _known && !_homes;
            _homes = _seen.IsHoming;
            _known = true;
            foreach (var check in checks) check.Move(_seen);
        }
    }

    /// <summary>After the last block: what happens after the last move.</summary>
    public void End(Toolpath toolpath)
    {
        for (var next = toolpath.FirstEventOf(toolpath.Count); next < toolpath.Events.Count; next++)
        {
            foreach (var check in checks) check.Event(toolpath.Events[next]);
        }
        foreach (var check in checks) check.End(toolpath);
    }

    private void Fill(ref CheckedMove move, DecodedBlock block, ToolpathColumns c, int i)
    {
        move.Index = block.First + i;
        move.Start = move.End;
        move.End = new Vec3(c.X[i], c.Y[i], c.Z[i]);
        move.StartTurns = move.EndTurns;
        move.EndTurns = c.TurnsAt(i, move.StartTurns);
        move.Kind = c.Kind[i];
        move.Role = c.Role[i];
        move.Layer = c.Layer[i];
        move.Tool = c.Tool[i];
        move.E = c.E[i];
        move.Speed = c.Speed[i];
        move.Arc = c.TryGetArc(i, out var arc) ? arc : null;
        move.Length = move.Arc is null ? move.Start.DistanceTo(move.End) : arc.Length(move.Start, move.End);
        var volume = move.Tool >= 0 && move.Tool < _volumes.Length ? _volumes[move.Tool] : double.NaN;
        move.Deposited = c.Deposited[i] * volume;
        move.Pushed = move.E * volume;
        move.Thickness = move.Layer >= 0 && block.Thicknesses is { } known ? known[move.Layer] : 0;
    }
}
