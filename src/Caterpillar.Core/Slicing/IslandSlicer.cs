using System.Collections.Generic;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>Walls and infill of one island of a layer.</summary>
internal sealed class IslandSlicer(SliceRules rules, Layer layer, RegionEngine engine)
{
    private const double ArcTolerance = 0.005;

    /// <summary>Adds the paths of an island. Ranks: inner walls from the inside out, the outer wall, the infill.</summary>
    public void Slice(Region island, int layerNumber, int islandNumber, List<PathStep> steps)
    {
        var walls = new WallBuilder(rules.WallRules, engine).Build(island);
        foreach (var wall in walls.Paths)
        {
            var path = PrintPath.Own(Lifted(wall.Points), wall.Beads(rules.WallRules), wall.Closed)
                .With(wall.Index == 0 ? Role.OuterWall : Role.InnerWall, layer);
            steps.Add(new PathStep(path, new StepGroup(layerNumber, islandNumber, rules.Walls - wall.Index)) { Region = island });
        }
        if (rules.InfillSpacing > 0 && !walls.Inside.IsEmpty) Fill(island, walls.Inside, layerNumber, islandNumber, steps);
    }

    // The infill reaches the inner edge of the last wall and the overlap into it. Lines turn by a quarter from layer to layer.
    private void Fill(Region island, Region inside, int layerNumber, int islandNumber, List<PathStep> steps)
    {
        var area = rules.Walls == 0 ? inside : inside.Offset(rules.InfillOverlap, JoinStyle.Miter, 2, ArcTolerance, engine);
        var angle = rules.InfillAngle + (layer.Index % 2 == 0 ? 0 : 90);
        foreach (var line in area.HatchLines(angle, rules.InfillSpacing))
        {
            // Shorter than wide, a strand is a blob.
            if (line.From.DistanceTo(line.To) < rules.Width) continue;
            steps.Add(new PathStep(
                PrintPath.Own([line.From.WithZ(layer.Z), line.To.WithZ(layer.Z)], [rules.Bead], closed: false).With(Role.Infill, layer),
                new StepGroup(layerNumber, islandNumber, rules.Walls + 1)) { Region = island });
        }
    }

    private Vec3[] Lifted(Vec3[] contour)
    {
        var points = new Vec3[contour.Length];
        for (var i = 0; i < points.Length; i++) points[i] = contour[i].WithZ(layer.Z);
        return points;
    }
}
