namespace Caterpillar.GCode;

/// <summary>
/// The fast path of the splicer, for most lines of most files: straight moves in the usual notation, in absolute millimeters, each with one own move. It writes
/// the same bytes as <see cref="MoveWriter"/> and leaves both machines in the same state. <see cref="MoveWriter"/> handles everything else.
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
    private readonly double _tolerance;

    // By slot: the most decimals that a number may keep. Null without limits.
    private readonly int[]? _limits;

    // By slot: what becomes of the words of the current line.
    private readonly Number[] _numbers = new Number[Slots];

    public PlainMoves(SpliceContext context, SpliceTasks tasks, CommentBuffer comments, MoveWriter moves, bool isOff)
    {
        (_context, _tasks, _comments, _moves) = (context, tasks, comments, moves);
        (_read, _written) = (context.Read.State, context.Written.State);
        _edits = context.Target is null;
        _style = context.Style;
        _tolerance = 0.5 * NumberFormatter.FromUnits(1, _style.DecimalsXyz);
        if (context.Target is { LimitsDecimals: true })
        {
            var xyz = _style.LimitXyz ?? int.MaxValue;
            _limits = [xyz, xyz, xyz, _style.LimitE ?? int.MaxValue, _style.LimitF ?? int.MaxValue];
        }
        _possible = !isOff && !_style.Numbered && !_style.LowerCase && !_style.NoSpace && context.Axis == context.Decoding.Axis
            && context.Axis.Letter != 0 && context.Axis != ExtrusionAxis.Both
            && context.Target is null or { ChangesUnit: false, StatedDiameter: null }
            && KnowsWords(context.Rules.Letters) && KnowsWords(context.Decoding.Flavor.Letters)
            && !context.Read.PrintsWithoutE && !context.Written.PrintsWithoutE && Math.Max(_style.DecimalsXyz, _style.DecimalsE) <= MostDecimals;
    }

    /// <summary>True while the states of both machines allow the fast path. Check it again after each line on the general path.</summary>
    public bool IsReady { get; private set; }

    public void Refresh()
    {
        if (!_possible) return;
        ref var read = ref _read.Modes;
        ref var written = ref _written.Modes;
        var relative = _context.Target?.Options.RelativeE ?? read.RelativeE;
        IsReady = read.IsPlain && written.IsPlain && written.RelativeE == relative && _read.Tool == _written.Tool
            && _read.Extrusion.Flow == _written.Extrusion.Flow && _read.Feed.Factor == 1 && _written.Feed.Factor == 1
            && _read.Head.HasMoved && _written.Head.HasMoved && _read.Rotary == default && _written.Rotary == default
            && !_read.Work.IsMachineLine && !_written.Work.IsMachineLine;
    }

    /// <summary>Writes the move of a motion whose words are known, the line from its start up to <paramref name="next"/>. False if nothing was done.</summary>
    [MethodImpl(Compile.Optimized)]
    public bool Write(in LineRecord line, in WordPlaces places, byte[] text, int next, int number)
    {
        if ((line.Mask & ChunkParser.HasF) != 0 && !(line.F is > 0 and < Largest)) return false;
        if (!Does(line, _read, out var read) || !Wants(read, number, out var wanted)) return false;
        var moves = Does(line, _written, out var written);
        var carried = _moves.Carried;
        ref var head = ref _written.Head;
        var endsRight = Math.Abs(written.X + head.ShiftX - wanted.X) <= NoChange && Math.Abs(written.Y + head.ShiftY - wanted.Y) <= NoChange
            && Math.Abs(written.Z + head.ShiftZ - wanted.Z) <= NoChange;
        var stays = moves && endsRight && !IsTooFine(places) && Math.Abs(written.E - wanted.E - (_edits ? 0 : carried)) <= _moves.ToleranceE
            && (!(wanted.Speed > 0) || Math.Abs(written.Speed - wanted.Speed) <= 1e-9 * wanted.Speed);
        if (!stays)
        {
            if (_edits && moves && endsRight && NeedsState(line, read, wanted)) return false;
            if (!Rewrite(line, places, wanted, carried, ref written)) return false;
        }
        if (_edits) _tasks.TakeSingleMove();
        if (!_comments.IsEmpty)
        {
            _comments.WriteCut();
            _comments.Keep();
        }
        if (stays) _context.Text.Copy(text, line.Start, next);
        else Compose(places, text, line.Start, next);
        _moves.Carry(carried + wanted.E - written.E);
        Step(_context.Read, line, read);
        Step(_context.Written, line, written);
        return true;
    }

    // What a line does on a machine; false where it is no move, or one of unusual numbers.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Does(in LineRecord line, InterpreterState machine, out Motion motion)
    {
        int mask = line.Mask;
        ref var head = ref machine.Head;
        motion.X = (mask & ChunkParser.HasX) != 0 ? line.X : head.X;
        motion.Y = (mask & ChunkParser.HasY) != 0 ? line.Y : head.Y;
        motion.Z = (mask & ChunkParser.HasZ) != 0 ? line.Z : head.Z;
        motion.Change = (mask & ChunkParser.HasE) == 0 ? 0 : machine.Modes.RelativeE ? line.E : line.E - machine.Extrusion.E;
        motion.E = motion.Change;
        motion.Feed = (mask & ChunkParser.HasF) != 0 ? line.F : machine.Feed.Rate;
        motion.Speed = (mask & ChunkParser.HasF) != 0 ? line.F / 60 : machine.Feed.Speed;
        return Moves(head, ref motion);
    }

    // What it has to do, in machine coordinates; false where that is more than a straight move.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool Wants(in Motion read, int number, out Motion wanted)
    {
        wanted = read;
        if (!_edits)
        {
            ref var head = ref _read.Head;
            wanted.X += head.ShiftX;
            wanted.Y += head.ShiftY;
            wanted.Z += head.ShiftZ;
            return true;
        }
        if (!_tasks.HasSingleMove(number, out var c, out var i) || c.Tool[i] != _written.Tool || c.Turns is not null || c.TryGetArc(i, out _)) return false;
        (wanted.X, wanted.Y, wanted.Z, wanted.E, wanted.Speed) = (c.X[i], c.Y[i], c.Z[i], c.E[i], c.Speed[i]);
        return true;
    }

    // Works out what its words have to be, and what it does then.
    [MethodImpl(Compile.Optimized)]
    private bool Rewrite(in LineRecord line, in WordPlaces places, in Motion wanted, double carried, ref Motion written)
    {
        int mask = line.Mask;
        bool hasX = (mask & ChunkParser.HasX) != 0, hasY = (mask & ChunkParser.HasY) != 0, hasZ = (mask & ChunkParser.HasZ) != 0,
            hasE = (mask & ChunkParser.HasE) != 0, hasF = (mask & ChunkParser.HasF) != 0;
        ref var head = ref _written.Head;
        var from = _written.Modes.RelativeE ? 0 : _written.Extrusion.E;
        if (!Axis(X, hasX, line.X, places, wanted.X - head.ShiftX, head.X) || !Axis(Y, hasY, line.Y, places, wanted.Y - head.ShiftY, head.Y)
            || !Axis(Z, hasZ, line.Z, places, wanted.Z - head.ShiftZ, head.Z) || !Extruder(hasE, line.E, places, wanted.E, from, carried)
            || !Feed(hasF, line.F, places, wanted.Speed))
        {
            return false;
        }
        if (hasX) written.X = _numbers[X].Value;
        if (hasY) written.Y = _numbers[Y].Value;
        if (hasZ) written.Z = _numbers[Z].Value;
        written.E = written.Change = hasE ? _numbers[E].Value - from : 0;
        if (hasF)
        {
            written.Feed = _numbers[F].Value;
            if (!(written.Feed > 0)) return false;
            written.Speed = written.Feed / 60;
        }
        return Moves(head, ref written);
    }

    private static bool KnowsWords(string letters) => letters.Length == 0 || !"GXYZEF".Except(letters).Any();

    // Whether a move is made of it, of numbers that are not unusually large.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Moves(in HeadPosition from, ref Motion to)
    {
        if (!(Math.Abs(to.X) < Largest && Math.Abs(to.Y) < Largest && Math.Abs(to.Z) < Largest && Math.Abs(to.E) < Largest)) return false;
        if (to.E < NoChange && to.E > -NoChange) to.E = 0;
        if (to.E != 0) return true;
        double dx = to.X - from.X, dy = to.Y - from.Y, dz = to.Z - from.Z;
        return dx * dx + dy * dy + dz * dz > NoChange * NoChange;
    }

    // Where a line of state before it would let the line stay: G92 E or F.
    private bool NeedsState(in LineRecord line, in Motion read, in Motion wanted)
    {
        if (!_written.Modes.RelativeE && Math.Abs(read.E - wanted.E) <= NoChange && (line.Mask & ChunkParser.HasE) != 0
            && Math.Abs(line.E - wanted.E - _written.Extrusion.E) > NoChange)
        {
            return true;
        }
        var speed = wanted.Speed;
        return Math.Abs(read.Speed - speed) <= 1e-9 * speed && speed > 0 && (line.Mask & ChunkParser.HasF) == 0
            && Math.Abs(speed - _written.Feed.Speed) > 1e-9 * speed;
    }

    // False where a word would have to be put in.
    private bool Axis(int slot, bool has, double says, in WordPlaces places, double target, double current)
    {
        if (!has) return !(Math.Abs(target - current) > _tolerance);
        if (Math.Abs(says - target) <= NoChange && MayStay(slot, places)) return Stays(slot, says);
        return Becomes(slot, target, _style.LimitXyz ?? Math.Max(places.DecimalsOf(slot), _style.DecimalsXyz));
    }

    private bool Extruder(bool has, double says, in WordPlaces places, double me, double from, double carried)
    {
        if (!has) return Math.Abs(me) < NoChange;
        var value = from + me + (me != 0 ? carried : 0);
        return Math.Abs(says - value) > NoChange || !MayStay(E, places) ? Becomes(E, value, _style.DecimalsE) : Stays(E, says);
    }

    private bool Feed(bool has, double says, in WordPlaces places, double speed)
    {
        if (!(speed > 0)) return !has || Stays(F, says);
        var feed = speed * 60;
        if (!has) return Math.Abs(_written.Feed.Rate - feed) <= Math.Max(1e-9 * feed, _style.FeedTolerance);
        if (Math.Abs(says - feed) <= 1e-9 * feed && MayStay(F, places)) return Stays(F, says);
        return Becomes(F, feed, _style.LimitF ?? Math.Max(_style.DecimalsF, Math.Min(places.DecimalsOf(F), 9)));
    }

    private bool MayStay(int slot, in WordPlaces places) => _limits is null || places.DecimalsOf(slot) <= _limits[slot];

    private bool IsTooFine(in WordPlaces places)
    {
        if (_limits is null) return false;
        for (var w = 0; w < places.Count; w++)
        {
            if (!MayStay(places.SlotAt(w), places)) return true;
        }
        return false;
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
        var at = start;
        for (var w = 0; w < places.Count; w++)
        {
            var slot = places.SlotAt(w);
            ref var number = ref _numbers[slot];
            if (number.Decimals < 0) continue;
            to.Copy(text, at, start + places.StartOf(slot));
            at = start + places.EndOf(slot);
            to.Replace(at, number.Units, number.Decimals);
        }
        to.Copy(text, at, next);
    }

    private static void Step(GCodeInterpreter machine, in LineRecord line, in Motion motion)
    {
        var state = machine.State;
        state.Modes.Motion = line.Op;
        ref var head = ref state.Head;
        (head.X, head.Y, head.Z) = (motion.X, motion.Y, motion.Z);
        state.Extrusion.E += motion.Change;
        if ((line.Mask & ChunkParser.HasF) != 0) state.Feed.Set(motion.Feed, 1);
        // Of its sums only the retraction matters.
        if (motion.E < 0) machine.Machine.Extruders.Pull(-motion.E);
        else if (motion.E > 0 && machine.Machine.Extruders.IsRetracted) machine.Machine.Extruders.Push(motion.E);
    }

    // What a line does: where it ends, the change of its E word and what that extrudes, its feed rate in mm/min and the speed that follows.
    private struct Motion
    {
        public double X;
        public double Y;
        public double Z;
        public double Change;
        public double E;
        public double Feed;
        public double Speed;
    }

    // A word of the current line: as it is read again, and as it is written where it changes (decimals of 0 and more).
    private struct Number
    {
        public double Value;
        public long Units;
        public int Decimals;
    }
}
