namespace Caterpillar.Toolpaths;

/// <summary>
/// Travels for a tool that leans: away from a bead along the tool, across, and along the tool to the next bead. On the side of an object a travel that only
/// rises would drag the nozzle along.
/// </summary>
/// <param name="kinematics">The axes of the machine.</param>
/// <param name="refuses">True for a move at which the head would hit something.</param>
internal sealed class LeaningTravels(Kinematics kinematics, Func<HeadMove, bool> refuses)
{
    // Cosine of the lean beyond which a tool must not leave a bead by rising.
    private const double Steep = 0.7;

    // How far away from the beads is tried, mm.
    private static readonly double[] Distances = [1, 2, 5, 10, 20, 40, 80];

    /// <summary>
    /// The moves of a travel that hits nothing, as near to the beads as possible. Null to keep the planned ones: they hit nothing, and are the shortest or the
    /// tool leans little; or all hit something.
    /// </summary>
    public IReadOnlyList<HeadMove>? Find(IReadOnlyList<HeadMove> planned)
    {
        if (planned.Count == 0) return null;
        var (first, last) = (planned[0], planned[planned.Count - 1]);
        double most = 0;
        if (planned.Any(refuses)) most = double.PositiveInfinity;
        else if (LeansMuch(first.FromTurns) && LeansMuch(last.ToTurns)) most = Length(planned);
        var top = planned.Max(m => m.To.Z);
        return Distances.Select(d => Moves(d, null)).Concat(Distances.Select(d => Moves(d, top)))
            .FirstOrDefault(moves => Length(moves) < most && !moves.Any(refuses));

        // Straight across, or with the tool upright over a height.
        HeadMove[] Moves(double distance, double? over)
        {
            var away = first.From + kinematics.Direction(first.FromTurns) * distance;
            var near = last.To + kinematics.Direction(last.ToTurns) * distance;
            List<(Vec3 Place, Vec3 Turns)> ends = [(first.From, first.FromTurns), (away, first.FromTurns), (near, last.ToTurns), (last.To, last.ToTurns)];
            if (over is { } height)
            {
                height = Math.Max(height, Math.Max(away.Z, near.Z));
                ends.InsertRange(2, [(away.WithZ(height), Upright(first.FromTurns)), (near.WithZ(height), Upright(last.ToTurns))]);
            }
            return [.. ends.Skip(1).Select((end, i) => new HeadMove(ends[i].Place, ends[i].Turns, end.Place, end.Turns))];
        }
    }

    /// <summary>The moves from the last bead to where the tool can stand up without hitting anything; the shortest if there are none.</summary>
    /// <param name="from">End of the bead, mm.</param>
    /// <param name="words">The rotary words there, degrees.</param>
    /// <param name="upright">The rotary words at which the tool stands upright, degrees.</param>
    public IReadOnlyList<HeadMove> StandUp(Vec3 from, Vec3 words, Vec3 upright)
    {
        var tries = Distances.Where(d => d >= 5).Select(Leaves).ToArray();
        return tries.FirstOrDefault(moves => !moves.Any(refuses)) ?? tries[0];

        HeadMove[] Leaves(double distance)
        {
            var away = from + kinematics.Direction(words) * distance;
            var leaves = new HeadMove(from, words, away, words);
            return words == upright ? [leaves] : [leaves, new HeadMove(away, words, away, upright)];
        }
    }

    private bool LeansMuch(Vec3 words) => kinematics.Direction(words).Z < Steep;

    private static double Length(IEnumerable<HeadMove> moves) => moves.Sum(m => m.From.DistanceTo(m.To));

    private Vec3 Upright(Vec3 words)
    {
        foreach (var axis in kinematics.Axes.Where(a => a.About != PathAxis.Z)) words = axis.With(words, 0);
        return words;
    }
}
