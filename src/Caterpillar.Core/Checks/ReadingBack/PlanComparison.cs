namespace Caterpillar.Checks;

/// <summary>
/// Holds moves that are read back from a file against those that were planned: each must end where it was planned to, and push as much material, within the
/// precision of print. What start and end code, templates and raw lines do is no part of the plan. The file may still be written while it is read.
/// </summary>
internal sealed class PlanComparison
{
    // Of the deviation of chords of an arc from the middle of the arc, mm.
    private const double ArcTolerance = 0.05;
    private Toolpath _plan;
    private readonly WrittenLines _lines;
    private readonly Findings _findings;
    private readonly double _allowed;
    private readonly double _allowedE;

    // What E has strayed from the plan, for each tool, and for the current one.
    private readonly Dictionary<int, double> _drifts = [];
    private double _drift;
    private int _tool;

    // The move of the plan that is compared next: its block, its place there, and its number.
    private int _block;
    private int _at;
    private int _move;

    // Where the head is by what was read.
    private Vec3 _head;
    private bool _known;
    private bool _began;

    // What was read of the next move so far, if anything.
    private bool _isOpen;
    private Vec3 _from;
    private double _e;
    private double _length;
    private bool _retracts;

    // How far the firmware has lifted the head with a retraction.
    private double _lift;

    /// <param name="plan">The plan.</param>
    /// <param name="format">The format of the file.</param>
    /// <param name="lines">The lines of the plan; those that are read are known.</param>
    /// <param name="findings">Gets errors <see cref="CheckCodes.FilePosition"/> and <see cref="CheckCodes.FileExtrusion"/>.</param>
    public PlanComparison(Toolpath plan, GCodeFormat format, WrittenLines lines, Findings findings)
    {
        _plan = plan;
        _lines = lines;
        _findings = findings;
        // Half of the last decimal, and rounding.
        _allowed = 0.5 * NumberFormatter.FromUnits(1, format.Printer.DecimalsXyz) + 1e-7;
        _allowedE = format.ExtruderLetter == 0 ? double.PositiveInfinity : NumberFormatter.FromUnits(1, format.Printer.DecimalsE) * 1.01 + 1e-8;
    }

    /// <summary>Codes of its findings.</summary>
    public static IReadOnlyList<string> Codes { get; } = [CheckCodes.FilePosition, CheckCodes.FileExtrusion];

    /// <summary>The plan is longer now.</summary>
    public void GoOn(Toolpath longer) => _plan = longer;

    /// <summary>The next moves that were read; <paramref name="start"/> is where the first of the file begins.</summary>
    public void Take(ToolpathColumns read, Vec3? start)
    {
        if (!_began) (_began, _known, _head) = (true, start is not null, start ?? Vec3.Zero);
        // What is read has been written: moves that are not taken down by now begin after it.
        var written = _lines.Moves;
        var next = 0;
        while (_move < written)
        {
            if (!_isOpen) next = Equal(read, next, written);
            if (_move == written || !Collect(read, ref next)) break;
            Compare();
        }
        if (_move == written) Skip(read, ref next, int.MaxValue);
    }

    /// <summary>The blocks from one on, and no more.</summary>
    public void End(Toolpath read, int block)
    {
        for (; block < read.Blocks.Count; block++) Take(read.Blocks[block].Columns, read.Start);
        if (!_began) (_known, _head) = (read.Start is not null, read.Start ?? Vec3.Zero);
        while (_move < _plan.Count)
        {
            Open();
            Compare();
        }
    }

    // Moves of one line each that are as planned, straight and by one tool: nearly all. Returns the first that is something else.
    [MethodImpl(Compile.Optimized)]
    internal int Equal(ToolpathColumns read, int next, int written)
    {
        var plan = _plan.Blocks[_block].Columns;
        if (plan.Arcs.Length > 0 || read.Arcs.Length > 0) return next;
        double[] x = read.X, y = read.Y, z = read.Z, e = read.E, planX = plan.X, planY = plan.Y, planZ = plan.Z, planE = plan.E;
        var (source, kind, tool, count) = (read.Source, read.Kind, plan.Tool, read.Count - 1);
        var (allowed, allowedE, drift) = (_allowed, _allowedE, _drift);
        var i = _at;
        var move = _move;
        var end = Math.Min(plan.Count, i + written - move);
        var from = next;
        for (; i < end && next < count; i++, move++, next++)
        {
            var (first, last) = _lines.OfMove(move);
            if (source[next] < first || source[next] != last || source[next + 1] <= last || tool[i] != _tool) break;
            var change = e[next];
            if (change == 0 && kind[next] is MoveKind.Retract or MoveKind.Deretract) break;
            var strayed = drift + (change - planE[i]);
            if (!(Math.Abs(x[next] - planX[i]) <= allowed && Math.Abs(y[next] - planY[i]) <= allowed && Math.Abs(z[next] - planZ[i]) <= allowed
                && Math.Abs(strayed) <= allowedE)) break;
            drift = strayed;
        }
        if (next == from) return next;
        _drift = drift;
        _head = new Vec3(x[next - 1], y[next - 1], z[next - 1]);
        _known = true;
        GoTo(move, i);
        return next;
    }

    // All that was read of the next move. False where more of it may come.
    private bool Collect(ToolpathColumns read, ref int next)
    {
        var (first, last) = _lines.OfMove(_move);
        if (!_isOpen && !Skip(read, ref next, first)) return false;
        Open();
        var turns = _plan.Blocks[_block].Columns.TryGetArc(_at, out _);
        for (; next < read.Count; next++)
        {
            if (read.Source[next] > last) return true;
            var end = new Vec3(read.X[next], read.Y[next], read.Z[next]);
            _e += read.E[next];
            _retracts |= read.E[next] == 0 && read.Kind[next] is MoveKind.Retract or MoveKind.Deretract;
            if (turns) _length += read.TryGetArc(next, out var arc) ? arc.Length(_head, end) : _head.DistanceTo(end);
            _head = end;
            _known = true;
        }
        return false;
    }

    // What is not the plan's: templates, raw lines. False where more of it may come.
    private bool Skip(ToolpathColumns read, ref int next, int first)
    {
        for (; next < read.Count; next++)
        {
            if (read.Source[next] >= first) return true;
            _head = new Vec3(read.X[next], read.Y[next], read.Z[next]);
        }
        return false;
    }

    private void Open()
    {
        if (_isOpen) return;
        (_isOpen, _from, _e, _length, _retracts) = (true, _head, 0, 0, false);
    }

    private void Compare()
    {
        var (plan, i, last) = (_plan.Blocks[_block].Columns, _at, _lines.OfMove(_move).Last);
        var wanted = new Vec3(plan.X[i], plan.Y[i], plan.Z[i]);
        if (_retracts) _lift = plan.Kind[i] == MoveKind.Retract ? Math.Max(_head.Z - wanted.Z, 0) : 0;
        wanted += new Vec3(0, 0, _lift);
        if (_known && !IsNear(_head, wanted)) Moved(last, wanted);
        else if (plan.TryGetArc(i, out var turn)) Turned(plan, i, last, turn, wanted);
        if (!_retracts) Extruded(plan, i, last);
        _isOpen = false;
        GoTo(_move + 1, i + 1);
    }

    private void GoTo(int move, int at)
    {
        (_move, _at) = (move, at);
        for (; _block < _plan.Blocks.Count && _at == _plan.Blocks[_block].Count; _at = 0) _block++;
    }

    private bool IsNear(Vec3 a, Vec3 b)
        => Math.Abs(a.X - b.X) <= _allowed && Math.Abs(a.Y - b.Y) <= _allowed && Math.Abs(a.Z - b.Z) <= _allowed;

    private void Moved(int line, Vec3 wanted)
    {
        var (at, move) = (_head, _move);
        _findings.Add(CheckCodes.FilePosition, () => WrittenPlaces.OfMove(_plan, _lines, move, line),
            () => $"The head is at {at} after this line, but the plan has {wanted}. Check templates and raw lines before it.");
    }

    private void Turned(ToolpathColumns plan, int i, int line, Arc arc, Vec3 wanted)
    {
        var start = i > 0 ? new Vec3(plan.X[i - 1], plan.Y[i - 1], plan.Z[i - 1]) : _plan.StartOf(_block);
        if (!IsNear(_from, start)) return;
        var (move, length, planned) = (_move, _length, arc.Length(start, wanted));
        if (Math.Abs(length - planned) <= ArcTolerance + planned * 0.01) return;
        _findings.Add(CheckCodes.FilePosition, () => WrittenPlaces.OfMove(_plan, _lines, move, line),
            () => $"The arc of this line is {NumberFormatter.Format(length, 2)} mm long, but the plan has {NumberFormatter.Format(planned, 2)} mm.");
    }

    private void Extruded(ToolpathColumns plan, int i, int line)
    {
        if (plan.Tool[i] != _tool)
        {
            _drifts[_tool] = _drift;
            _tool = plan.Tool[i];
            _drifts.TryGetValue(_tool, out _drift);
        }
        _drift += _e - plan.E[i];
        if (!(Math.Abs(_drift) > _allowedE + 1e-12 * Math.Abs(plan.E[i]))) return;
        _drift = 0;
        Report(_move, line, _e, plan.E[i]);
    }

    // Apart from the above, which would allocate what is captured here for each move.
    private void Report(int move, int line, double e, double planned)
        => _findings.Add(CheckCodes.FileExtrusion, () => WrittenPlaces.OfMove(_plan, _lines, move, line),
            () => $"E changes by {NumberFormatter.Format(e, 5)} in this line, but the plan has {NumberFormatter.Format(planned, 5)}.");
}
