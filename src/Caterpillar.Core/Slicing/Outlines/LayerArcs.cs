namespace Caterpillar.Slicing;

/// <summary>Fits arcs to the paths of a layer.</summary>
internal static class LayerArcs
{
    /// <summary>Replaces runs of straight segments within a tolerance (mm) of an arc. 0 = off.</summary>
    /// <param name="layer">The layer.</param>
    /// <param name="tolerance">mm.</param>
    /// <param name="ofPart">True for the paths of the part, false for what is printed around it: supports, skirt, brim and raft.</param>
    public static SlicedLayer Fit(SlicedLayer layer, double tolerance, bool ofPart)
    {
        if (tolerance == 0) return layer;
        var steps = new List<PathStep>(layer.Steps.Count);
        foreach (var step in layer.Steps)
        {
            var isAround = step.Path.Role is Role.Support or Role.SupportInterface or Role.Skirt or Role.Brim or Role.Raft;
            steps.Add(isAround == ofPart ? step : step with { Path = PathArcs.Fit(step.Path, tolerance) });
        }
        return layer with { Steps = steps };
    }
}
