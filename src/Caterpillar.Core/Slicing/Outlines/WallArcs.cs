namespace Caterpillar.Slicing;

/// <summary>Fits arcs to the walls of a layer.</summary>
internal static class WallArcs
{
    /// <summary>Replaces runs of straight wall segments within a tolerance (mm) of an arc. 0 = off.</summary>
    public static SlicedLayer Fit(SlicedLayer layer, double tolerance)
    {
        if (!(tolerance > 0)) return layer;
        var steps = new List<PathStep>(layer.Steps.Count);
        foreach (var step in layer.Steps)
        {
            var isWall = step.Path.Role is Role.OuterWall or Role.InnerWall or Role.OverhangWall or Role.GapFill;
            steps.Add(isWall ? step.With(PathArcs.Fit(step.Path, tolerance)) : step);
        }
        return layer with { Steps = steps };
    }
}
