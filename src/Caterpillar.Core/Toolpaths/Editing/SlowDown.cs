namespace Caterpillar.Toolpaths;

/// <summary>Slows paths down to a minimum time, all by the same factor, but not below a minimum speed.</summary>
internal static class SlowDown
{
    /// <summary>Time of a path, s, at the speeds that a function returns for each segment (mm/s).</summary>
    public static double TimeOf(PrintPath path, Func<PrintPath, int, double> speedOf)
        => Enumerable.Range(0, path.SegmentCount).Sum(i => path.LengthOf(i) / speedOf(path, i));

    /// <summary>The paths with lower speeds, or the same paths if they already take long enough.</summary>
    /// <param name="paths">The paths, in any order.</param>
    /// <param name="speedOf">Speed of a segment of a path, mm/s.</param>
    /// <param name="wanted">Minimum time, s.</param>
    /// <param name="least">Minimum speed, mm/s.</param>
    /// <param name="reached">False if the minimum speed is still too fast.</param>
    public static PrintPath[] To(IReadOnlyList<PrintPath> paths, Func<PrintPath, int, double> speedOf, double wanted, double least, out bool reached)
    {
        var slowed = new PrintPath[paths.Count];
        var time = 0.0;
        for (var i = 0; i < slowed.Length; i++) time += TimeOf(slowed[i] = paths[i], speedOf);
        reached = time >= wanted || !(time > 0);
        if (reached) return slowed;
        var factor = Factor(slowed, speedOf, time / wanted, wanted, least);
        time = 0;
        for (var i = 0; i < slowed.Length; i++)
        {
            var path = paths[i];
            slowed[i] = path.WithBeads(s =>
            {
                var speed = speedOf(path, s);
                return path.BeadOf(s) with { Speed = Math.Min(speed, Math.Max(speed * factor, least)) };
            });
            time += TimeOf(slowed[i], speedOf);
        }
        reached = time >= wanted * (1 - 1e-9);
        return slowed;
    }

    // Speeds at the minimum cannot drop further, so the others have to drop more: repeated until no other hits the minimum.
    private static double Factor(PrintPath[] paths, Func<PrintPath, int, double> speedOf, double factor, double wanted, double least)
    {
        for (var round = 0; round < 60; round++)
        {
            double slow = 0, free = 0;
            foreach (var path in paths)
            {
                for (var s = 0; s < path.SegmentCount; s++)
                {
                    var speed = speedOf(path, s);
                    if (speed * factor <= least) slow += path.LengthOf(s) / Math.Min(speed, least);
                    else free += path.LengthOf(s) / speed;
                }
            }
            var next = free > 0 && wanted > slow ? free / (wanted - slow) : 0;
            if (next >= factor * (1 - 1e-12)) break;
            factor = next;
        }
        return factor;
    }
}
