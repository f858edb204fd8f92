namespace Caterpillar.Slicing;

/// <summary>
/// Chooses where the loops of a body begin, layer after layer from below: a seam follows the one below it, so this is the one pass over finished layers
/// that hands something on.
/// </summary>
internal sealed class SeamPlacer(Body body)
{
    // How far a loop may have moved away from the seam below it, mm, or as a share of its length.
    private const double Reach = 2;
    private const double ReachShare = 0.1;

    // How near to a corner an inner wall begins at it, mm.
    private const double Uncut = 0.15;

    // Where less than this share of a loop is held, and its seam would go farther than this to get there, mm, it stays in line with those below in the air.
    private const double HardlyHeld = 0.25;
    private const double Hop = 2;

    private List<Seam> _below = [];

    // The seam of an outer wall, on which side of it the part lies, whether it lies over air, and the wall with its length, mm.
    private readonly record struct Seam(Vec3 Point, bool IsHole, bool InAir, Vec3[] Loop, double Length);

    /// <summary>The next layer, its loops beginning at their seams.</summary>
    public SlicedLayer Next(LayerWork work, SlicedLayer layer)
    {
        var settings = work.Rules.Settings;
        if (work.Chains.Count == 0) return layer;
        var chains = work.Chains;
        work.Chains = [];
        var places = new LoopPlace?[chains.Count];
        var loops = chains.Select(c => layer.Steps[c.Outer].Path.RawPoints).ToArray();
        Choose(loops, chains, places, work);
        var steps = new List<PathStep>(layer.Steps);
        for (var i = 0; i < places.Length; i++)
        {
            if (places[i] is not { } place) continue;
            var chain = chains[i];
            for (var k = chain.First; k < chain.First + chain.Count; k++)
            {
                // Inner walls begin beside the seam: the travel over them is hardly longer than one to the seam alone. No segment is cut into short ones.
                var path = steps[k].Path;
                var start = k == chain.Outer ? place : LoopPlace.Nearest(path.RawPoints, place.Point).Snapped(path.RawPoints, Uncut);
                if (k != chain.Outer && chain.SupportOf(k) is { } support) start = support.Near(path.RawPoints, start);
                path = start.Start(path);
                if (k == chain.Outer && work.Index > 0) path = ScarfSeam.Apply(path, work.Plan.Thickness, settings);
                steps[k] = steps[k] with { Path = path, KeepStart = true };
            }
        }
        return layer with { Steps = steps };
    }

    private void Choose(Vec3[][] loops, IReadOnlyList<WallChain> chains, LoopPlace?[] places, LayerWork work)
    {
        var settings = work.Rules.Settings;
        var arm = 2 * work.Rules.Width;
        var matches = settings.SeamPosition is SeamPosition.Aligned or SeamPosition.Corner ? Matches(loops) : null;
        var seams = new List<Seam>(loops.Length);
        for (var i = 0; i < loops.Length; i++)
        {
            var loop = loops[i];
            Seam? followed = matches is not null && matches[i] >= 0 ? _below[matches[i]] : null;
            var below = followed?.Point;
            var support = chains[i].SupportOf(chains[i].Outer);
            var painted = Painted(loop, work);
            places[i] = painted ?? settings.SeamPosition switch
            {
                SeamPosition.Nearest => support is null or { IsNowhere: true } ? null : LoopPlace.AtVertex(loop, 0),
                SeamPosition.Rear => LoopPlace.Nearest(loop, Rear()),
                SeamPosition.Point => LoopPlace.Nearest(loop, settings.SeamPoint),
                SeamPosition.Random => Anywhere(loop, settings.SeamSeed, work.Index, i),
                SeamPosition.Corner => BestCorner(loop, below, arm),
                _ => below is { } seam ? Above(loop, seam, arm) : BestCorner(loop, null, arm),
            };
            var inAir = support is { IsNowhere: true };
            if (support is not null && places[i] is { } chosen && painted is null)
            {
                var held = support.Near(loop, chosen);
                inAir |= followed is { InAir: true } && settings.SeamPosition == SeamPosition.Aligned && support.Share < HardlyHeld
                    && held.Point.DistanceTo(chosen.Point) > Hop;
                if (!inAir) places[i] = held;
            }
            if (places[i] is { } place) seams.Add(new Seam(place.Point, IsHole(loop), inAir, loop, LengthOf(loop)));
        }
        _below = seams;
    }

    // The painted place nearest to a loop that passes through it.
    private static LoopPlace? Painted(Vec3[] loop, LayerWork work)
    {
        LoopPlace? best = null;
        var least = double.PositiveInfinity;
        var middle = work.Plan.Top - work.Plan.Thickness / 2;
        foreach (var mark in work.Rules.Settings.SeamEnforcers)
        {
            if (Math.Abs(mark.Place.Z - middle) > mark.Radius) continue;
            var place = LoopPlace.Nearest(loop, mark.Place);
            var square = (place.Point.WithZ(middle) - mark.Place).LengthSquared;
            if (square > mark.Radius * mark.Radius || square >= least) continue;
            least = square;
            best = place;
        }
        return best;
    }

    // A point far away at the back, so that the nearest place is the rearmost, in the middle of the body where several are.
    private Vec3 Rear()
    {
        var box = body.Model.Mesh.Bounds;
        return new Vec3(box.Center.X, box.Max.Y + 10 * (1 + box.Size.X + box.Size.Y));
    }

    private static LoopPlace Anywhere(Vec3[] loop, int seed, int layer, int number)
        => LoopPlace.AtLength(loop, LengthOf(loop) * new SeededRandom(unchecked((seed * 31 + layer) * 1009 + number)).NextDouble());

    // The corner that hides a seam best; the one nearest to the seam below, or to the back, among those as good. A smooth loop has its seam at the back.
    private LoopPlace BestCorner(Vec3[] loop, Vec3? below, double arm)
    {
        const double Good = 0.15, Same = 0.1;
        var near = below ?? Rear();
        var best = -1;
        double bestScore = 0, bestSquare = 0;
        for (var i = 0; i < loop.Length; i++)
        {
            var score = Math.Floor(LoopCorner.Score(loop, i, arm) / Same);
            var square = (loop[i] - near).LengthSquared;
            if (best >= 0 && (score < bestScore || (score == bestScore && square >= bestSquare))) continue;
            (best, bestScore, bestSquare) = (i, score, square);
        }
        return bestScore * Same >= Good ? LoopPlace.AtVertex(loop, best) : LoopPlace.Nearest(loop, near);
    }

    // Right above the seam below, or in a good corner close by.
    private static LoopPlace Above(Vec3[] loop, Vec3 below, double arm)
    {
        const double Near = 1, Least = 0.2;
        var place = LoopPlace.Nearest(loop, below);
        var bestValue = 0.0;
        for (var i = 0; i < loop.Length; i++)
        {
            var distance = (loop[i] - place.Point).LengthXY;
            if (distance >= Near) continue;
            var value = LoopCorner.Score(loop, i, arm) - Least - 0.5 * distance / Near;
            if (value <= bestValue) continue;
            bestValue = value;
            place = LoopPlace.AtVertex(loop, i);
        }
        return place;
    }

    // For each loop the seam below that it goes on with, or −1.
    private int[] Matches(Vec3[][] loops)
    {
        var pairs = new List<(double Square, int Seam, int Loop)>();
        var order = Enumerable.Range(0, _below.Count).OrderBy(k => _below[k].Point.X).ToArray();
        var along = Array.ConvertAll(order, k => _below[k].Point.X);
        var nearest = new (double Square, int Loop)[_below.Count];
        for (var k = 0; k < nearest.Length; k++) nearest[k] = (Reach * Reach, -1);
        for (var i = 0; i < loops.Length; i++)
        {
            var box = Bounds.Of(loops[i]);
            var reach = Math.Max(Reach, ReachShare * 2 * (box.Size.X + box.Size.Y));
            var isHole = IsHole(loops[i]);
            // A little more than what is in reach, which the test below decides.
            var first = Array.BinarySearch(along, box.Min.X - 1.001 * reach);
            for (var at = first < 0 ? ~first : first; at < order.Length && along[at] <= box.Max.X + 1.001 * reach; at++)
            {
                var k = order[at];
                if (_below[k].IsHole != isHole || WallChains.SquareTo(box, _below[k].Point) > reach * reach) continue;
                var square = SquareTo(loops[i], _below[k].Point);
                if (square <= reach * reach) pairs.Add((square, k, i));
                if (square < nearest[k].Square) nearest[k] = (square, i);
            }
        }
        pairs.Sort();
        var matches = Joined(nearest, loops.Length);
        var isNear = Array.ConvertAll(matches, m => m >= 0);
        var taken = new bool[_below.Count];
        foreach (var match in matches)
        {
            if (match >= 0) taken[match] = true;
        }
        // Seams farther off go on with one loop each, the nearest pairs first.
        foreach (var (_, seam, loop) in pairs)
        {
            if (taken[seam] || matches[loop] >= 0) continue;
            taken[seam] = true;
            matches[loop] = seam;
        }
        for (var i = 0; i < loops.Length; i++)
        {
            if (!isNear[i]) matches[i] = Shared(loops[i], matches[i]);
        }
        return matches;
    }

    // Seams in reach go on with the loop nearest to them. Where contours join, it goes on with the nearest seam of the large ones: a body keeps its own
    // where a finger joins it.
    private int[] Joined((double Square, int Loop)[] nearest, int loops)
    {
        const double Large = 0.5;
        var longest = new double[loops];
        for (var k = 0; k < nearest.Length; k++)
        {
            if (nearest[k].Loop is >= 0 and var loop) longest[loop] = Math.Max(longest[loop], _below[k].Length);
        }
        var matches = Enumerable.Repeat(-1, loops).ToArray();
        for (var k = 0; k < nearest.Length; k++)
        {
            var (square, loop) = nearest[k];
            if (loop < 0 || _below[k].Length < Large * longest[loop]) continue;
            if (matches[loop] < 0 || square < nearest[matches[loop]].Square) matches[loop] = k;
        }
        return matches;
    }

    // Parts of a split share a seam: the nearest of a contour that the loop lies along. A loop with a seam far off leaves it only for one in reach.
    private int Shared(Vec3[] loop, int own)
    {
        var isHole = IsHole(loop);
        var box = Bounds.Of(loop);
        var best = own;
        var least = own >= 0 ? Reach * Reach : double.PositiveInfinity;
        for (var k = 0; k < _below.Count; k++)
        {
            // A contour goes no farther from its seam than half its length.
            var far = Reach + _below[k].Length / 2;
            if (_below[k].IsHole != isHole || WallChains.SquareTo(box, _below[k].Point) > Math.Min(least, far * far)) continue;
            var square = SquareTo(loop, _below[k].Point);
            if (square >= least || (square > Reach * Reach && !LoopGap.IsWithin(loop, _below[k].Loop, Reach))) continue;
            (best, least) = (k, square);
        }
        return best;
    }

    private static double LengthOf(Vec3[] loop) => Polyline.Own(loop, closed: true).Length;

    private static double SquareTo(Vec3[] loop, Vec3 point) => (LoopPlace.Nearest(loop, point).Point - point).WithZ(0).LengthSquared;

    private static bool IsHole(Vec3[] loop) => Polyline.Own(loop, closed: true).SignedAreaXY < 0;
}
