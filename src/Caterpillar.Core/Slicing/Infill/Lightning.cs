namespace Caterpillar.Slicing;

/// <summary>
/// Trees that support top surfaces from below (after Tricard, Claux and Lefebvre, "Ribbed support vaults for 3D printing of hollowed objects", 2020). They
/// grow under the top surfaces and are followed downwards. In each layer, tips get shorter and bends straighter by the allowed overhang, so that the trees
/// withdraw into the walls.
/// </summary>
internal static class Lightning
{
    /// <summary>The lines of each layer; they go to <see cref="InfillRequest.Curves"/>.</summary>
    /// <param name="areas">Where infill may run, from the lowest layer up (<see cref="InfillRequest.Area"/>).</param>
    /// <param name="tops">Per layer, the area under a top surface, which needs support from below: a part of the area of the layer.</param>
    /// <param name="spacing">Maximum distance between lines under a top surface, mm.</param>
    /// <param name="heights">Height Z of each layer, mm, ascending: branches lean by at most 45°.</param>
    /// <param name="cancel">Cancels the call.</param>
    public static IReadOnlyList<Polyline>[] Grow(
        IReadOnlyList<Region> areas, IReadOnlyList<Region> tops, double spacing, IReadOnlyList<double> heights, CancellationToken cancel = default)
    {
        var layers = new IReadOnlyList<Polyline>[areas.Count];
        var forest = new LightningForest(spacing / 2);
        for (var i = areas.Count - 1; i >= 0; i--)
        {
            cancel.ThrowIfCancellationRequested();
            var lean = i + 1 < areas.Count ? Math.Max(heights[i + 1] - heights[i], 0) : 0;
            forest.Descend(areas[i], lean);
            forest.Support(tops[i], cancel);
            layers[i] = forest.Lines();
        }
        return layers;
    }
}
