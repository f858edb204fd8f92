using System;
using System.Runtime.CompilerServices;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>
/// The fast path of the splicer, for most lines of most files: straight moves in the usual notation, in absolute millimeters, each with one move of its own.
/// Writes byte for byte what <see cref="MoveWriter"/> would, and leaves both machines in the same state; whatever is unusual is left to it.
/// </summary>
internal sealed class PlainMoves
{
    private const double NoChange = InterpreterState.NoChange;

    // Beyond this, numbers take the general path.
    private const double Largest = 1e8;
    private const int MostDecimals = 6;

    private readonly SpliceContext _context;
    private readonly SpliceTasks _tasks;
    private readonly CommentBuffer _comments;
    private readonly MoveWriter _moves;
    private readonly PlainLine _line;
    private readonly InterpreterState _read;
    private readonly InterpreterState _written;
    private readonly bool _edits;
    private readonly bool _possible;
    private readonly double _toleranceE;
    private readonly double _tolerance;
    private readonly double[] _values = new double[PlainLine.Slots];
    private readonly int[] _decimals = new int[PlainLine.Slots];
    private readonly bool[] _changed = new bool[PlainLine.Slots];
    private byte[] _out = new byte[512];

    public PlainMoves(SpliceContext context, SpliceTasks tasks, CommentBuffer comments, MoveWriter moves, bool rewriteAll)
    {
        (_context, _tasks, _comments, _moves) = (context, tasks, comments, moves);
        (_read, _written) = (context.Read.State, context.Written.State);
        _line = new PlainLine(context.Axis.Letter);
        _edits = context.Target is null;
        var style = context.Style;
        _tolerance = 0.5 * NumberFormatter.FromUnits(1, style.DecimalsXyz);
        _toleranceE = moves.ToleranceE;
        _possible = !rewriteAll && !style.Numbered && !style.LowerCase && !style.NoSpace && context.Axis == context.Decoding.Axis && context.Axis.Letter != 0
            && context.Axis != ExtrusionAxis.Both && context.Target is null or { LimitsDecimals: false, ChangesUnit: false, StatedDiameter: null }
            && KnowsWords(context.Rules.Letters) && KnowsWords(context.Decoding.Dialect.Letters)
            && !context.Read.Strokes && !context.Written.Strokes && Math.Max(style.DecimalsXyz, style.DecimalsE) <= MostDecimals;
    }

    /// <summary>True while the states of both machines allow it; to be asked for again after each line that took the general path.</summary>
    public bool IsReady { get; private set; }

    public void Refresh()
    {
        if (!_possible) return;
        ref var read = ref _read.Modes;
        ref var written = ref _written.Modes;
        var relative = _context.Target?.RelativeE ?? read.RelativeE;
        IsReady = read.IsPlain && written.IsPlain && written.RelativeE == relative && _read.Tool == _written.Tool
            && _read.Extrusion.Flow == _written.Extrusion.Flow && _read.Feed.Factor == 1 && _written.Feed.Factor == 1
            && _read.Head.HasMoved && _written.Head.HasMoved && _read.Rotary == default && _written.Rotary == default
            && !_read.Work.IsMachineLine && !_written.Work.IsMachineLine;
    }

    /// <summary>Writes the move of the line that begins here and returns where the next begins; −1 where nothing was done.</summary>
    [MethodImpl((MethodImplOptions)512)]
    public int Write(byte[] text, int at, int end, int number)
    {
        var line = _line;
        if (!line.Read(text, at, end)) return -1;
        var words = line.Values;
        bool hasX = line.Has(PlainLine.X), hasY = line.Has(PlainLine.Y), hasZ = line.Has(PlainLine.Z), hasE = line.Has(PlainLine.E),
            hasF = line.Has(PlainLine.F);
        if (hasF && !(words[PlainLine.F] is > 0 and < Largest)) return -1;

        // What the line does in the file.
        ref var head = ref _read.Head;
        double rx = hasX ? words[PlainLine.X] : head.X, ry = hasY ? words[PlainLine.Y] : head.Y, rz = hasZ ? words[PlainLine.Z] : head.Z;
        var re = hasE ? _read.Modes.RelativeE ? words[PlainLine.E] : words[PlainLine.E] - _read.Extrusion.E : 0;
        var readChange = re;
        var readSpeed = hasF ? words[PlainLine.F] / 60 * 1 : _read.Feed.Speed;
        if (!Moves(head, rx, ry, rz, ref re)) return -1;

        // What it has to do.
        double mx, my, mz, me, speed;
        if (_edits)
        {
            if (!_tasks.HasSingleMove(number, out var c, out var i) || c.Tool[i] != _written.Tool || c.A is not null || c.TryGetArc(i, out _)) return -1;
            (mx, my, mz, me, speed) = (c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i]);
        }
        else
        {
            (mx, my, mz, me, speed) = (rx + head.ShiftX, ry + head.ShiftY, rz + head.ShiftZ, re, readSpeed);
        }

        // What it does as it is, and what its words have to be.
        ref var to = ref _written.Head;
        var relative = _written.Modes.RelativeE;
        double wx = hasX ? words[PlainLine.X] : to.X, wy = hasY ? words[PlainLine.Y] : to.Y, wz = hasZ ? words[PlainLine.Z] : to.Z;
        var we = hasE ? relative ? words[PlainLine.E] : words[PlainLine.E] - _written.Extrusion.E : 0;
        var change = we;
        var feed = hasF ? words[PlainLine.F] : _written.Feed.Rate;
        var writtenSpeed = hasF ? words[PlainLine.F] / 60 * 1 : _written.Feed.Speed;
        var moves = Moves(to, wx, wy, wz, ref we);
        var carried = _moves.Carried;
        var endsRight = Math.Abs(wx + to.ShiftX - mx) <= NoChange && Math.Abs(wy + to.ShiftY - my) <= NoChange && Math.Abs(wz + to.ShiftZ - mz) <= NoChange;
        var stays = moves && endsRight && Math.Abs(we - me - (_edits ? 0 : carried)) <= _toleranceE
            && (!(speed > 0) || Math.Abs(writtenSpeed - speed) <= 1e-9 * speed);
        if (!stays)
        {
            if (_edits && moves && endsRight && NeedsState(line, re, me, readSpeed, speed)) return -1;
            if (!Axis(PlainLine.X, mx - to.ShiftX, to.X) || !Axis(PlainLine.Y, my - to.ShiftY, to.Y) || !Axis(PlainLine.Z, mz - to.ShiftZ, to.Z)
                || !Extruder(me, relative ? 0 : _written.Extrusion.E, carried) || !Feed(speed)) return -1;
            if (hasX) wx = _values[PlainLine.X];
            if (hasY) wy = _values[PlainLine.Y];
            if (hasZ) wz = _values[PlainLine.Z];
            we = change = hasE ? relative ? _values[PlainLine.E] : _values[PlainLine.E] - _written.Extrusion.E : 0;
            if (hasF)
            {
                feed = _values[PlainLine.F];
                if (!(feed > 0)) return -1;
                writtenSpeed = feed / 60 * 1;
            }
            if (!Moves(to, wx, wy, wz, ref we)) return -1;
        }

        if (_edits) _tasks.TakeSingleMove();
        _comments.RestoreCut();
        _comments.Keep();
        if (stays) _context.Text.Copy(text, at, line.Next);
        else Compose(text, at);
        _moves.Carry(me, we);
        Step(_context.Read, line.Command, rx, ry, rz, readChange, re, hasF ? words[PlainLine.F] : 0, readSpeed);
        Step(_context.Written, line.Command, wx, wy, wz, change, we, hasF ? feed : 0, writtenSpeed);
        return line.Next;
    }

    private static bool KnowsWords(string letters)
    {
        if (letters.Length == 0) return true;
        foreach (var letter in "GXYZEF")
        {
            if (letters.IndexOf(letter.ToString(), StringComparison.Ordinal) < 0) return false;
        }
        return true;
    }

    // Whether a move is made of it, of numbers that are not unusually large.
    private static bool Moves(in HeadPosition from, double x, double y, double z, ref double e)
    {
        if (!(Math.Abs(x) < Largest && Math.Abs(y) < Largest && Math.Abs(z) < Largest && Math.Abs(e) < Largest)) return false;
        if (e < NoChange && e > -NoChange) e = 0;
        if (e != 0) return true;
        double dx = x - from.X, dy = y - from.Y, dz = z - from.Z;
        return dx * dx + dy * dy + dz * dz > NoChange * NoChange;
    }

    // Where a line of state before it would let the line stay: G92 E or F.
    private bool NeedsState(PlainLine line, double re, double me, double readSpeed, double speed)
    {
        if (!_written.Modes.RelativeE && Math.Abs(re - me) <= NoChange && line.Has(PlainLine.E)
            && Math.Abs(line.Values[PlainLine.E] - me - _written.Extrusion.E) > NoChange) return true;
        return Math.Abs(readSpeed - speed) <= 1e-9 * speed && speed > 0 && !line.Has(PlainLine.F)
            && Math.Abs(speed - _written.Feed.Speed) > 1e-9 * speed;
    }

    // False where a word would have to be put in.
    private bool Axis(int slot, double target, double current)
    {
        if (!_line.Has(slot)) return !(Math.Abs(target - current) > _tolerance);
        if (Math.Abs(_line.Values[slot] - target) <= NoChange) return Stays(slot);
        return Becomes(slot, target, Math.Max(_line.Decimals[slot], _context.Style.DecimalsXyz));
    }

    private bool Extruder(double me, double from, double carried)
    {
        if (!_line.Has(PlainLine.E)) return Math.Abs(me) < NoChange;
        var value = from + me + (me != 0 ? carried : 0);
        return Math.Abs(_line.Values[PlainLine.E] - value) > NoChange ? Becomes(PlainLine.E, value, _context.Style.DecimalsE) : Stays(PlainLine.E);
    }

    private bool Feed(double speed)
    {
        var has = _line.Has(PlainLine.F);
        if (!(speed > 0)) return !has || Stays(PlainLine.F);
        var feed = speed * 60 / 1;
        var says = has ? _line.Values[PlainLine.F] : _written.Feed.Rate;
        if (Math.Abs(says - feed) <= 1e-9 * feed) return !has || Stays(PlainLine.F);
        if (!has) return Math.Abs(says - feed) <= _context.Style.FeedTolerance;
        return Becomes(PlainLine.F, feed, Math.Max(_context.Style.DecimalsF, Math.Min(_line.Decimals[PlainLine.F], 9)));
    }

    private bool Stays(int slot)
    {
        _changed[slot] = false;
        _values[slot] = _line.Values[slot];
        return true;
    }

    private bool Becomes(int slot, double value, int decimals)
    {
        if (decimals > MostDecimals || !(Math.Abs(value) < Largest)) return false;
        _changed[slot] = true;
        _decimals[slot] = decimals;
        // What is read again is the number as it is printed.
        _values[slot] = NumberFormatter.FromUnits(NumberFormatter.ToUnits(value, decimals), decimals);
        return true;
    }

    private void Compose(byte[] text, int start)
    {
        var line = _line;
        if (_out.Length < line.Next - start + 256) _out = new byte[(line.Next - start + 256) * 2];
        int at = start, count = 0;
        for (var w = 0; w < line.Count; w++)
        {
            var slot = line.Order[w];
            if (!_changed[slot]) continue;
            var length = line.NumberAt[slot] - at;
            Buffer.BlockCopy(text, at, _out, count, length);
            count = _context.Style.Write(_out, count + length, _values[slot], _decimals[slot]);
            at = line.NumberEnd[slot];
        }
        Buffer.BlockCopy(text, at, _out, count, line.Next - at);
        _context.Text.Copy(_out, 0, count + line.Next - at);
    }

    private static void Step(GCodeInterpreter machine, int command, double x, double y, double z, double change, double e, double feed, double speed)
    {
        var state = machine.State;
        state.Modes.Motion = command;
        ref var head = ref state.Head;
        (head.X, head.Y, head.Z) = (x, y, z);
        state.Extrusion.E += change;
        if (feed > 0)
        {
            state.Feed.Rate = feed;
            state.Feed.Speed = speed;
        }
        if (e > 0) machine.Machine.Extruders.Push(e);
        else if (e < 0) machine.Machine.Extruders.Pull(-e);
    }
}
