using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The walls of an island as steps: from the inside out, strands of thin places with the walls that they continue.</summary>
internal static class WallSteps
{
    public static void Add(LayerWork layer, IslandWork island, int number, List<PathStep> steps)
    {
        var rules = layer.Rules.Walls;
        foreach (var wall in island.Walls)
        {
            var role = wall.IsStrand && wall.Index > 0 ? Role.GapFill : wall.Index == 0 ? Role.OuterWall : Role.InnerWall;
            var path = PrintPath.Own(Lifted(wall.Points, layer.Plan.Top), wall.Beads(rules), wall.Closed).With(role, layer.Layer);
            var rank = StepRank.Walls + System.Math.Max(0, rules.Count - wall.Index);
            steps.Add(new PathStep(path, new StepGroup(layer.Number, number, rank)) { Region = island.Region });
        }
    }

    private static Vec3[] Lifted(Vec3[] contour, double z)
    {
        var points = new Vec3[contour.Length];
        for (var i = 0; i < points.Length; i++) points[i] = contour[i].WithZ(z);
        return points;
    }
}
