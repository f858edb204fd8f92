namespace Caterpillar.Slicing;

/// <summary>An extrusion of infill.</summary>
/// <param name="Points">mm, at the height of the request; a closed line does not repeat its first point.</param>
/// <param name="Closed">A loop.</param>
/// <param name="Flow">Flow ratio of each segment, or null if it is 1 throughout.</param>
internal sealed record InfillLine(Vec3[] Points, bool Closed, double[]? Flow = null)
{
    // mm; what is shorter as a whole would print nothing.
    private const double ShortestLine = 0.01;

    // Times the flow of the segments that one replaces.
    private const double LargestFlow = 1.5;

    /// <summary>Length in mm of an extrusion of the full area with the same volume.</summary>
    public double Length
    {
        get
        {
            var sum = 0.0;
            for (var i = Closed ? 0 : 1; i < Points.Length; i++)
            {
                // Segment i − 1 ends at point i; the one that closes a loop is the last.
                var segment = i == 0 ? Points.Length - 1 : i - 1;
                sum += Points[i].DistanceTo(Points[i == 0 ? Points.Length - 1 : i - 1]) * (Flow is null ? 1 : Flow[segment]);
            }
            return sum;
        }
    }

    /// <summary>With another <see cref="Length"/>, mm: the flow ratios of all segments change by the same share. One without them stays.</summary>
    public InfillLine Holding(double length)
    {
        var share = length / Length;
        return Flow is null ? this : this with { Flow = Array.ConvertAll(Flow, flow => flow * share) };
    }

    /// <summary>True if it is shorter than a length, mm, without what closes a loop.</summary>
    public bool IsShorterThan(double limit)
    {
        var length = 0.0;
        for (var i = 1; i < Points.Length && length < limit; i++) length += Points[i].DistanceTo(Points[i - 1]);
        return length < limit;
    }

    /// <summary>With few segments shorter than a length, mm (<see cref="ShortSegments"/>). Null where the line itself is next to nothing.</summary>
    public InfillLine? WithoutShort(double least, double tolerance, double area)
    {
        if (IsShorterThan(ShortestLine)) return null;
        if (ShortSegments.Keep(Points, Closed, least, tolerance, area) is not { } kept) return this;
        return new InfillLine(Array.ConvertAll(kept, i => Points[i]), Closed, Flow is null ? null : FlowBetween(kept));
    }

    // One segment has the volume of those that it replaces, unless they go to and fro.
    private double[] FlowBetween(int[] kept)
    {
        var flow = new double[Closed ? kept.Length : kept.Length - 1];
        for (var k = 0; k < flow.Length; k++)
        {
            double volume = 0, most = 0;
            for (var i = kept[k]; i < (k + 1 < kept.Length ? kept[k + 1] : Points.Length); i++)
            {
                volume += Flow![i] * Points[i].DistanceTo(Points[i + 1 < Points.Length ? i + 1 : 0]);
                most = Math.Max(most, Flow[i]);
            }
            flow[k] = Math.Min(volume / Points[kept[k]].DistanceTo(Points[kept[k + 1 < kept.Length ? k + 1 : 0]]), LargestFlow * most);
        }
        return flow;
    }
}
