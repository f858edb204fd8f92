namespace Caterpillar.Slicing;

/// <summary>
/// Divides the inside of islands into top and bottom surfaces, solid and sparse infill. Areas that the layers above or below do not all cover are near a
/// surface. Neighbors that surround the inside with their boundaries apart, as steep walls do, cost no region operation.
/// </summary>
internal sealed class TopBottomFinder(LayerWork layer, SliceRules rules, RegionEngine engine)
{
    private readonly int _above = Reach(layer, rules);
    private readonly int _below = Count(layer, -1, rules.Settings.BottomLayers, rules.Settings.BottomThickness);

    /// <summary>Number of upper neighbors that the surfaces of a layer depend on.</summary>
    public static int Reach(LayerWork layer, SliceRules rules) => Count(layer, 1, rules.Settings.TopLayers, rules.Settings.TopThickness);

    /// <summary>Areas of a part of a layer by their fill. Found on first use, when the neighbors of the layer have their outlines.</summary>
    public static IslandAreas AreasOf(LayerWork layer, InsideWork inside, RegionEngine engine)
    {
        lock (inside.Gate) return inside.Areas ??= new TopBottomFinder(layer, inside.Rules, engine).Find(inside.Region);
    }

    public IslandAreas Find(Region inside)
    {
        if (inside.IsEmpty) return new IslandAreas();
        var top = Exposed(inside, 1, _above);
        var bottom = Exposed(inside, -1, _below);
        var sparse = Covered(Covered(inside, 1, _above), -1, _below);
        if (sparse.IsEmpty && ReferenceEquals(bottom, inside)) return Bottom(new IslandAreas(), inside);
        if (sparse.IsEmpty && ReferenceEquals(top, inside) && bottom.IsEmpty) return new IslandAreas { Top = inside };
        // All solid areas, without slivers, extended into the infill.
        var solid = ReferenceEquals(sparse, inside) ? Region.Empty
            : sparse.IsEmpty ? inside
            : Grown(inside.Subtract(sparse, engine), inside, rules.Settings.SolidInfillExpansion);
        sparse = ReferenceEquals(solid, inside) ? Region.Empty : solid.IsEmpty ? inside : WithoutSmall(inside.Subtract(solid, engine));
        if (ReferenceEquals(sparse, inside)) return Alone(inside);
        bottom = Grown(bottom, inside, IsOverAir ? rules.Settings.BridgeAnchor : rules.Settings.SolidInfillExpansion);
        top = Grown(top, inside, rules.Settings.SolidInfillExpansion).Subtract(bottom, engine);
        var surfaces = bottom.Union(top, engine);
        sparse = sparse.Subtract(surfaces, engine);
        solid = inside.Subtract(surfaces, engine).Subtract(sparse, engine);
        return Bottom(new IslandAreas { Top = top, Solid = solid, Sparse = sparse }, bottom);
    }

    // Number of neighbors that decide: the number of solid layers, or more if those are too thin.
    private static int Count(LayerWork layer, int direction, int layers, double thickness)
    {
        if (layers == 0) return 0;
        var count = layers;
        var sum = 0.0;
        for (var k = 0; sum < thickness - 1e-9; k++)
        {
            var at = layer.Index + direction * k;
            if (at < 0 || at >= layer.Body.Layers.Length) break;
            sum += layer.Body.Layers[at].Plan.Thickness;
            count = Math.Max(count, k + 1);
        }
        return count;
    }

    private Region Exposed(Region inside, int direction, int count)
    {
        if (count == 0) return Region.Empty;
        var other = layer.RegionAt(direction);
        if (other.IsEmpty) return inside;
        return other.Surrounds(inside) ? Region.Empty : inside.Subtract(other.Near(inside.Box), engine);
    }

    private Region Covered(Region area, int direction, int count)
    {
        for (var k = 1; k <= count && !area.IsEmpty; k++)
        {
            if (k > 1 && layer.AreAlike(direction * k, direction * (k - 1))) continue;
            var other = layer.RegionAt(direction * k);
            if (!other.Surrounds(area)) area = area.Intersect(other.Near(area.Box), engine);
        }
        return area;
    }

    // Without places narrower than the minimum solid width, and grown by a distance within the inside.
    private Region Grown(Region area, Region inside, double distance)
    {
        if (area.IsEmpty || ReferenceEquals(area, inside)) return area;
        var half = rules.Settings.MinSolidWidth / 2;
        var core = area.Offset(-half, JoinStyle.Miter, 2, 0.005, engine);
        if (core.IsEmpty) return core;
        return core.Offset(half + distance, JoinStyle.Miter, 2, 0.005, engine).Intersect(inside, engine);
    }

    // No surface: all sparse infill, except small pieces.
    private IslandAreas Alone(Region inside)
    {
        var sparse = WithoutSmall(inside);
        return new IslandAreas { Sparse = sparse, Solid = ReferenceEquals(sparse, inside) ? Region.Empty : inside.Subtract(sparse, engine) };
    }

    private Region WithoutSmall(Region sparse)
    {
        var limit = rules.InfillSpacing > 0 ? rules.Settings.SolidInfillThresholdArea : 0;
        if (limit == 0) return sparse;
        var kept = sparse.Islands.Where(i => i.Area >= limit).SelectMany(i => i.Paths).ToArray();
        return kept.Length == sparse.Paths.Length ? sparse : Region.Own(kept);
    }

    private bool IsOverAir => rules.Settings.Bridges && !layer.RegionAt(-1).IsEmpty;

    private IslandAreas Bottom(IslandAreas areas, Region bottom)
    {
        if (bottom.IsEmpty || !IsOverAir) return areas with { Bottom = bottom };
        var below = layer.RegionAt(-1);
        var bridges = new List<BridgeArea>();
        var others = new List<GridPoint[]>();
        foreach (var piece in bottom.Islands)
        {
            if (BridgeFinder.Find(piece, below.Near(piece.Box), rules.SolidWidth) is { } angle) bridges.Add(new BridgeArea(piece, angle));
            else others.AddRange(piece.Paths);
        }
        return areas with { Bottom = Region.Own(others.ToArray()), Bridges = bridges };
    }
}
