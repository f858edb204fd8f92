namespace Caterpillar.Toolpaths;

/// <summary>
/// Toolpaths in the coordinates of a machine with rotary axes, for controllers that know nothing of its kinematics: X, Y and Z are positions of the slides, and
/// moves are divided so that the tip stays on its path while every axis moves evenly.
/// </summary>
internal static class MachinePositions
{
    /// <summary>Distance of the tip from where it should be between two written points, mm.</summary>
    public const double Tolerance = 0.01;

    // Places at which a part of a move is looked at, and parts of a move at most.
    private const int Places = 8;
    private const int MostParts = 10_000;

    // Left for the rounding of what is written.
    private const double Margin = 0.8;

    // mm; less is rounding of the words.
    private const double Still = 1e-9;

    // What both ends of a move may be off where they are written, mm or degrees.
    private const double Rounding = 0.001;

    // What a speed may be off where it is written in whole mm/min, mm/s.
    private const double RoundingF = 0.5 / 60;

    /// <summary>The toolpath of the slides, of one in the frame of the part. Arcs become chords; every move keeps its time if all axes can.</summary>
    /// <param name="toolpath">The toolpath on the part.</param>
    /// <param name="kinematics">The rotary axes.</param>
    /// <param name="most">Maximum speeds of the slides, mm/s.</param>
    /// <param name="cancel">Cancels.</param>
    public static Toolpath ToMachine(Toolpath toolpath, Kinematics kinematics, Vec3 most, CancellationToken cancel)
    {
        var turns = Vec3.Zero;
        var whole = -1;
        var (from, to) = (Vec3.Zero, Vec3.Zero);
        // The pieces of an arc share its turn.
        double done = 0, parts = 1;
        Vec3? start = toolpath.Start is { } known ? kinematics.Machine(known, Vec3.Zero) : null;
        return StraightPieces.Rebuilt(toolpath, start, Add, null, cancel);

        void Add(ToolpathBuilder builder, Move piece)
        {
            if (piece.Index != whole)
            {
                (whole, from) = (piece.Index, to);
                to = toolpath.TurnsOf(piece.Index) ?? to;
                var move = toolpath[piece.Index];
                (done, parts) = (0, 1.0 / StraightPieces.Count(move));
            }
            done = Math.Min(1, done + parts);
            var end = done > 1 - 1e-9 ? to : Vec3.Lerp(from, to, done);
            var count = Divisions(kinematics, piece.Start, turns, piece.End, end);
            var at = kinematics.Machine(piece.Start, turns);
            for (var k = 1; k <= count; k++)
            {
                var words = Vec3.Lerp(turns, end, (double)k / count);
                var next = kinematics.Machine(Vec3.Lerp(piece.Start, piece.End, (double)k / count), words);
                double moved = next.DistanceTo(at), degrees = turns.DistanceTo(end) / count;
                // What does not move stays exactly where it is.
                if (moved < Still) (next, moved) = (at, 0);
                var (along, path) = (RotaryColumns.Share(piece.Length / count, degrees), RotaryColumns.Share(moved, degrees));
                var speed = along > 0 ? piece.Speed * path / along : piece.Speed;
                speed = Held(speed, path, Least(kinematics, next - at, (end - turns) / count, most));
                builder.Add(piece with { End = next, E = piece.E / count, Deposited = piece.Deposited / count, Speed = speed });
                builder.SetRotary(words);
                at = next;
            }
            turns = end;
        }
    }

    /// <summary>The time that the slowest axis needs, s.</summary>
    /// <param name="kinematics">The rotary axes.</param>
    /// <param name="slides">Move of the slides, mm.</param>
    /// <param name="words">Change of the rotary words, degrees.</param>
    /// <param name="most">Maximum speeds of the slides, mm/s.</param>
    public static double Least(Kinematics kinematics, Vec3 slides, Vec3 words, Vec3 most)
    {
        var time = Math.Max(Needs(slides.X, most.X), Math.Max(Needs(slides.Y, most.Y), Needs(slides.Z, most.Z)));
        foreach (var axis in kinematics.Axes) time = Math.Max(time, Needs(axis.Of(words), axis.MaxSpeed));
        return time;
    }

    /// <summary>The speed of a move of a length that takes at least a time in s.</summary>
    public static double Held(double speed, double length, double time)
    {
        if (!(time > 0)) return speed;
        var held = Math.Max(length - Rounding, length / 2) / time;
        return Math.Min(speed, Math.Max(held - RoundingF, held / 2));
    }

    private static double Needs(double distance, double speed) => distance == 0 ? 0 : (Math.Abs(distance) + Rounding) / speed;

    /// <summary>The toolpath in the frame of the part, of one of the slides that was read.</summary>
    public static Toolpath ToPart(Toolpath toolpath, Kinematics kinematics, CancellationToken cancel)
        => RotaryColumns.Mapped(toolpath, kinematics.Tip, keepsTurns: true, cancel);

    /// <summary>Number of even parts of a straight move with which the tip is never farther than <see cref="Tolerance"/> from where it should be.</summary>
    public static int Divisions(Kinematics kinematics, Vec3 a, Vec3 turnsA, Vec3 b, Vec3 turnsB)
    {
        if (turnsA == turnsB) return 1;
        const double Most = Tolerance * Margin;
        var error = Error(kinematics, a, turnsA, b, turnsB, 0, 1);
        // A turn that is too wide for the places says little: never more than a quarter of a circle at once.
        var count = (int)Math.Min(MostParts, Math.Max(Math.Ceiling(kinematics.Turn(turnsA, turnsB) / 90), Math.Ceiling(Math.Sqrt(error / Most))));
        for (; count < MostParts; count++)
        {
            var holds = true;
            for (var k = 0; k < count && holds; k++)
                holds = Error(kinematics, a, turnsA, b, turnsB, (double)k / count, (k + 1.0) / count) <= Most;
            if (holds) break;
        }
        return Math.Max(count, 1);
    }

    // The tip errs by what the slides are off: rotations keep lengths.
    private static double Error(Kinematics kinematics, Vec3 a, Vec3 turnsA, Vec3 b, Vec3 turnsB, double from, double to)
    {
        Vec3 At(double s) => kinematics.Machine(Vec3.Lerp(a, b, s), Vec3.Lerp(turnsA, turnsB, s));
        var (first, last) = (At(from), At(to));
        var most = 0.0;
        for (var k = 1; k < Places; k++)
        {
            var share = (double)k / Places;
            most = Math.Max(most, Vec3.Lerp(first, last, share).DistanceTo(At(from + (to - from) * share)));
        }
        return most;
    }
}
