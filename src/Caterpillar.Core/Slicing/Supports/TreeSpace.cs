namespace Caterpillar.Slicing;

/// <summary>Where branches of trees cannot be, level by level: too near to the part, or with no way down to the bed.</summary>
internal sealed class TreeSpace
{
    private const double ArcTolerance = 0.03;
    private readonly Region[] _blocked;
    private readonly Region[] _trapped;

    /// <param name="levels">What supports keep out of on the levels up to the highest tip, and their thickness, mm.</param>
    /// <param name="radius">What branches keep clear of obstacles, mm.</param>
    /// <param name="slope">mm that branches lean out for each mm down.</param>
    /// <param name="options">Threads, and cancelling.</param>
    public TreeSpace((Region[] Obstacles, double Thickness)[] levels, double radius, double slope, ParallelOptions options)
    {
        _blocked = new Region[levels.Length];
        _trapped = new Region[levels.Length];
        RegionEngine.ForEach(0, levels.Length, options, (i, engine) => _blocked[i] = Region.Union(levels[i].Obstacles, engine)
            .Offset(radius, JoinStyle.Round, 2, ArcTolerance, engine).Simplified(ArcTolerance, engine));
        var clipper = new RegionEngine();
        for (var i = 0; i < levels.Length; i++)
        {
            options.CancellationToken.ThrowIfCancellationRequested();
            _trapped[i] = _blocked[i];
            if (i == 0 || _trapped[i - 1].IsEmpty) continue;
            // Less than branches lean: those at its edge stay outside where it is rounded.
            var left = _trapped[i - 1].Offset(-0.95 * slope * levels[i].Thickness, JoinStyle.Round, 2, ArcTolerance, clipper);
            if (!_blocked[i].Surrounds(left)) _trapped[i] = left.Union(_blocked[i], clipper).Simplified(ArcTolerance / 2, clipper);
        }
    }

    /// <summary>Whether the middle of a branch is too near to the part.</summary>
    public bool IsBlocked(int level, Vec3 place) => _blocked[level].Contains(place.X, place.Y);

    /// <summary>Whether no path leads from a place to the bed.</summary>
    public bool IsTrapped(int level, Vec3 place) => _trapped[level].Contains(place.X, place.Y);

    /// <summary>The nearest place from which a path leads to the bed.</summary>
    public Vec3 NearestExit(int level, Vec3 place) => _trapped[level].NearestEdge(place) ?? place;

    /// <summary>mm that a branch may be moved, or be thicker than that; at most 5.</summary>
    public double Room(int level, Vec3 place)
    {
        const double Most = 5;
        if (IsBlocked(level, place)) return 0;
        return _blocked[level].NearestEdge(place, Most)?.DistanceTo(place) ?? Most;
    }
}
