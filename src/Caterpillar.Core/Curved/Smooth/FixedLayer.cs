namespace Caterpillar.Curved;

/// <summary>A layer that must have given heights at some nodes, and what follows for it at all others.</summary>
internal sealed class FixedLayer
{
    private FixedLayer(int number, IReadOnlyList<(int Node, double Height)> places, double[] upper, double[] lower)
        => (Number, Places, Upper, Lower) = (number, places, upper, lower);

    public int Number { get; }

    public IReadOnlyList<(int Node, double Height)> Places { get; }

    /// <summary>The greatest height at each node, mm.</summary>
    public double[] Upper { get; }

    /// <summary>The least height at each node, mm.</summary>
    public double[] Lower { get; }

    /// <summary>
    /// The layer with all places that go together. Where some are too far above others, the upper ones stay, or the lower ones if those are more.
    /// </summary>
    public static FixedLayer Of(int number, IEnumerable<(int Node, double Height)> places, SlopeGrid grid, double slope)
    {
        var all = places.ToArray();
        double[] upper = Reach(all, 1, grid, slope), lower = Reach(all, -1, grid, slope);
        var notAbove = Array.FindAll(all, p => p.Height <= upper[p.Node] + 1e-9);
        var notBelow = Array.FindAll(all, p => -p.Height <= lower[p.Node] + 1e-9);
        var kept = notBelow.Length > notAbove.Length ? notBelow : notAbove;
        if (kept.Length < all.Length) (upper, lower) = (Reach(kept, 1, grid, slope), Reach(kept, -1, grid, slope));
        return new FixedLayer(number, kept, upper, Array.ConvertAll(lower, h => -h));
    }

    // The greatest heights that given ones allow, or the least ones with a sign of -1, negative.
    private static double[] Reach((int Node, double Height)[] places, int sign, SlopeGrid grid, double slope)
    {
        var heights = new double[grid.Count];
        for (var i = 0; i < heights.Length; i++) heights[i] = double.PositiveInfinity;
        foreach (var (node, height) in places) heights[node] = Math.Min(heights[node], sign * height);
        grid.Lower(heights, slope);
        return heights;
    }
}
