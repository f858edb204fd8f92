using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The walls of an island as steps: from the inside out, strands of thin places with the walls that they continue.</summary>
internal static class WallSteps
{
    public static void Add(LayerWork layer, IslandWork island, int number, RegionEngine engine, List<PathStep> steps)
    {
        var (rules, settings) = (layer.Rules.Walls, layer.Rules.Settings);
        var overhangs = OverhangSplitter.For(layer, island, engine);
        for (var i = 0; i < island.Walls.Count; i++)
        {
            var wall = island.Walls[i];
            if (settings.FuzzySkin > 0 && wall is { Index: 0, Closed: true } && layer.Index > 0) wall = FuzzySkin.Apply(wall, settings, layer.Number, i);
            var role = wall.Index == 0 ? Role.OuterWall : wall.IsStrand ? Role.GapFill : Role.InnerWall;
            var path = PrintPath.Own(Lifted(wall.Points, layer.Plan.Top), wall.Beads(rules), wall.Closed).With(role, layer.Layer);
            if (overhangs is not null) path = overhangs.Split(path);
            var rank = StepRank.Walls + Math.Max(0, rules.Count - wall.Index);
            steps.Add(new PathStep(path, new StepGroup(layer.Number, number, rank)) { Region = island.Region });
        }
    }

    /// <summary>Contours that do not close, as single walls.</summary>
    public static void AddOpen(LayerWork layer, List<PathStep> steps)
    {
        var bead = layer.Rules.Bead(layer.Rules.Width);
        for (var i = 0; i < layer.OpenLines.Count; i++)
        {
            var line = layer.OpenLines[i];
            if (line.Count < 2 || line.Length < layer.Rules.Width) continue;
            var path = PrintPath.Own(Lifted(line.Raw, layer.Plan.Top), [bead], closed: false).With(Role.OuterWall, layer.Layer);
            steps.Add(new PathStep(path, new StepGroup(layer.Number, layer.Islands.Length, StepRank.Walls)));
        }
    }

    private static Vec3[] Lifted(Vec3[] contour, double z)
    {
        var points = new Vec3[contour.Length];
        for (var i = 0; i < points.Length; i++) points[i] = contour[i].WithZ(z);
        return points;
    }
}
