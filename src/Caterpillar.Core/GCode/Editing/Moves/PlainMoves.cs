using System;
using System.Runtime.CompilerServices;
using Caterpillar.Basics;

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

    // Slots of words: the bits of LineRecord.Mask.
    private const int X = 0;
    private const int Y = 1;
    private const int Z = 2;
    private const int E = 3;
    private const int F = 4;
    private const int Slots = 5;

    private readonly SpliceContext _context;
    private readonly SpliceTasks _tasks;
    private readonly CommentBuffer _comments;
    private readonly MoveWriter _moves;
    private readonly LineStyle _style;
    private readonly InterpreterState _read;
    private readonly InterpreterState _written;
    private readonly bool _edits;
    private readonly bool _possible;
    private readonly double _toleranceE;
    private readonly double _tolerance;

    // By slot: what becomes of the words of the current line.
    private readonly Number[] _numbers = new Number[Slots];

    public PlainMoves(SpliceContext context, SpliceTasks tasks, CommentBuffer comments, MoveWriter moves, bool rewriteAll)
    {
        (_context, _tasks, _comments, _moves) = (context, tasks, comments, moves);
        (_read, _written) = (context.Read.State, context.Written.State);
        _edits = context.Target is null;
        _style = context.Style;
        _tolerance = 0.5 * NumberFormatter.FromUnits(1, _style.DecimalsXyz);
        _toleranceE = moves.ToleranceE;
        _possible = !rewriteAll && !_style.Numbered && !_style.LowerCase && !_style.NoSpace && context.Axis == context.Decoding.Axis
            && context.Axis.Letter != 0 && context.Axis != ExtrusionAxis.Both
            && context.Target is null or { LimitsDecimals: false, ChangesUnit: false, StatedDiameter: null }
            && KnowsWords(context.Rules.Letters) && KnowsWords(context.Decoding.Dialect.Letters)
            && !context.Read.Strokes && !context.Written.Strokes && Math.Max(_style.DecimalsXyz, _style.DecimalsE) <= MostDecimals;
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

    /// <summary>
    /// Writes the move of a motion whose words are known, the line from its start up to <paramref name="next"/>; false where nothing was done.
    /// </summary>
    [MethodImpl(Compile.Optimized)]
    public bool Write(in LineRecord line, in WordPlaces places, byte[] text, int next, int number)
    {
        int mask = line.Mask;
        bool hasX = (mask & ChunkParser.HasX) != 0, hasY = (mask & ChunkParser.HasY) != 0, hasZ = (mask & ChunkParser.HasZ) != 0,
            hasE = (mask & ChunkParser.HasE) != 0, hasF = (mask & ChunkParser.HasF) != 0;
        if (hasF && !(line.F is > 0 and < Largest)) return false;

        // What the line does in the file.
        ref var head = ref _read.Head;
        double rx = hasX ? line.X : head.X, ry = hasY ? line.Y : head.Y, rz = hasZ ? line.Z : head.Z;
        var re = hasE ? _read.Modes.RelativeE ? line.E : line.E - _read.Extrusion.E : 0;
        var readChange = re;
        var readSpeed = hasF ? line.F / 60 : _read.Feed.Speed;
        if (!Moves(head, rx, ry, rz, ref re)) return false;

        // What it has to do.
        double mx, my, mz, me, speed;
        if (_edits)
        {
            if (!_tasks.HasSingleMove(number, out var c, out var i) || c.Tool[i] != _written.Tool || c.A is not null || c.TryGetArc(i, out _)) return false;
            (mx, my, mz, me, speed) = (c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i]);
        }
        else
        {
            (mx, my, mz, me, speed) = (rx + head.ShiftX, ry + head.ShiftY, rz + head.ShiftZ, re, readSpeed);
        }

        // What it does as it is, and what its words have to be.
        ref var to = ref _written.Head;
        var relative = _written.Modes.RelativeE;
        var writtenE = _written.Extrusion.E;
        double wx = hasX ? line.X : to.X, wy = hasY ? line.Y : to.Y, wz = hasZ ? line.Z : to.Z;
        var we = hasE ? relative ? line.E : line.E - writtenE : 0;
        var change = we;
        var feed = hasF ? line.F : _written.Feed.Rate;
        var writtenSpeed = hasF ? line.F / 60 : _written.Feed.Speed;
        var moves = Moves(to, wx, wy, wz, ref we);
        var carried = _moves.Carried;
        var endsRight = Math.Abs(wx + to.ShiftX - mx) <= NoChange && Math.Abs(wy + to.ShiftY - my) <= NoChange && Math.Abs(wz + to.ShiftZ - mz) <= NoChange;
        var stays = moves && endsRight && Math.Abs(we - me - (_edits ? 0 : carried)) <= _toleranceE
            && (!(speed > 0) || Math.Abs(writtenSpeed - speed) <= 1e-9 * speed);
        if (!stays)
        {
            if (_edits && moves && endsRight && NeedsState(line, re, me, readSpeed, speed)) return false;
            if (!Axis(X, hasX, line.X, places, mx - to.ShiftX, to.X) || !Axis(Y, hasY, line.Y, places, my - to.ShiftY, to.Y)
                || !Axis(Z, hasZ, line.Z, places, mz - to.ShiftZ, to.Z) || !Extruder(hasE, line.E, me, relative ? 0 : writtenE, carried)
                || !Feed(hasF, line.F, places, speed))
            {
                return false;
            }
            if (hasX) wx = _numbers[X].Value;
            if (hasY) wy = _numbers[Y].Value;
            if (hasZ) wz = _numbers[Z].Value;
            we = change = hasE ? relative ? _numbers[E].Value : _numbers[E].Value - writtenE : 0;
            if (hasF)
            {
                feed = _numbers[F].Value;
                if (!(feed > 0)) return false;
                writtenSpeed = feed / 60;
            }
            if (!Moves(to, wx, wy, wz, ref we)) return false;
        }

        if (_edits) _tasks.TakeSingleMove();
        if (!_comments.IsEmpty)
        {
            _comments.RestoreCut();
            _comments.Keep();
        }
        if (stays) _context.Text.Copy(text, line.Start, next);
        else Compose(places, text, line.Start, next);
        _moves.Carry(me, we);
        Step(_context.Read, line.Op, rx, ry, rz, readChange, re, hasF ? line.F : 0, readSpeed);
        Step(_context.Written, line.Op, wx, wy, wz, change, we, hasF ? feed : 0, writtenSpeed);
        return true;
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
    private bool NeedsState(in LineRecord line, double re, double me, double readSpeed, double speed)
    {
        if (!_written.Modes.RelativeE && Math.Abs(re - me) <= NoChange && (line.Mask & ChunkParser.HasE) != 0
            && Math.Abs(line.E - me - _written.Extrusion.E) > NoChange)
        {
            return true;
        }
        return Math.Abs(readSpeed - speed) <= 1e-9 * speed && speed > 0 && (line.Mask & ChunkParser.HasF) == 0
            && Math.Abs(speed - _written.Feed.Speed) > 1e-9 * speed;
    }

    // False where a word would have to be put in.
    private bool Axis(int slot, bool has, double says, in WordPlaces places, double target, double current)
    {
        if (!has) return !(Math.Abs(target - current) > _tolerance);
        if (Math.Abs(says - target) <= NoChange) return Stays(slot, says);
        return Becomes(slot, target, Math.Max(places.DecimalsOf(slot), _style.DecimalsXyz));
    }

    private bool Extruder(bool has, double says, double me, double from, double carried)
    {
        if (!has) return Math.Abs(me) < NoChange;
        var value = from + me + (me != 0 ? carried : 0);
        return Math.Abs(says - value) > NoChange ? Becomes(E, value, _style.DecimalsE) : Stays(E, says);
    }

    private bool Feed(bool has, double says, in WordPlaces places, double speed)
    {
        if (!(speed > 0)) return !has || Stays(F, says);
        var feed = speed * 60;
        if (!has) says = _written.Feed.Rate;
        if (Math.Abs(says - feed) <= 1e-9 * feed) return !has || Stays(F, says);
        if (!has) return Math.Abs(says - feed) <= _style.FeedTolerance;
        return Becomes(F, feed, Math.Max(_style.DecimalsF, Math.Min(places.DecimalsOf(F), 9)));
    }

    private bool Stays(int slot, double says)
    {
        ref var number = ref _numbers[slot];
        number.Decimals = -1;
        number.Value = says;
        return true;
    }

    private bool Becomes(int slot, double value, int decimals)
    {
        if (decimals > MostDecimals || !(Math.Abs(value) < Largest)) return false;
        ref var number = ref _numbers[slot];
        number.Decimals = decimals;
        number.Units = NumberFormatter.ToUnits(value, decimals);
        // What is read again is the number as it is printed.
        number.Value = NumberFormatter.FromUnits(number.Units, decimals);
        return true;
    }

    private void Compose(in WordPlaces places, byte[] text, int start, int next)
    {
        var to = _context.Text;
        var space = to.Space(next - start + Slots * 24);
        var buffer = space ?? new byte[next - start + Slots * 24];
        int at = start, count = space is null ? 0 : to.Count;
        for (var w = 0; w < places.Count; w++)
        {
            var slot = places.SlotAt(w);
            ref var number = ref _numbers[slot];
            if (number.Decimals < 0) continue;
            for (var end = start + places.StartOf(slot); at < end; at++) buffer[count++] = text[at];
            count = _style.WriteUnits(buffer, count, number.Units, number.Decimals);
            at = start + places.EndOf(slot);
        }
        if (next - at < 4)
        {
            while (at < next) buffer[count++] = text[at++];
        }
        else
        {
            Buffer.BlockCopy(text, at, buffer, count, next - at);
            count += next - at;
        }
        if (space is null) to.Copy(buffer, 0, count);
        else to.Wrote(count);
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

    // A word of the current line: as it is read again, and as it is written where it changes (decimals of 0 and more).
    private struct Number
    {
        public double Value;
        public long Units;
        public int Decimals;
    }
}
