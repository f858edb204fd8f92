namespace Caterpillar.Slicing;

/// <summary>The walls of the islands of a layer. Their number may differ between layers, below top surfaces and over air.</summary>
internal sealed class IslandWalls
{
    private const double ArcTolerance = 0.005;

    // Top surfaces narrower than this keep all walls, in widths: steps of slopes are no surfaces.
    private const double LeastTop = 3;

    private readonly LayerWork _layer;
    private readonly SliceRules _rules;
    private readonly WallRules _walls;
    private readonly WallBuilder _builder;
    private readonly RegionEngine _engine;

    public IslandWalls(LayerWork layer, SliceRules rules, RegionEngine engine)
    {
        (_layer, _rules, _engine) = (layer, rules, engine);
        var settings = rules.Settings;
        var count = rules.Walls.Count;
        if (settings.OnlyOneWallFirstLayer && layer.Index == 0) count = Math.Min(count, 1);
        else if (settings.AlternateExtraWall && layer.Index % 2 == 1 && count > 0) count++;
        _walls = count == rules.Walls.Count ? rules.Walls : rules.Walls with { Count = count };
        _builder = new WallBuilder(_walls, engine);
    }

    /// <summary>The walls of an island, and what they leave.</summary>
    public WallResult Build(Region island)
    {
        if (!_rules.Settings.OnlyOneWallTop || _walls.Count < 2) return _builder.Build(island);
        var above = Neighbor(1);
        if (above.Surrounds(island)) return _builder.Build(island);
        var outer = new WallBuilder(_walls with { Count = 1 }, _engine).Build(island);
        var top = ThinParts.Thick(outer.Inside.Subtract(above.Near(outer.Inside.Box), _engine), LeastTop / 2 * _rules.Width, _engine);
        if (top.IsEmpty) return _builder.Build(island);
        var covered = outer.Inside.Subtract(top, _engine).WithoutSmallContours(_rules.Width * _rules.Width / 4);
        var inner = _builder.Fill(covered, first: 1, _walls.Count - 1);
        return new WallResult([.. outer.Paths, .. inner.Paths], inner.Inside.Union(top, _engine), outer.TooThin);
    }

    /// <summary>
    /// Further walls over air, from the innermost outwards, and what they leave. Only those parts of them are printed that lie over air or anchor such a part.
    /// The first lies on the layer below, and each leans on the one before it.
    /// </summary>
    public (IReadOnlyList<WallPath> Walls, Region Inside) OverAir(Region inside)
    {
        if (!_rules.Settings.ExtraWallsOnOverhangs || _walls.Count == 0 || _layer.Index == 0) return ([], inside);
        var below = Neighbor(-1);
        if (below.IsEmpty || inside.IsEmpty || below.Surrounds(inside)) return ([], inside);
        below = below.Near(inside.Box);
        var spacing = _walls.InnerSpacing;
        var anchor = Math.Max(_rules.Settings.BridgeAnchor, spacing);
        List<GridPoint[]> air = [], strips = [];
        foreach (var piece in ThinParts.Thick(inside.Subtract(below, _engine), spacing / 4, _engine).Islands)
        {
            var strip = piece.Offset(anchor, JoinStyle.Miter, 2, ArcTolerance, _engine).Intersect(inside, _engine);
            // Nothing carries it, or it is a bridge.
            if (strip.Intersect(below, _engine).IsEmpty) continue;
            if (_rules.Settings.Bridges && BridgeFinder.Find(strip, below, _rules.SolidWidth) is not null) continue;
            air.AddRange(piece.Paths);
            strips.AddRange(strip.Paths);
        }
        if (air.Count == 0) return ([], inside);
        var (open, near, rest) = (Region.Own(air.ToArray()), Region.Union([Region.Own(strips.ToArray())], _engine), inside);
        var walls = new List<WallPath>();
        for (var index = _walls.Count; !rest.Intersect(open, _engine).IsEmpty; index++)
        {
            var round = _builder.Fill(rest, index, rounds: 1);
            foreach (var wall in round.Paths)
            {
                foreach (var piece in near.ClipLines([new Polyline(wall.Points, wall.Closed)]))
                {
                    if (piece.Length >= 2 * _walls.InnerWidth) walls.Add(wall.Along(piece) with { Index = index });
                }
            }
            rest = round.Inside;
        }
        walls.Reverse();
        return (walls, inside.Subtract(near.Subtract(rest, _engine), _engine));
    }

    // What the layer above (1) or below (-1) covers; the first stage of it may come later.
    private Region Neighbor(int offset)
    {
        var at = _layer.Index + offset;
        if (at >= 0 && at < _layer.Body.Layers.Length) LayerRegion.Find(_layer.Body.Layers[at], _engine);
        return _layer.RegionAt(offset);
    }
}
