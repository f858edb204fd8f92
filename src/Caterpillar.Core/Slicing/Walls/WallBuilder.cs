using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>Lays walls along the contours of regions. One thread at a time.</summary>
internal sealed class WallBuilder(WallRules rules, RegionEngine engine)
{
    private const double ArcTolerance = 0.005;

    /// <summary>The walls along all contours of a region, and what they leave for infill.</summary>
    public WallResult Build(Region island)
    {
        var paths = new List<WallPath>();
        var thin = new List<ThinPlace>();
        return new WallResult(paths, Classic(island, paths), thin);
    }

    /// <summary>
    /// Beads along the contours of an area, round after round, until it is full. The beads cover it by their spacings: its border may be the inner edge of
    /// walls.
    /// </summary>
    public WallResult Fill(Region area)
    {
        var paths = new List<WallPath>();
        var line = area.Offset(-rules.InnerSpacing / 2, JoinStyle.Miter, 2, ArcTolerance, engine);
        for (var round = 0; !line.IsEmpty; round++)
        {
            Add(line, round, rules.InnerWidth, paths);
            line = line.Offset(-rules.InnerSpacing, JoinStyle.Miter, 2, ArcTolerance, engine);
        }
        return new WallResult(paths, Region.Empty, []);
    }

    // Walls of one width. The first keeps half a width from the outline, each next one a spacing from the last.
    private Region Classic(Region island, List<WallPath> paths)
    {
        if (rules.Count == 0) return island;
        var line = island;
        for (var wall = 0; wall < rules.Count; wall++)
        {
            var step = wall switch
            {
                0 => rules.OuterWidth / 2,
                1 => (rules.OuterSpacing + rules.InnerSpacing) / 2,
                _ => rules.InnerSpacing,
            };
            line = line.Offset(-step, JoinStyle.Miter, 2, ArcTolerance, engine);
            if (line.IsEmpty) return line;
            Add(line, wall, wall == 0 ? rules.OuterWidth : rules.InnerWidth, paths);
        }
        return line.Offset(-(rules.Count == 1 ? rules.OuterSpacing : rules.InnerSpacing) / 2, JoinStyle.Miter, 2, ArcTolerance, engine);
    }

    private void Add(Region line, int wall, double width, List<WallPath> paths)
    {
        // Offsetting leaves corners of rounding size, which a printer need not see.
        foreach (var contour in line.Simplified(rules.Tolerance, engine).Contours)
        {
            var widths = new double[contour.Count];
            for (var i = 0; i < widths.Length; i++) widths[i] = width;
            paths.Add(new WallPath(contour.Raw, widths, Closed: true, wall, IsStrand: false));
        }
    }
}
