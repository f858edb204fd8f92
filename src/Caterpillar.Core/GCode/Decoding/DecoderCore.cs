using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>
/// Second half of decoding: the state of the machine, line after line. Positions are kept as written (after G92), in mm; the columns get them in machine
/// coordinates, which G92 does not move.
/// </summary>
internal sealed partial class DecoderCore
{
    private const byte LastFastOp = 1;

    // Beyond these a number is no length in mm: such a move is left out and reported.
    private const double Largest = 1e10;
    private const double LargestSquare = Largest * Largest;
    private const double LargestE = 1e9;
    private const double NoChange = 1e-9;

    private readonly DialectRules _rules;
    private readonly bool _balance;
    private readonly ExtrusionAxis _axis;
    private readonly ParsedLine _parsed = new();
    private readonly MoveColumns _out = new();
    private readonly List<MoveEvent> _events = [];

    private double _x;
    private double _y;
    private double _z;
    private double _e;

    // Machine coordinates minus coordinates as written.
    private double _shiftX;
    private double _shiftY;
    private double _shiftZ;

    private double _speed;
    private int _line;
    private int _tool;
    private Role _role;
    private double _lastPrintZ = double.NaN;
    private double _lastFlatZ = double.NaN;
    private bool _wasPrint;

    public DecoderCore(DialectRules rules, ExtrusionRule rule, ExtrusionAxis axis)
    {
        _rules = rules;
        _balance = rule == ExtrusionRule.Balance;
        _axis = axis;
        _volumetric = rules.StartsVolumetric;
        SelectTool(0);
    }

    public DecodeCounters DecodeCounters { get; } = new();

    public Features Features { get; } = new();

    public LayerCollector Layers { get; } = new();

    public DiagnosticList Diagnostics { get; } = new();

    /// <summary>Where the head stands, as written.</summary>
    public Vec3 Position => new(_x, _y, _z);

    /// <summary>The sum of E by Marlin 2's rule, or null where the rules never parted.</summary>
    public double? EByMarlin2Rule => _shadow ? DecodeCounters.EMarlin2 : null;

    /// <summary>Decodes the lines of a chunk; <paramref name="firstLine"/> lines are before it.</summary>
    [MethodImpl((MethodImplOptions)512)]
    public void Run(ChunkParser chunk, int firstLine)
    {
        var text = chunk.Chunk!.Text;
        var records = chunk.Records;
        var count = chunk.Count;
        Features.Lines += count;
        Features.CrLf += chunk.CrLf;
        Features.SemicolonComments += chunk.Comments;
        for (var i = 0; i < count; i++)
        {
            ref var record = ref records[i];
            _line = firstLine + record.Line + 1;
            if (record.Op > LastFastOp)
            {
                if (record.Op == ChunkParser.Comment) CommentLine(text, record.Start, record.Aux);
                else Execute(text, record.Start, record.Aux);
                continue;
            }
            if (record.Aux >= 0 && !_typed) TrailingComment(text, record.Aux);
            int mask = record.Mask;
            _motion = record.Op;
            if ((mask & ChunkParser.HasF) != 0) SetFeed(record.F);
            if (!_plain)
            {
                General(mask, record.X, record.Y, record.Z, record.E, record.Op);
                continue;
            }
            var e = 0.0;
            if ((mask & ChunkParser.HasE) != 0)
            {
                e = _relativeE ? record.E : record.E - _e;
                _e += e;
            }
            Linear(
                (mask & ChunkParser.HasX) != 0 ? record.X : _x,
                (mask & ChunkParser.HasY) != 0 ? record.Y : _y,
                (mask & ChunkParser.HasZ) != 0 ? record.Z : _z,
                e,
                record.Op);
        }
    }

    /// <summary>The finished toolpath.</summary>
    public Toolpath Finish(double?[] volumePerE)
    {
        var tools = new ToolpathTool[Math.Max(_highestTool + 1, 1)];
        for (var i = 0; i < tools.Length; i++)
            tools[i] = new ToolpathTool(_volumetric ? 1 : volumePerE.Length == 0 ? null : volumePerE[Math.Min(i, volumePerE.Length - 1)]);
        Vec3? start = _startKnown ? new Vec3(_startX, _startY, _startZ) : null;
        return new Toolpath(_out.ToBlocks(), Layers.ToLayers(), _events, tools, start, MoveSource.Lines);
    }

    // A straight move to a place as written, with a change of E.
    private void Linear(double x, double y, double z, double e, int code)
    {
        var dx = x - _x;
        var dy = y - _y;
        var dz = z - _z;
        var square = dx * dx + dy * dy;
        var length2 = square + dz * dz;
        if (code == 0) DecodeCounters.Rapids++;
        else DecodeCounters.Feeds++;
        if (!(length2 < LargestSquare) || !(e < LargestE && e > -LargestE) || (length2 > 1e6 && IsTooFar(x, y, z)))
        {
            OutOfRange();
            return;
        }
        if (e < NoChange && e > -NoChange) e = 0;
        if (length2 <= NoChange * NoChange)
        {
            InPlace(x, y, z, e);
            return;
        }
        Moved(x, y, z, e, code, Math.Sqrt(length2), Math.Sqrt(square), dz == 0);
    }

    private static bool IsTooFar(double x, double y, double z) => !(Math.Abs(x) < Largest && Math.Abs(y) < Largest && Math.Abs(z) < Largest);

    private void Moved(double x, double y, double z, double e, int code, double length, double lengthXY, bool flat)
    {
        var tally = DecodeCounters;
        MoveKind kind;
        var deposited = 0.0;
        if (e > 0)
        {
            deposited = Push(e);
            kind = _balance && deposited == 0 ? MoveKind.MovingRestore : MoveKind.Print;
        }
        else if (e < 0)
        {
            Pull(-e);
            kind = MoveKind.Wipe;
        }
        else
        {
            kind = _strokes && (_switchedOn || !_switched) && code > 0 ? MoveKind.Print : MoveKind.Travel;
        }
        if (kind == MoveKind.Print)
        {
            if (!_balance) deposited = e;
            tally.Prints++;
            if (code == 0) tally.PrintsG0++;
            tally.PrintLength += length;
            tally.PrintLengthXY += lengthXY;
            tally.EPrint += deposited;
            if (!_wasPrint) tally.PrintStarts.Include(_x, _y, _z);
            tally.PrintEnds.Include(x, y, z);
            if (z != _lastPrintZ)
            {
                _lastPrintZ = z;
                tally.HeightChanged(z);
            }
            if (flat && z != _lastFlatZ) FlatHeight(z);
            if (Layers.NeedsZ) Layers.Printed(z + _shiftZ, flat);
            _wasPrint = true;
        }
        else
        {
            tally.Travels++;
            if (e < 0) tally.TravelsWithRetract++;
            if (code == 1) tally.TravelsG1++;
            tally.TravelLength += length;
            tally.TravelEnds.Include(x, y, z);
            _wasPrint = false;
        }
        Emit(x, y, z, e, deposited, kind);
    }

    private void InPlace(double x, double y, double z, double e)
    {
        if (e > 0)
        {
            DecodeCounters.Unretracts++;
            var hadRetracted = _retracted > 0;
            var deposited = Push(e);
            Emit(x, y, z, e, _balance ? deposited : 0, hadRetracted || !_balance ? MoveKind.Restore : MoveKind.Prime);
        }
        else if (e < 0)
        {
            DecodeCounters.Retracts++;
            Pull(-e);
            Emit(x, y, z, e, 0, MoveKind.Retract);
        }
        else
        {
            DecodeCounters.NoOps++;
            _x = x;
            _y = y;
            _z = z;
        }
    }

    private void FlatHeight(double z)
    {
        _lastFlatZ = z;
        DecodeCounters.FlatAt(z);
        if (!Layers.Marked) Layers.FlatAt(z + _shiftZ);
    }

    private void Emit(double x, double y, double z, double e, double deposited, MoveKind kind)
    {
        if (!_started) NoteStart();
        _x = x;
        _y = y;
        _z = z;
        if (_out.IsFull) _out.Grow();
        var c = _out.Columns;
        var i = c.Count++;
        c.X[i] = x + _shiftX;
        c.Y[i] = y + _shiftY;
        c.Z[i] = z + _shiftZ;
        c.E[i] = e;
        c.Deposited[i] = deposited;
        c.Speed[i] = _speed;
        c.Kind[i] = kind;
        c.Role[i] = kind == MoveKind.Print ? _role : Role.Unspecified;
        c.Layer[i] = Layers.Current;
        c.Tool[i] = (short)_tool;
        c.Source[i] = _line;
    }

    private void OutOfRange() => Diagnostics.Add(
        Severity.Warning, "gcode.number_range", "A move beyond 10¹⁰ mm (or a sum that is no number) is left out.", new SourceLocation(Line: _line));
}
