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

    // Shares of the lean that are tried.
    private static readonly double[] Shares = [1, 0.75, 0.5, 0.25, 0];

    /// <summary>Maximum lean of the tool from vertical, degrees; steeper directions are limited to it.</summary>
    public double MaxTilt { get; init; } = 180;

    /// <summary>Maximum change of the direction along a bead, degrees/mm: sharper turns begin before the place that asks for them and end after it.</summary>
    public double MaxChange { get; init; } = 10;

    /// <summary>
    /// True for a move that must not be made so, mm and degrees: the beads that have it lean less, down to upright, and travels take a detour. Beads that were
    /// found good are told to it.
    /// </summary>
    internal Func<Move, HeadMove, bool> Refuses { get; init; } = (_, _) => false;

    /// <inheritdoc cref="Refuses"/>
    internal Action<Move, HeadMove> Printed { get; init; } = (_, _) => { };

    /// <summary>The toolpath with rotary words. Arcs become chords.</summary>
    public Toolpath Apply(Toolpath toolpath, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var straight = kinematics.IsPolar ? Divided(toolpath, progress, cancel)
            : StraightPieces.Rebuilt(toolpath, toolpath.Start, (builder, piece) => builder.Add(piece), progress, cancel);
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
                var start = Allowed(straight, words, bead, end, last);
                if (!Travel(straight, words, first, bead, last, start)) turnsFirst[bead] = start;
                else Detour(straight, words, first, bead, travels, replaced);
                foreach (var (move, head) in Heads(straight, words, bead, end, start)) Printed(move, head);
                last = words[end - 1];
            }
            first = end;
        }
        var next = 0;
        return StraightPieces.Rebuilt(straight, straight.Start, (builder, piece) =>
        {
            // Without a travel to a bead the tool turns before it.
            if (turnsFirst.TryGetValue(next, out var before)) Turn(builder, builder.Position, before, piece);
            foreach (var (end, turned, speed) in replaced.TryGetValue(next, out var moves) ? moves : [(piece.End, words[next], piece.Speed)])
            {
                builder.Add(piece with { End = end, Speed = speed });
                builder.SetRotary(turned);
            }
            if (++next == words.Length) StandUp(builder, words[next - 1], piece, travels);
        }, null, cancel);
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

    // The words of a bead that nothing refuses, with as much of the lean as possible; those with all of it where there are none.
    private Vec3 Allowed(Toolpath path, Vec3[] words, int bead, int end, Vec3 last)
    {
        var aims = Aims(path, bead, end);
        var most = aims.Max(a => Angle.Atan2(a.LengthXY, a.Z));
        foreach (var share in Shares)
        {
            var start = Follow(path, [.. aims.Select(a => Capped(a, most * share))], words, bead, end, last);
            if (!Heads(path, words, bead, end, start).Any(h => Refuses(h.Move, h.Head))) return start;
        }
        return Follow(path, aims, words, bead, end, last);
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
    private Vec3[] Aims(Toolpath path, int bead, int end)
    {
        var aims = new Vec3[end - bead + 1];
        aims[0] = Lean(path[bead].Start);
        for (var i = bead; i < end; i++) aims[i - bead + 1] = Lean(path[i].End);
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
