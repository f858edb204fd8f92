namespace Caterpillar.Curved;

/// <summary>
/// Paths that descend steeply are divided, and their descending parts are printed upward: going down, the flat of an upright nozzle would press into what
/// it has just printed.
/// </summary>
internal static class UphillPaths
{
    /// <summary>The path of a step, or its parts in the direction in which they are printed.</summary>
    public static IEnumerable<PathStep> Of(PathStep step)
    {
        var path = step.Path;
        var count = path.SegmentCount;
        if (!HasSteep(path, 0, count)) return [step];
        // A loop begins where it turns upward or downward.
        if (path.IsClosed)
            path = path.StartingAt(Enumerable.Range(0, count).FirstOrDefault(i => Descends(path, i) != Descends(path, (i + count - 1) % count)));
        var parts = new List<PathStep>();
        for (int from = 0, to; from < count; from = to)
        {
            to = Next(path, from);
            var down = HasSteep(path, from, to);
            while (!down && to < count && Next(path, to) is var next && !HasSteep(path, to, next)) to = next;
            var points = Enumerable.Range(from, to - from + 1).Select(i => path.RawPoints[i % path.RawPoints.Length]);
            var part = path.WithGeometry(points, Enumerable.Range(from, to - from).Select(path.BeadOf), closed: false);
            parts.Add(new PathStep(down ? part.Reversed() : part, step.Group) { KeepStart = true, Region = step.Region, Source = step.Source });
        }
        return parts;
    }

    // The end of the segments from one on that all descend, or all do not.
    private static int Next(PrintPath path, int from)
    {
        var to = from + 1;
        while (to < path.SegmentCount && Descends(path, to) == Descends(path, from)) to++;
        return to;
    }

    private static bool HasSteep(PrintPath path, int from, int to) => Enumerable.Range(from, to - from).Any(i => IsSteep(path, i));

    private static bool Descends(PrintPath path, int segment) => path.EndOf(segment).Z < path.RawPoints[segment].Z;

    // By more than 45°.
    private static bool IsSteep(PrintPath path, int segment)
    {
        var step = path.EndOf(segment) - path.RawPoints[segment];
        return -step.Z > step.LengthXY;
    }
}
