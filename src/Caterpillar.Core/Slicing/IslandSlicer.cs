using System.Collections.Generic;
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
        var innermost = island;
        for (var wall = 0; wall < rules.Walls; wall++)
        {
            // The first wall keeps half a width from the outline, each next one a pitch from the last.
            var line = wall == 0
                ? island.Offset(-rules.Width / 2, JoinStyle.Miter, 2, ArcTolerance, engine)
                : innermost.Offset(-rules.Pitch, JoinStyle.Miter, 2, ArcTolerance, engine);
            if (line.IsEmpty)
            {
                innermost = Region.Empty;
                break;
            }
            innermost = line;
            var rank = rules.Walls - wall;
            // Offsetting leaves corners of rounding size, which a printer need not see.
            foreach (var contour in line.Simplified(rules.Simplify, engine).Contours)
            {
                if (contour.Count < 3) continue;
                steps.Add(new PathStep(
                    PrintPath.Own(Lifted(contour.Raw), [rules.Bead], closed: true).With(wall == 0 ? Role.OuterWall : Role.InnerWall, layer),
                    new StepGroup(layerNumber, islandNumber, rank)) { Region = island });
            }
        }
        if (rules.InfillSpacing > 0 && !innermost.IsEmpty) Fill(island, innermost, layerNumber, islandNumber, steps);
    }

    // The infill reaches the inner edge of the last wall and the overlap into it. Lines turn by a quarter from layer to layer.
    private void Fill(Region island, Region innermost, int layerNumber, int islandNumber, List<PathStep> steps)
    {
        var inset = rules.Walls == 0 ? 0 : rules.Pitch / 2 - rules.InfillOverlap;
        var area = inset == 0 ? innermost : innermost.Offset(-inset, JoinStyle.Miter, 2, ArcTolerance, engine);
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
