using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Holds a toolpath that was read back from a file against the one that was planned: each move must end where it was planned to, and push as much material,
/// within the precision of print. What start and end code, templates and raw lines do is no part of the plan.
/// </summary>
internal sealed class PlanComparison
{
    // Of the deviation of chords of an arc from the middle of the arc, mm.
    private const double ArcTolerance = 0.05;
    private readonly Toolpath _plan;
    private readonly Toolpath _read;
    private readonly WrittenLines _lines;
    private readonly Findings _findings;
    private readonly double _allowed;
    private readonly double _allowedE;
    private readonly bool _hasE;

    // What E has strayed from the plan, for each tool, and for the current one.
    private readonly Dictionary<int, double> _drifts = [];
    private double _drift;
    private int _tool;
    private int _block;
    private int _next;
    private Vec3 _head;
    private bool _known;

    private PlanComparison(Toolpath plan, Toolpath read, GCodeFormat format, WrittenLines lines, Findings findings)
    {
        _plan = plan;
        _read = read;
        _lines = lines;
        _findings = findings;
        // Half of the last decimal, and rounding.
        _allowed = 0.5 * NumberFormatter.FromUnits(1, format.DecimalsXyz) + 1e-7;
        _allowedE = NumberFormatter.FromUnits(1, format.DecimalsE) * 1.01 + 1e-8;
        _hasE = format.ExtruderLetter != 0;
        _head = read.Start ?? Vec3.Zero;
        _known = read.Start is not null;
    }

    /// <summary>What it finds.</summary>
    public static IReadOnlyList<string> Codes { get; } = [CheckCodes.FilePosition, CheckCodes.FileExtrusion];

    /// <summary>Adds errors <see cref="CheckCodes.FilePosition"/> and <see cref="CheckCodes.FileExtrusion"/>.</summary>
    public static void Run(Toolpath plan, Toolpath read, GCodeFormat format, WrittenLines lines, Findings findings)
        => new PlanComparison(plan, read, format, lines, findings).Run();

    private void Run()
    {
        for (var block = 0; block < _plan.Blocks.Count; block++)
        {
            var columns = _plan.Blocks[block].Columns;
            for (var i = 0; i < columns.Count; i++) Compare(columns, block, i);
        }
    }

    private void Compare(ToolpathColumns plan, int block, int i)
    {
        var move = _plan.FirstOf(block) + i;
        var (first, last) = _lines.OfMove(move);
        Skip(first);
        var e = 0.0;
        var retracts = false;
        var from = _head;
        var turns = plan.TryGetArc(i, out var turn);
        var length = 0.0;
        while (_block < _read.Blocks.Count)
        {
            var read = _read.Blocks[_block].Columns;
            if (_next == read.Count)
            {
                _block++;
                _next = 0;
                continue;
            }
            if (read.Source[_next] > last) break;
            var end = new Vec3(read.X[_next], read.Y[_next], read.Z[_next]);
            e += read.E[_next];
            retracts |= read.E[_next] == 0 && read.Kind[_next] is MoveKind.Retract or MoveKind.Restore;
            if (turns) length += read.TryGetArc(_next, out var arc) ? arc.Length(_head, end) : _head.DistanceTo(end);
            _head = end;
            _known = true;
            _next++;
        }
        var wanted = new Vec3(plan.X[i], plan.Y[i], plan.Z[i]);
        if (_known && !IsNear(_head, wanted)) Moved(move, last, wanted);
        else if (turns) Turned(plan, block, i, move, last, turn, from, wanted, length);
        if (_hasE && !retracts) Extruded(plan, i, move, last, e);
    }

    // What is not the plan's: templates, raw lines.
    private void Skip(int first)
    {
        for (; _block < _read.Blocks.Count; _block++, _next = 0)
        {
            var read = _read.Blocks[_block].Columns;
            for (; _next < read.Count; _next++)
            {
                if (read.Source[_next] >= first) return;
                _head = new Vec3(read.X[_next], read.Y[_next], read.Z[_next]);
            }
        }
    }

    private bool IsNear(Vec3 a, Vec3 b)
        => Math.Abs(a.X - b.X) <= _allowed && Math.Abs(a.Y - b.Y) <= _allowed && Math.Abs(a.Z - b.Z) <= _allowed;

    private void Moved(int move, int line, Vec3 wanted)
    {
        var at = _head;
        _findings.Add(CheckCodes.FilePosition, () => WrittenPlaces.OfMove(_plan, move, line),
            () => $"The head is at {at} after this line; the plan has it at {wanted}.");
    }

    private void Turned(ToolpathColumns plan, int block, int i, int move, int line, Arc arc, Vec3 from, Vec3 wanted, double length)
    {
        var start = i > 0 ? new Vec3(plan.X[i - 1], plan.Y[i - 1], plan.Z[i - 1]) : _plan.StartOf(block);
        if (!IsNear(from, start)) return;
        var planned = arc.Length(start, wanted);
        if (Math.Abs(length - planned) <= ArcTolerance + planned * 0.01) return;
        _findings.Add(CheckCodes.FilePosition, () => WrittenPlaces.OfMove(_plan, move, line),
            () => $"An arc is {NumberFormatter.Format(length, 2)} mm long by this line; the plan has {NumberFormatter.Format(planned, 2)} mm.");
    }

    private void Extruded(ToolpathColumns plan, int i, int move, int line, double e)
    {
        if (plan.Tool[i] != _tool)
        {
            _drifts[_tool] = _drift;
            _tool = plan.Tool[i];
            _drifts.TryGetValue(_tool, out _drift);
        }
        _drift += e - plan.E[i];
        if (!(Math.Abs(_drift) > _allowedE + 1e-12 * Math.Abs(plan.E[i]))) return;
        _drift = 0;
        Report(move, line, e, plan.E[i]);
    }

    // Apart from the above, which would allocate what is captured here for each move.
    private void Report(int move, int line, double e, double planned)
        => _findings.Add(CheckCodes.FileExtrusion, () => WrittenPlaces.OfMove(_plan, move, line),
            () => $"E changes by {NumberFormatter.Format(e, 5)} in this line; the plan has {NumberFormatter.Format(planned, 5)}.");
}
