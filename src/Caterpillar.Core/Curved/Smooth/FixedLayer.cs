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

    /// <summary>The layer with all places that go together: where two contradict each other, the lower one stays.</summary>
    public static FixedLayer Of(int number, IEnumerable<(int Node, double Height)> places, SlopeGrid grid, double slope)
    {
        double[] upper = new double[grid.Count], lower = new double[grid.Count];
        for (var i = 0; i < upper.Length; i++) (upper[i], lower[i]) = (double.PositiveInfinity, double.PositiveInfinity);
        var all = places.ToArray();
        foreach (var (node, height) in all) upper[node] = Math.Min(upper[node], height);
        grid.Lower(upper, slope);
        var kept = Array.FindAll(all, p => p.Height <= upper[p.Node] + 1e-9);
        foreach (var (node, height) in kept) lower[node] = Math.Min(lower[node], -height);
        grid.Lower(lower, slope);
        for (var i = 0; i < lower.Length; i++) lower[i] = -lower[i];
        return new FixedLayer(number, kept, upper, lower);
    }
}
