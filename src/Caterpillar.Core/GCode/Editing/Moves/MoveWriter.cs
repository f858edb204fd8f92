namespace Caterpillar.GCode;

/// <summary>Writes moves: with the unchanged line of the file, after a line with the missing mode, with other words, or with new lines.</summary>
internal sealed class MoveWriter(SpliceContext context, MoveConversion conversion)
{
    private const double NoChange = SpliceContext.NoChange;
    private readonly GCodeInterpreter _written = context.Written;
    private readonly ParsedLine _line = context.Line;
    private readonly LineStyle _style = context.Style;
    private readonly SplicedText _text = context.Text;
    private readonly LineRewriter _rewriter = new(context.Style, context.Rules, context.Axis, context.Decoding.Axis);
    private readonly ParsedLine _inserted = new();
    private readonly double _tolerance = 0.5001 * NumberFormatter.FromUnits(1, context.Style.DecimalsXyz);

    // The state before the current line; one for all lines.
    private readonly InterpreterState _before = new();

    // What rounding has left of E, for each tool.
    private double[] _carried = new double[1];

    /// <summary>Writes the current line, or other lines in its place, so that they make the move.</summary>
    public void WriteMove(FileLine line, TargetMove move)
    {
        if (conversion.IsLost(move))
        {
            _text.Drop(_line);
            return;
        }
        move = conversion.Scale(move);
        Prepare(move);
        var before = _written.Save(_before);
        if (Does(line, move) && !MustRewrite(line))
        {
            CarryRounding(move);
            _text.Add(line);
            return;
        }
        if (context.Target is null && _written.LastMoves.Count == 1 && EndsRight(move))
        {
            _written.Restore(before);
            if (StateMissing(move, before) && Does(line, move))
            {
                _text.Add(line);
                return;
            }
        }
        _written.Restore(before);
        if (context.WriteModes()) _written.Save(before);
        if ((move.Arc is not null && !CanArc(move, before)) || context.LineBringsInches)
        {
            Replace(move);
            return;
        }
        _rewriter.Rewrite(_line, line, move, before, Command(move), Carried);
        _written.ReadLine(_rewriter.Bytes, 0, _rewriter.Count, out _);
        if (!MadeArc(move))
        {
            _written.Restore(before);
            _text.Drop(_line);
            InsertChords(move, move.Arc!.Value, before);
            return;
        }
        CarryRounding(move);
        _text.Add(_rewriter.Bytes, 0, _rewriter.Count, line);
    }

    /// <summary>Writes the current line as it is if it makes all moves from this task on. Otherwise nothing is written.</summary>
    public bool Keeps(FileLine line, IReadOnlyList<SpliceTask> tasks, int first)
    {
        var before = _written.Save();
        var keeps = _written.ReadLine(_line, line.Text, line.End, out _) == tasks.Count - first && !MustRewrite(line);
        var c = _written.LastMoves;
        for (var i = 0; i < c.Count && keeps; i++)
        {
            var move = tasks[first + i].Move;
            keeps = tasks[first + i].Event is null && Math.Abs(c.X[i] - move.X) <= NoChange && Math.Abs(c.Y[i] - move.Y) <= NoChange
                && Math.Abs(c.Z[i] - move.Z) <= NoChange && Math.Abs(c.E[i] - move.E) <= ToleranceE && c.Kind[i] == move.Kind;
        }
        if (keeps) _text.Add(line);
        else _written.Restore(before);
        return keeps;
    }

    /// <summary>A move as a line of its own.</summary>
    public void InsertMove(TargetMove move)
    {
        if (move.Kind == MoveKind.Dwell || conversion.IsLost(move)) return;
        Prepare(move);
        if (move.E == 0 && move.Kind is MoveKind.Retract or MoveKind.Deretract && context.Rules.FirmwareRetraction)
        {
            context.Command(move.Kind == MoveKind.Retract ? "G10" : "G11");
            return;
        }
        var before = _written.Save();
        if (move.Arc is { } arc && !CanArc(move, before))
        {
            InsertChords(move, arc, before);
            return;
        }
        var command = move.Arc is { } turn ? "G" + NumberFormatter.Format(context.Rules.ArcCode(turn.Plane, turn.Sweep < 0))
            : move.Kind == MoveKind.Travel && _style.TravelsByG0 ? "G0" : "G1";
        var bytes = Encoding.ASCII.GetBytes(_style.LowerCase ? command.ToLowerInvariant() : command);
        _inserted.Scan(bytes, 0, bytes.Length);
        _rewriter.Rewrite(_inserted, new FileLine(bytes, 0, bytes.Length, bytes.Length), move, before, Command(move), Carried);
        // Nothing but the command: no change that could be printed.
        if (_rewriter.Count <= bytes.Length) return;
        _written.ReadLine(_rewriter.Bytes, 0, _rewriter.Count, out _);
        if (!MadeArc(move))
        {
            _written.Restore(before);
            InsertChords(move, move.Arc!.Value, before);
            return;
        }
        CarryRounding(move);
        _text.AddOwn(_rewriter.Bytes, _rewriter.Count);
    }

    /// <summary>Writes a motion command without a move. It may set F. If it would move now, only F stays.</summary>
    public void WriteWithoutMove(FileLine line)
    {
        var before = _written.Save();
        if (_written.ReadLine(_line, line.Text, line.End, out _) == 0 && !context.LineBringsInches && !MustRewrite(line))
        {
            _text.Add(line);
            return;
        }
        _written.Restore(before);
        _text.Drop(_line);
        context.WriteModes();
        if (_line.TryGet('F', out var feed)) context.Command("G1", 'F', feed * context.Read.State.Modes.Unit / context.Unit, _style.DecimalsF);
    }

    // The move in lines of its own.
    private void Replace(TargetMove move)
    {
        _text.Drop(_line);
        InsertMove(move);
    }

    private void InsertChords(TargetMove move, Arc arc, InterpreterState before)
    {
        var start = before.Head.Machine;
        var end = move.End;
        var count = Math.Min(arc.ChordCount(start, end, conversion.ChordTolerance), 100_000);
        for (var k = 1; k <= count; k++)
        {
            var p = arc.PointAt(start, end, (double)k / count);
            InsertMove(move with { X = p.X, Y = p.Y, Z = p.Z, E = move.E / count, Arc = null });
        }
    }

    // What has to be in force before a move: its tool, the switch of the extruder, the mode of E.
    private void Prepare(TargetMove move)
    {
        if (move.Tool != _written.State.Tool && move.Tool >= 0)
        {
            if (move.Tool < context.Rules.ToolLimit) context.Event(new ToolEvent(move.Tool));
            else if (move.Tool > 0)
                context.Diagnostics.Add(Severity.Warning, "gcode.tools_lost", context.Rules.Title + " has no tool changes. They are left out.");
        }
        var on = _written.State.Extrusion.IsSwitchedOn;
        if (context.Axis == ExtrusionAxis.Switched && move.Kind == MoveKind.Print != on) context.Command(on ? "M103" : "M101");
        conversion.StateModeOfE(move.E);
    }

    // The motion command that a move needs: where nothing says E, G0 travels and G1 prints. -1 for any.
    private int Command(TargetMove move)
        => !_written.PrintsWithoutE ? -1 : move.Kind == MoveKind.Print ? 1 : context.Axis == ExtrusionAxis.Switched ? -1 : 0;

    private bool MustRewrite(FileLine line)
        => conversion.MustRewrite() || (context.Target is { LimitsDecimals: true } && _rewriter.IsTooFine(_line, line.Text));

    // Lines of state that let the rest of the file stay as it is: G92 E where E is absolute, F where it is inherited.
    private bool StateMissing(TargetMove move, InterpreterState before)
    {
        var done = false;
        var original = context.Read.LastMoves;
        var sameE = original.Count == 1 && Math.Abs(original.E[0] - move.E) <= NoChange;
        var extruder = context.Decoding.Axis.Letter;
        if (!_written.State.Modes.RelativeE && sameE && extruder != 0 && _line.Find((char)extruder) >= 0)
        {
            var unit = before.Modes.UnitOfE(context.Rules);
            var e = _line.Get((char)extruder, 0) * unit - move.E;
            if (Math.Abs(e - before.Extrusion.E) > NoChange)
            {
                context.Command("G92", (char)extruder, e / unit, Math.Max(_style.DecimalsE, 5));
                done = true;
            }
        }
        var sameSpeed = original.Count == 1 && Math.Abs(original.Speed[0] - move.Speed) <= 1e-9 * move.Speed;
        if (sameSpeed && move.Speed > 0 && _line.Find('F') < 0 && Math.Abs(move.Speed - before.Feed.Speed) > 1e-9 * move.Speed)
        {
            var modes = before.Modes;
            context.Command(modes.Motion == 0 ? "G0" : "G1", 'F', move.Speed * 60 / before.Feed.Factor / modes.Unit, _style.DecimalsF + (modes.Inches ? 2 : 0));
            done = true;
        }
        if (done) _written.Save(before);
        return done;
    }

    private bool Does(FileLine line, TargetMove move)
    {
        if (_written.ReadLine(_line, line.Text, line.End, out _) != 1) return false;
        var c = _written.LastMoves;
        var carried = context.Target is null ? 0 : Carried;
        var turns = _written.State.Rotary.Machine;
        return EndsRight(move) && move.Turns.DistanceTo(turns) <= SpliceContext.NoChange && Math.Abs(c.E[0] - move.E - carried) <= ToleranceE
            && (!(move.Speed > 0) || Math.Abs(c.Speed[0] - move.Speed) <= 1e-9 * move.Speed)
            && (!_written.PrintsWithoutE || c.Kind[0] == MoveKind.Print == (move.Kind == MoveKind.Print));
    }

    private bool EndsRight(TargetMove move)
    {
        var c = _written.LastMoves;
        return Math.Abs(c.X[0] - move.X) <= NoChange && Math.Abs(c.Y[0] - move.Y) <= NoChange && Math.Abs(c.Z[0] - move.Z) <= NoChange
            && IsSameArc(_written.LastArc, move.Arc);
    }

    // False where the line that was read last has made another arc than the one asked for.
    private bool MadeArc(TargetMove move) => move.Arc is null || (_written.LastMoves.Count == 1 && IsSameArc(_written.LastArc, move.Arc));

    private bool IsSameArc(Arc? a, Arc? b)
    {
        if (a is not { } x || b is not { } y) return a is null && b is null;
        var d = x.Center - y.Center;
        var off = x.Plane switch { ArcPlane.XY => d.WithZ(0), ArcPlane.ZX => new Vec3(d.X, 0, d.Z), _ => new Vec3(0, d.Y, d.Z) };
        return x.Plane == y.Plane && off.Length <= 2 * _tolerance && Math.Abs(x.Sweep - y.Sweep) < 1;
    }

    private bool CanArc(TargetMove move, InterpreterState state)
    {
        var rules = context.Rules;
        var head = state.Head;
        if (conversion.ExpandArcs || !rules.Arcs || (state.Modes.Relative && !rules.ArcsInRelativeMode)) return false;
        var arc = move.Arc!.Value;
        if (arc.Plane != state.Modes.Plane || (arc.Turns > 1 && rules.TurnsWord(arc.Turns) == 0)) return false;
        if (rules.HelixRisesFirst && Math.Abs(move.Z - head.Z - head.ShiftZ) > NoChange) return false;
        if (!rules.CounterclockwiseCircles && arc.Sweep > 359.999) return false;
        if (rules.ArcTolerance is { } tolerance && tolerance.Refuses(arc.Radius(head.Machine), arc.Radius(move.End))) return false;
        // With neither E nor switch every arc prints.
        return !_written.PrintsWithoutE || context.Axis == ExtrusionAxis.Switched || move.Kind == MoveKind.Print;
    }

    /// <summary>Rounding error of E of the current tool.</summary>
    public double Carried => _written.State.Tool < _carried.Length ? _carried[_written.State.Tool] : 0;

    /// <summary>Tolerance of E in a line.</summary>
    public double ToleranceE { get; } = context.Target is null ? NoChange : 0.5001 * NumberFormatter.FromUnits(1, context.Style.DecimalsE);

    /// <summary>Sets the rounding error of E that the next rewritten line makes up for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Carry(double carried)
    {
        var tool = _written.State.Tool;
        if (tool >= _carried.Length) Array.Resize(ref _carried, tool + 1);
        _carried[tool] = Math.Abs(carried) > 1 ? 0 : carried;
    }

    private void CarryRounding(TargetMove move)
    {
        if (context.Extruder == 0) return;
        var c = _written.LastMoves;
        Carry(Carried + move.E - (c.Count == 1 ? c.E[0] : 0));
    }
}
