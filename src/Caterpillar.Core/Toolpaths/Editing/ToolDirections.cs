namespace Caterpillar.Toolpaths;

/// <summary>
/// Leans the tool of a toolpath: every move ends with the rotary words of a machine. X, Y and Z stay the position of the nozzle tip on the part. Within a bead
/// the words change as little as they can; between beads the tool turns during the travel, after it has left the one and before it comes to the other. At the
/// end it stands upright again.
/// </summary>
/// <param name="kinematics">The axes of the machine.</param>
/// <param name="tool">The direction from the tip to the head at a point in mm, of any length.</param>
public sealed class ToolDirections(Kinematics kinematics, Func<Vec3, Vec3> tool)
{
    // Speed of a turn and of leaving the print at the end, mm/s and degrees/s.
    private const double Leaving = 20;
    private const int MostParts = 1024;

    // Steps in which the tool leans less where something is hit, as shares of the lean; along a bead so far from there, mm, it leans less, too.
    private const double ShareStep = 0.25;
    private const double Near = 10;
    private const int MostTries = 16;

    /// <summary>Maximum lean of the tool from vertical, degrees; steeper directions are limited to it.</summary>
    public double MaxTilt { get; init; } = 180;

    /// <summary>Maximum change of the direction along a bead, degrees/mm: sharper turns begin before the place that asks for them and end after it.</summary>
    public double MaxChange { get; init; } = 10;

    /// <summary>Maximum speeds of the slides, mm/s, for files that state the tip: moves are as slow as all axes need. Null for others.</summary>
    internal Vec3? SlideSpeeds { get; init; }

    /// <summary>True for a travel that must not be made so, mm and degrees: it takes a detour.</summary>
    internal Func<Move, HeadMove, bool> Refuses { get; init; } = (_, _) => false;

    /// <summary>
    /// The moves of a bead, by their place in it, that must not be made so, and those at its ends that no travel can leave or reach: there it leans less, down
    /// to upright.
    /// </summary>
    internal Func<IEnumerable<(Move Move, HeadMove Head)>, IReadOnlyList<int>> RefusedIn { get; init; } = _ => [];

    /// <summary>Is told of the moves of each bead.</summary>
    internal Action<Move, HeadMove> Printed { get; init; } = (_, _) => { };

    /// <summary>The toolpath with rotary words. Arcs become chords.</summary>
    public Toolpath Apply(Toolpath toolpath, IProgress<double>? progress = null, CancellationToken cancel = default)
        => Apply(toolpath, progress, cancel, out _);

    // Also counts the beads for which no lean was found.
    internal Toolpath Apply(Toolpath toolpath, IProgress<double>? progress, CancellationToken cancel, out int refused)
    {
        refused = 0;
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var (divided, aimed) = (progress.Part(0, 0.1), progress.Part(0.1, 1));
        var straight = kinematics.IsPolar ? Divided(toolpath, divided, cancel)
            : StraightPieces.Rebuilt(toolpath, toolpath.Start, (builder, piece) => builder.Add(piece), divided, cancel);
        var words = new Vec3[straight.Count];
        // Words before beads to which no travel leads.
        var turnsFirst = new Dictionary<int, Vec3>();
        var travels = new LeaningTravels(kinematics, head => Refuses(new Move { Kind = MoveKind.Travel, Layer = -1 }, head));
        // What becomes of moves of travels that would hit something.
        var replaced = new Dictionary<int, IReadOnlyList<(Vec3 End, Vec3 Words, double Speed)>>();
        var last = Vec3.Zero;
        for (var first = 0; first < words.Length;)
        {
            cancel.ThrowIfCancellationRequested();
            // The travel to a bead, and the bead.
            var bead = first;
            while (bead < words.Length && straight[bead].Kind != MoveKind.Print) bead++;
            var end = bead;
            while (end < words.Length && straight[end].Kind == MoveKind.Print) end++;
            if (kinematics.IsPolar || bead == words.Length)
            {
                for (var i = first; i < end; i++) words[i] = last = straight[i].Length > 0 ? At(straight[i].End, last) : last;
            }
            else
            {
                var start = Allowed(straight, words, bead, end, last, ref refused);
                if (!Travel(straight, words, first, bead, last, start)) turnsFirst[bead] = start;
                else Detour(straight, words, first, bead, travels, replaced);
                foreach (var (move, head) in Heads(straight, words, bead, end, start)) Printed(move, head);
                last = words[end - 1];
            }
            first = end;
            aimed?.Report((double)end / words.Length);
        }
        var next = 0;
        last = Vec3.Zero;
        return StraightPieces.Rebuilt(straight, straight.Start, (builder, piece) =>
        {
            // Without a travel to a bead the tool turns before it.
            if (turnsFirst.TryGetValue(next, out var before)) Turn(builder, builder.Position, last = before, piece);
            foreach (var (end, turned, speed) in replaced.TryGetValue(next, out var moves) ? moves : [(piece.End, words[next], piece.Speed)])
            {
                builder.Add(piece with { End = end, Speed = Held(builder.Position, end, last, turned, speed) });
                builder.SetRotary(turned);
                last = turned;
            }
            if (++next == words.Length) StandUp(builder, words[next - 1], piece, travels);
        }, null, cancel);
    }

    private double Held(Vec3 from, Vec3 to, Vec3 before, Vec3 after, double speed)
    {
        if (SlideSpeeds is not { } most || before == after) return speed;
        var slides = kinematics.Machine(to, after) - kinematics.Machine(from, before);
        var length = RotaryColumns.Share(from.DistanceTo(to), before.DistanceTo(after));
        return MachinePositions.Held(speed, length, MachinePositions.Least(kinematics, slides, after - before, most));
    }

    private Vec3 Lean(Vec3 p) => Capped(tool(p).Unit(), MaxTilt);

    private static Vec3 Capped(Vec3 direction, double most)
    {
        if (Angle.Atan2(direction.LengthXY, direction.Z) <= most) return direction;
        var (sin, cos) = Angle.SinCos(most);
        var aside = new Vec3(direction.X, direction.Y).Unit();
        return (aside * sin).WithZ(cos);
    }

    private Vec3 At(Vec3 p, Vec3 last) => kinematics.Nearest(p, Lean(p), last);

    // The words of a bead that nothing refuses, with as much of the lean as possible everywhere; those with all of it where there are none.
    private Vec3 Allowed(Toolpath path, Vec3[] words, int bead, int end, Vec3 last, ref int refusedBeads)
    {
        var less = new double[end - bead + 1];
        for (var tries = 0; tries < MostTries; tries++)
        {
            var start = Follow(path, Aims(path, bead, end, less), words, bead, end, last);
            var refused = RefusedIn(Heads(path, words, bead, end, start));
            if (refused.Count == 0) return start;
            if (!LeanLess(path, bead, less, refused)) break;
        }
        refusedBeads++;
        return Follow(path, Aims(path, bead, end, new double[less.Length]), words, bead, end, last);
    }

    // False if the tool is upright already.
    private static bool LeanLess(Toolpath path, int bead, double[] less, IEnumerable<int> refused)
    {
        var before = (double[])less.Clone();
        foreach (var move in refused)
        {
            var share = Math.Max(before[move], before[move + 1]) + ShareStep;
            if (share > 1) return false;
            double away = 0;
            for (var i = move; i >= 0 && away <= Near; i--)
            {
                less[i] = Math.Max(less[i], share);
                if (i > 0) away += path[bead + i - 1].Length;
            }
            away = 0;
            for (var i = move + 1; i < less.Length && away <= Near; i++)
            {
                less[i] = Math.Max(less[i], share);
                if (i + 1 < less.Length) away += path[bead + i].Length;
            }
        }
        return true;
    }

    // The moves of a part of the path, with the head from one end to the other.
    private static IEnumerable<(Move Move, HeadMove Head)> Heads(Toolpath path, Vec3[] words, int first, int end, Vec3 before)
    {
        for (var i = first; i < end; before = words[i++]) yield return (path[i], new HeadMove(path[i].Start, before, path[i].End, words[i]));
    }

    // Other moves for a travel to a bead, if the planned ones hit something.
    private static void Detour(
        Toolpath path, Vec3[] words, int first, int bead, LeaningTravels travels, Dictionary<int, IReadOnlyList<(Vec3 End, Vec3 Words, double Speed)>> replaced)
    {
        int begin = first, end = bead;
        while (begin < end && !IsTravel(path[begin])) begin++;
        while (begin < end && !IsTravel(path[end - 1])) end--;
        var planned = Heads(path, words, begin, end, begin > 0 ? words[begin - 1] : Vec3.Zero).Where(h => !h.Move.IsInPlace).ToArray();
        if (planned.Any(h => !IsTravel(h.Move)) || travels.Find([.. planned.Select(h => h.Head)]) is not { } moves) return;
        var speed = planned.Max(h => h.Move.Speed);
        var last = moves[moves.Count - 1];
        for (var i = begin; i < end; i++) replaced[i] = path[i].IsInPlace ? [(last.To, last.ToTurns, path[i].Speed)] : [];
        replaced[begin] = [.. moves.Select(m => (m.To, m.ToTurns, speed))];
    }

    private static bool IsTravel(in Move move) => move.Kind == MoveKind.Travel && !move.IsInPlace && move.E == 0;

    // The directions at the start of a bead and at the ends of its moves, that change by no more than they may.
    private Vec3[] Aims(Toolpath path, int bead, int end, double[] less)
    {
        var aims = new Vec3[end - bead + 1];
        aims[0] = Lean(path[bead].Start);
        for (var i = bead; i < end; i++) aims[i - bead + 1] = Lean(path[i].End);
        for (var i = 0; i < aims.Length; i++)
        {
            if (less[i] > 0) aims[i] = Capped(aims[i], (1 - less[i]) * Angle.Atan2(aims[i].LengthXY, aims[i].Z));
        }
        var (onward, back) = ((Vec3[])aims.Clone(), (Vec3[])aims.Clone());
        for (var i = 1; i < aims.Length; i++) onward[i] = Toward(onward[i - 1], aims[i], path[bead + i - 1].Length * MaxChange);
        for (var i = aims.Length - 2; i >= 0; i--) back[i] = Toward(back[i + 1], aims[i], path[bead + i].Length * MaxChange);
        for (var i = 0; i < aims.Length; i++) aims[i] = (onward[i] + back[i]).Unit() is { LengthSquared: > 0 } middle ? middle : onward[i];
        return aims;
    }

    // From one direction to another, by an angle at most.
    private static Vec3 Toward(Vec3 from, Vec3 to, double most)
    {
        var cross = Vec3.Cross(from, to);
        var angle = Angle.Atan2(cross.Length, Vec3.Dot(from, to));
        if (angle <= most) return to;
        var (sin, cos) = Angle.SinCos(most);
        var across = cross.Length > 1e-9 ? Vec3.Cross(cross.Unit(), from) : Vec3.Cross(from, Math.Abs(from.X) < 0.9 ? Vec3.UnitX : Vec3.UnitY).Unit();
        return from * cos + across * sin;
    }

    // Fills in the words of a bead and returns those at its start: of all that keep within the limits, those that are nearest to the words before.
    private Vec3 Follow(Toolpath path, Vec3[] aims, Vec3[] words, int bead, int end, Vec3 last)
    {
        var begin = path[bead].Start;
        var starts = new List<Vec3>();
        foreach (var solution in kinematics.Solutions(begin, Kinematics.Snapped(aims[0]), last))
        {
            var near = kinematics.NearestTurns(solution, last, out _);
            starts.Add(near);
            foreach (var axis in kinematics.Axes)
            {
                // Another turn may leave more of a limited axis.
                if (double.IsInfinity(axis.Min) && double.IsInfinity(axis.Max)) continue;
                starts.Add(axis.With(near, axis.Of(near) + 360));
                starts.Add(axis.With(near, axis.Of(near) - 360));
            }
        }
        var best = starts.Where(s => kinematics.IsWithin(s)).OrderBy(s => kinematics.Change(last, s).Largest).ThenBy(s => kinematics.Change(last, s).Sum)
            .Cast<Vec3?>().FirstOrDefault(s => Keeps(s!.Value)) ?? kinematics.Nearest(begin, aims[0], last);
        Keeps(best);
        return best;

        bool Keeps(Vec3 at)
        {
            for (var i = bead; i < end; i++)
            {
                var before = at;
                words[i] = at = kinematics.Nearest(path[i].End, aims[i - bead + 1], at);
                // A tool that swings round farther than it leans has changed sides.
                if (!kinematics.IsWithin(at) || kinematics.Turn(before, at) > 180) return false;
            }
            return true;
        }
    }

    // Fills in the words of the travel to a bead. False if the tool cannot turn during it.
    private static bool Travel(Toolpath path, Vec3[] words, int first, int bead, Vec3 from, Vec3 to)
    {
        int leaves = first, arrives = bead - 1;
        while (leaves < bead && !(path[leaves].Length > 0)) leaves++;
        while (arrives >= first && !(path[arrives].Length > 0)) arrives--;
        for (var i = first; i < bead; i++) words[i] = i < leaves || (i == leaves && arrives > leaves) ? from : arrives < leaves ? from : to;
        return from == to || leaves <= arrives;
    }

    private static void Turn(ToolpathBuilder builder, Vec3 at, Vec3 words, in Move like)
    {
        builder.Add(like with { End = at, E = 0, Deposited = 0, Kind = MoveKind.Travel, Speed = Leaving });
        builder.SetRotary(words);
    }

    // Away from the print, then upright.
    private void StandUp(ToolpathBuilder builder, Vec3 words, in Move last, LeaningTravels travels)
    {
        if (kinematics.Direction(words) == Vec3.UnitZ && !kinematics.Axes.Any(a => a.TurnsWork && a.Of(words) % 360 != 0)) return;
        var upright = words;
        foreach (var axis in kinematics.Axes)
            upright = axis.With(upright, axis.About == PathAxis.Z ? 360 * Math.Floor(axis.Of(words) / 360 + 0.5) : 0);
        foreach (var head in travels.StandUp(builder.Position, words, kinematics.IsPolar ? words : upright)) Turn(builder, head.To, head.ToTurns, last);
    }

    // On a polar machine the platform follows the tip: moves are divided so that even turns keep the tip on its path.
    private Toolpath Divided(Toolpath toolpath, IProgress<double>? progress, CancellationToken cancel)
    {
        var last = Vec3.Zero;
        return StraightPieces.Rebuilt(toolpath, toolpath.Start, Add, progress, cancel);

        void Add(ToolpathBuilder builder, Move piece)
        {
            var count = 1;
            if (piece.Length > 0)
            {
                last = At(piece.Start, last);
                while (count < MostParts && !Holds(piece, count)) count *= 2;
            }
            for (var k = 1; k <= count; k++)
            {
                var end = Vec3.Lerp(piece.Start, piece.End, (double)k / count);
                builder.Add(piece with { End = end, E = piece.E / count, Deposited = piece.Deposited / count });
            }
            last = At(piece.End, last);
        }

        bool Holds(in Move piece, int count)
        {
            var (at, turns) = (piece.Start, last);
            for (var k = 1; k <= count; k++)
            {
                var next = Vec3.Lerp(piece.Start, piece.End, (double)k / count);
                var words = At(next, turns);
                if (MachinePositions.Divisions(kinematics, at, turns, next, words) > 1) return false;
                (at, turns) = (next, words);
            }
            return true;
        }
    }
}
