namespace Caterpillar.Slicing;

/// <summary>What a layer covers: what its plane cuts out of the mesh, without details that nobody sees, and with the compensations of the settings.</summary>
internal static class LayerRegion
{
    /// <summary>Finds the region of a layer, if it is not known yet. The layers next to it may ask for it, too.</summary>
    public static void Find(LayerWork layer, RegionEngine engine)
    {
        lock (layer.Gate)
        {
            if (layer.Section is not { } section) return;
            layer.Section = null;
            var settings = layer.Rules.Settings;
            if (settings.OpenContours != OpenContours.Ignore) layer.OpenLines = section.OpenLines;
            if (settings.OpenContours == OpenContours.Surface)
            {
                layer.OpenLines = [.. section.OpenLines, .. section.Loops];
                section = section with { Loops = [] };
            }
            var region = Region.From(section.Loops, FillRule.NonZero, false, engine);
            // What simplifying cuts off stays open where there is nothing but walls.
            var tolerance = IsAllWalls(region, layer.Rules.Walls) ? settings.Resolution / 2 : settings.Resolution;
            var turned = settings.HoleToPolyholeTwisted && layer.Index % 2 == 1;
            if (settings.HoleToPolyhole) region = Polyholes.In(region, settings.HoleToPolyholeThreshold, turned, engine);
            layer.Region = Compensated(region.Simplified(tolerance, engine), layer, engine);
        }
    }

    // On average the walls of both sides fill the layer.
    private static bool IsAllWalls(Region region, WallRules walls)
        => walls.Count > 0 && region.Area < region.Perimeter * (walls.Edge + walls.OuterSpacing + (walls.Count - 1) * walls.InnerSpacing);

    // Outlines and holes moved by the compensations of the settings.
    private static Region Compensated(Region region, LayerWork layer, RegionEngine engine)
    {
        var settings = layer.Rules.Settings;
        var outline = settings.XySizeCompensation - (layer.Index == 0 ? settings.ElephantFootCompensation : 0);
        var inHoles = outline - settings.XyHoleCompensation;
        if (outline == 0 && inHoles == 0) return region;
        if (outline == inHoles) return region.Offset(outline, JoinStyle.Miter, 2, 0.005, engine);
        // Holes are regions of their own, turned over; an island within a hole is an outline again.
        var result = Region.Empty;
        foreach (var island in region.Islands)
        {
            var outer = Region.Own([island.Paths[0]]).Offset(outline, JoinStyle.Miter, 2, 0.005, engine);
            var holes = new List<GridPoint[]>();
            for (var i = 1; i < island.Paths.Length; i++)
            {
                var hole = (GridPoint[])island.Paths[i].Clone();
                System.Array.Reverse(hole);
                holes.Add(hole);
            }
            if (holes.Count > 0) outer = outer.Subtract(Region.Own(holes.ToArray()).Offset(-inHoles, JoinStyle.Miter, 2, 0.005, engine), engine);
            result = result.Union(outer, engine);
        }
        return result;
    }
}
