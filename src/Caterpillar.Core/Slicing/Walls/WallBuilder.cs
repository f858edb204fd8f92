namespace Caterpillar.Slicing;

/// <summary>Lays walls along the contours of regions. One thread at a time.</summary>
/// <param name="rules">What they are to be like.</param>
/// <param name="engine">Clips.</param>
/// <param name="offset">Offsets strips; kept by whoever builds walls again and again.</param>
internal sealed class WallBuilder(WallRules rules, RegionEngine engine, VaryingOffset? offset = null)
{
    private const double ArcTolerance = 0.005;

    // mm², as much as a dot of one line's width; the tip of a sharp corner is no thin place.
    private const double SmallestReported = 0.15;

    private readonly VaryingOffset _offset = offset ?? new(engine);

    /// <summary>The walls along all contours of a region, and the area left for infill.</summary>
    public WallResult Build(Region island)
    {
        var output = new WallOutput(rules);
        if (rules.Count == 0) return output.Result(island);
        if (!rules.VariableWidth) Report(island, rules.OuterWidth / 2, output);
        else if (!IsThick(island, rules.Edge + rules.OuterSpacing + (rules.Count - 0.25) * rules.InnerSpacing)) return output.Result(Varying(island, output));
        return output.Result(Classic(island, output));
    }

    /// <summary>One wall of one width around an island of supports; single extrusions where it is thin, and gaps that are not filled.</summary>
    /// <param name="island">The island.</param>
    /// <param name="filled">True if the area for infill is needed. Otherwise it is empty.</param>
    public WallResult Outline(Region island, bool filled)
    {
        const double Coarse = 0.02;
        var output = new WallOutput(rules);
        // Two sides of a wall that lie in each other by a tenth do no harm here.
        var depth = rules.Edge + 0.9 * rules.OuterSpacing;
        var coarse = island.Simplified(Coarse, engine);
        var core = coarse.Offset(-depth, JoinStyle.Miter, 4, ArcTolerance, engine);
        // A waist as small as a dot has no extrusion.
        var thin = ThinParts.Of(coarse, core, depth, rules.OuterWidth * rules.OuterWidth, engine, out _);
        var line = core.Offset(depth - rules.OuterWidth / 2, JoinStyle.Miter, 2, ArcTolerance, engine);
        output.Loops(line, 0, rules.OuterWidth, engine);
        if (!thin.IsEmpty)
        {
            var extrusions = new WallLevel(rules, rules.OuterWidth, rules.InnerWidth, engine, _offset);
            // The coarse outline also runs outside of the island, and the island reaches out by as much as supports follow the part.
            thin = thin.Intersect(island, engine).Offset(-Math.Max(rules.Edge, rules.Tolerance), JoinStyle.Miter, 4, ArcTolerance, engine);
            foreach (var piece in thin.Islands) extrusions.Trace(piece, 0, output);
        }
        return output.Result(filled ? line.Offset(-rules.OuterSpacing / 2, JoinStyle.Miter, 2, ArcTolerance, engine) : Region.Empty);
    }

    /// <summary>
    /// Beads along the contours of an area, round after round, until it is full. The beads cover it by their spacings: its border may be the inner edge of
    /// walls.
    /// </summary>
    /// <param name="area">The area.</param>
    /// <param name="first">Index of the first round.</param>
    /// <param name="rounds">Largest number of rounds.</param>
    public WallResult Fill(Region area, int first = 0, int rounds = int.MaxValue - 1)
    {
        var output = new WallOutput(rules);
        var level = new WallLevel(rules with { Corners = JoinStyle.Miter }, rules.InnerWidth, rules.InnerWidth, engine, _offset);
        for (var round = 0; round < rounds && !area.IsEmpty; round++)
        {
            area = rules.VariableWidth ? level.Walls(area, first + round, output) : level.Even(area, first + round, output);
        }
        return output.Result(area.IsEmpty || !rules.VariableWidth ? area : level.Extrusions(area, first + rounds, output));
    }

    // Where no place is so thin that its thickness matters, the walls are plain offsets. There is so much to spare that a coarse outline tells it.
    private bool IsThick(Region island, double depth)
    {
        const double Coarse = 0.02;
        var coarse = island.Simplified(Coarse, engine);
        return ThinParts.Of(coarse, depth, 0.25 * rules.InnerSpacing * rules.InnerSpacing, engine, out _).IsEmpty;
    }

    private Region Varying(Region island, WallOutput output)
    {
        // Half the narrowest bead is the thinnest that gets one, which is then wider than its place.
        Report(island, rules.Edge + rules.Spacing(rules.MinWidth) / 4, output);
        var area = island.Offset(-rules.Edge, JoinStyle.Miter, 4, ArcTolerance, engine);
        for (var wall = 0; wall < rules.Count && !area.IsEmpty; wall++)
        {
            var width = wall == 0 ? rules.OuterWidth : rules.InnerWidth;
            area = new WallLevel(rules, width, rules.InnerWidth, engine, _offset).Walls(area, wall, output);
        }
        // A gap between the innermost walls that is too narrow for infill.
        return area.IsEmpty ? area : new WallLevel(rules, rules.InnerWidth, rules.InnerWidth, engine, _offset).Extrusions(area, rules.Count, output);
    }

    private void Report(Region island, double radius, WallOutput output)
    {
        foreach (var place in ThinParts.Of(island, radius, SmallestReported, engine, out _).Islands)
        {
            if (place.Area >= SmallestReported) output.TooThin.Add(new ThinPlace(place.Bounds.Center, place.Area));
        }
    }

    // Walls of one width. The first keeps half a width from the outline, each next one a spacing from the last.
    private Region Classic(Region island, WallOutput output)
    {
        var line = island;
        for (var wall = 0; wall < rules.Count; wall++)
        {
            var step = wall switch
            {
                0 => rules.OuterWidth / 2,
                1 => (rules.OuterSpacing + rules.InnerSpacing) / 2,
                _ => rules.InnerSpacing,
            };
            line = line.Offset(-step, wall == 0 ? JoinStyle.Miter : rules.Corners, 2, WallRules.Rounding * step, engine);
            if (line.IsEmpty) return line;
            output.Loops(line, wall, wall == 0 ? rules.OuterWidth : rules.InnerWidth, engine);
        }
        var last = (rules.Count == 1 ? rules.OuterSpacing : rules.InnerSpacing) / 2;
        return line.Offset(-last, rules.Corners, 2, WallRules.Rounding * last, engine);
    }
}
