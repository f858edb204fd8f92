using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>
/// Writes a Toolpath as new G-code, block by block: <see cref="WriteStart"/>, <see cref="WriteBlock"/> for each block in order, <see cref="WriteEnd"/>. After
/// the start code it states its own modal state: G90, then M82 or M83, and <c>G92 E0</c> where E is absolute. Printed integers decide what a move is: words
/// that do not change are left out, and so are moves without any; what rounding leaves of E is carried on, so that the sum of what is written never differs
/// from the sum of the moves by more than half the last decimal.
/// </summary>
public sealed partial class GCodeWriter
{
    // An absolute E beyond this is set back to 0 where a layer begins: firmwares count with 24 bits.
    private const double LargestSum = 1000;
    private const double LargestExact = 1e8;

    private Toolpath _toolpath;
    private GCodeFormat _format;
    private readonly DialectRules _rules;
    private readonly LineBuffer _out;
    private readonly byte _e;
    private readonly bool _relative;
    private readonly bool _switches;
    private readonly Dictionary<int, ExtruderSum> _sums = [];
    private readonly Dictionary<int, double> _rests = [];
    private readonly long _largestSum;
    private ExtruderSum _sum = new();
    private long _x;
    private long _y;
    private long _z;
    private long _f = long.MinValue;
    private bool _positionKnown;
    private int _nextBlock;
    private int _nextEvent;
    private int _tool;
    private int _layer = -1;
    private Role _role = Role.Unspecified;
    private string _object = "";
    private HomeEvent? _homed;
    private bool _on;

    public GCodeWriter(Toolpath toolpath, GCodeFormat? format = null)
    {
        _toolpath = toolpath ?? throw new ArgumentNullException(nameof(toolpath));
        _format = format ?? new GCodeFormat();
        _rules = _format.Dialect;
        _out = new LineBuffer(_format.Numbered);
        _e = _format.ExtruderLetter;
        _relative = _format.WritesRelative;
        _switches = _format.Switches;
        _raw = new RawEffects(_rules, _e);
        _sums.Add(0, _sum);
        _largestSum = NumberFormatter.ToUnits(LargestSum, _format.DecimalsE);
    }

    /// <summary>Takes down which lines belong to each move, event and template; null for nobody.</summary>
    internal WrittenLines? Written { get; init; }

    /// <summary>Lines written so far.</summary>
    public long Lines => _out.Lines;

    /// <summary>Bytes written so far.</summary>
    public long Bytes { get; private set; }

    /// <summary>Writes all of a toolpath.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A coordinate is not finite or too large to print.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static void Write(Toolpath toolpath, GCodeFormat format, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
        => new GCodeWriter(toolpath, format).WriteAll(stream, progress, cancel);

    /// <inheritdoc cref="Write"/>
    public void WriteAll(Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        WriteStart(stream);
        for (var i = 0; i < _toolpath.Blocks.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            WriteBlock(stream, i);
            progress?.Report((i + 1.0) / _toolpath.Blocks.Count);
        }
        WriteEnd(stream);
    }

    /// <summary>All of a toolpath as bytes.</summary>
    /// <inheritdoc cref="Write" path="/exception"/>
    public static byte[] ToBytes(Toolpath toolpath, GCodeFormat? format = null)
    {
        using var memory = new MemoryStream();
        Write(toolpath, format ?? new GCodeFormat(), memory);
        return memory.ToArray();
    }

    /// <summary>Header, start code and modal state.</summary>
    public void WriteStart(Stream stream)
    {
        foreach (var line in _format.Header) _out.Comment(" " + line);
        if (_format.PrintTime is { } seconds) _out.Comment("TIME:" + NumberFormatter.Format((long)Math.Round(seconds)));
        Template(_format.Start);
        _raw.Read(_format.Start);
        if (_raw.Unit && _rules.Inches) Modal(21);
        if (_raw.Plane && _rules.Planes) Modal(17);
        StateModes();
        if (_raw.Tool is > 0) StateTool(_tool);
        Written?.EndStart(Lines);
        Flush(stream);
    }

    /// <summary>The moves of a block and the events between them.</summary>
    /// <exception cref="InvalidOperationException">Blocks are written in order, each once.</exception>
    /// <inheritdoc cref="Write" path="/exception"/>
    public void WriteBlock(Stream stream, int block)
    {
        if (block != _nextBlock) throw new InvalidOperationException("The blocks of a toolpath are written in order.");
        _nextBlock++;
        var columns = _toolpath.Blocks[block].Columns;
        var first = _toolpath.FirstOf(block);
        for (var i = 0; i < columns.Count; i++)
        {
            // The event of a dwell is the dwell: its layer and tool come first.
            if (columns.Kind[i] == MoveKind.Dwell && columns.Layer[i] != _layer) Layer(columns.Layer[i]);
            Events(first + i);
            Move(columns, block, i);
            Written?.EndMove(first + i, Lines);
            if (_out.Count > 1 << 20) Flush(stream);
        }
        Flush(stream);
    }

    /// <summary>Goes on with a toolpath that begins as the one so far and is longer; its end code may be known only now.</summary>
    internal void GoOn(Toolpath longer, GCodeFormat format) => (_toolpath, _format) = (longer, format);

    /// <summary>What happens after the last move, and the end code.</summary>
    public void WriteEnd(Stream stream)
    {
        if (_nextBlock != _toolpath.Blocks.Count) throw new InvalidOperationException("Not all blocks are written.");
        Events(_toolpath.Count);
        if (_on) Switch(false);
        if (_format.Comments && _object.Length > 0) Object("");
        if (_format.End.Count > 0) SetRelative(false);
        Written?.BeginEnd(Lines);
        Template(_format.End);
        Flush(stream);
    }

    // Purge lines and whatever else the start and end code do are not part of the print.
    private void Template(IReadOnlyList<string> lines)
    {
        if (lines.Count == 0) return;
        if (_format.Comments)
        {
            _role = Role.Purge;
            _out.Comment("TYPE:" + RoleNames.Of(_role));
        }
        foreach (var line in lines) _out.Line(line);
    }

    private void Flush(Stream stream)
    {
        Bytes += _out.Count;
        _out.FlushTo(stream);
    }

    private void Move(ToolpathColumns c, int block, int i)
    {
        if (c.Layer[i] != _layer) Layer(c.Layer[i]);
        if (c.Tool[i] != _tool) Tool(c.Tool[i]);
        Written?.BeginMove(_toolpath.FirstOf(block) + i, Lines);
        var kind = c.Kind[i];
        var home = _homed;
        _homed = null;
        // The home command has made this move already.
        if (home is not null && kind == MoveKind.Travel && IsHomingMove(home, c, block, i)) return;
        switch (kind)
        {
            case MoveKind.Dwell:
                return;
            case MoveKind.Retract:
            case MoveKind.Restore:
                if (_rules.FirmwareRetraction && (_format.FirmwareRetraction || c.E[i] == 0))
                {
                    _out.Command((byte)'G', kind == MoveKind.Retract ? 10 : 11);
                    _out.EndLine();
                    return;
                }
                break;
            case MoveKind.Print:
                if (_format.Comments && c.Role[i] != _role)
                {
                    _role = c.Role[i];
                    _out.Comment("TYPE:" + RoleNames.Of(_role));
                }
                break;
        }
        if (_switches) Switch(kind == MoveKind.Print);
        ReturnTo(c, block, i);
        if (kind == MoveKind.Travel) _travelSpeed = c.Speed[i];
        SetTurns(c, i);
        if (c.TryGetArc(i, out var arc)) ArcMove(c, block, i, arc);
        else Straight(c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i], kind == MoveKind.Travel ? 0 : 1);
    }

    // Firmware without amounts: the extruder is on or off.
    private void Switch(bool on)
    {
        if (on == _on) return;
        _on = on;
        _out.Command((byte)'M', on ? 101 : 103);
        _out.EndLine();
    }

    private bool IsHomingMove(HomeEvent home, ToolpathColumns c, int block, int i)
    {
        var start = i > 0 ? new Vec3(c.X[i - 1], c.Y[i - 1], c.Z[i - 1]) : _toolpath.StartOf(block);
        return c.X[i] == (home.X ? 0 : start.X) && c.Y[i] == (home.Y ? 0 : start.Y) && c.Z[i] == (home.Z ? 0 : start.Z);
    }

    private void Straight(double x, double y, double z, double e, double speed, int code)
    {
        var xyz = _format.DecimalsXyz;
        var ux = NumberFormatter.ToUnits(x, xyz);
        var uy = NumberFormatter.ToUnits(y, xyz);
        var uz = NumberFormatter.ToUnits(z, xyz);
        var ue = StepE(e, out var changed);
        bool hasX = !_positionKnown || ux != _x, hasY = !_positionKnown || uy != _y, hasZ = !_positionKnown || uz != _z;
        if (!hasX && !hasY && !hasZ && !changed && !_hasTurns) return;
        if (_format.RelativeXyz) SetRelative(_positionKnown);
        _out.Command((byte)'G', code);
        if (hasX) _out.Word((byte)'X', _g91 ? ux - _x : ux, xyz);
        if (hasY) _out.Word((byte)'Y', _g91 ? uy - _y : uy, xyz);
        if (hasZ) _out.Word((byte)'Z', _g91 ? uz - _z : uz, xyz);
        Turns();
        if (changed) _out.Word(_e, ue, _format.DecimalsE);
        Feed(speed);
        _out.EndLine();
        _x = ux;
        _y = uy;
        _z = uz;
        _positionKnown = true;
    }

    private void StateModes()
    {
        _g91 = false;
        _out.Command((byte)'G', 90);
        _out.EndLine();
        StateModeOfE();
        if (_e != 0 && !_relative) ResetE();
    }

    private void StateModeOfE()
    {
        if (_e != 0 && _rules.RelativeE != RelativeERule.OnlyG90G91)
        {
            _out.Command((byte)'M', _relative ? 83 : 82);
            _out.EndLine();
        }
    }

    // Number to print for a change of E, and whether the printed sum changes at all.
    private long StepE(double e, out bool changed)
    {
        changed = false;
        if (_e == 0) return 0;
        var sum = _sum;
        if (Math.Abs(sum.Exact) > LargestExact) Rebase();
        sum.Exact += e;
        var units = NumberFormatter.ToUnits(sum.Exact, _format.DecimalsE);
        var step = units - sum.Written;
        changed = step != 0;
        sum.Written = units;
        return _relative ? step : units;
    }

    // Sums stay within what can be printed.
    private void Rebase()
    {
        if (!_relative)
        {
            ResetE();
            return;
        }
        _sum.Exact -= NumberFormatter.FromUnits(_sum.Written, _format.DecimalsE);
        _sum.Written = 0;
    }

    private void Feed(double speed)
    {
        if (!(speed > 0)) return;
        var units = NumberFormatter.ToUnits(speed * 60, _format.DecimalsF);
        if (units == _f || units == 0) return;
        _f = units;
        _out.Word((byte)'F', units, _format.DecimalsF);
    }

    private void ResetE()
    {
        _out.Command((byte)'G', 92);
        _out.Word(_e, 0, 0);
        _out.EndLine();
        // What was not written yet is still to be written.
        _sum.Exact -= NumberFormatter.FromUnits(_sum.Written, _format.DecimalsE);
        _sum.Written = 0;
    }

    private sealed class ExtruderSum
    {
        public double Exact;
        public long Written;
    }
}
