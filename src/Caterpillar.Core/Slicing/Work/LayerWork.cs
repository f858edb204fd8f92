namespace Caterpillar.Slicing;

/// <summary>A layer of a body as it passes through the stages. Each stage writes its own part; a layer's neighbors are only read.</summary>
internal sealed class LayerWork(Body body, int index, PlannedLayer plan, SliceRules rules)
{
    private StrongBox<bool>? _isLikeBelow;

    public Body Body { get; } = body;

    /// <summary>Number in the body, from the bed.</summary>
    public int Index { get; } = index;

    /// <summary>Place among the layers of all bodies.</summary>
    public int Order { get; set; }

    /// <summary>Number in the print, with the layers of a raft.</summary>
    public int Number => Order + Rules.Settings.RaftLayers;

    public PlannedLayer Plan { get; } = plan;

    public SliceRules Rules { get; } = rules;

    public Layer Layer { get; } = new(index, plan.Top, plan.Thickness, body.Model.Name);

    /// <summary>Bodies in which other settings apply, as this layer cuts them.</summary>
    public List<(SliceRules Rules, Region Area)> Modifiers { get; } = [];

    /// <summary>Held while the region is found.</summary>
    public object Gate { get; } = new();

    /// <summary>What the plane cuts out of the mesh; let go once the region is there.</summary>
    public Section? Section { get; set; }

    /// <summary>What the layer covers.</summary>
    public Region Region { get; set; } = Region.Empty;

    public IslandWork[] Islands { get; set; } = [];

    /// <summary>The loops of each contour among the steps of the layer, until their seams are chosen.</summary>
    public IReadOnlyList<WallChain> Chains { get; set; } = [];

    /// <summary>Areas too narrow for a wall.</summary>
    public List<ThinPlace> TooThin { get; } = [];

    /// <summary>Contours that do not close and are printed as single walls.</summary>
    public IReadOnlyList<Polyline> OpenLines { get; set; } = [];

    /// <summary>The contour that this layer gives to a vase; null for layers that are printed as usual.</summary>
    public Polyline? VaseLoop { get; set; }

    /// <summary>What a layer of the same body so many layers higher (or, where negative, lower) covers; nothing beyond the ends.</summary>
    public Region RegionAt(int offset)
    {
        var at = Index + offset;
        return at >= 0 && at < Body.Layers.Length ? Body.Layers[at].Region : Region.Empty;
    }

    /// <summary>Whether two neighboring layers, so many layers higher, cover the same. Found once, when they have their regions.</summary>
    public bool AreAlike(int offset, int next)
    {
        var upper = Index + Math.Max(offset, next);
        return upper > 0 && upper < Body.Layers.Length ? Body.Layers[upper].IsLikeBelow : RegionAt(offset).SameAs(RegionAt(next));
    }

    private bool IsLikeBelow => (_isLikeBelow ??= new StrongBox<bool>(Region.SameAs(RegionAt(-1)))).Value;

    /// <summary>What the layer below covers near an island of this one, or null where nothing of the island hangs over it.</summary>
    public Region? BelowHanging(Region island)
    {
        if (Index == 0) return null;
        var below = RegionAt(-1);
        if (below.IsEmpty || IsLikeBelow) return null;
        // Where the lower layer reaches beyond the island all around, all its walls lie on it.
        return below.Surrounds(island) ? null : below.Near(island.Box);
    }
}

/// <summary>A connected piece of a layer.</summary>
/// <param name="region">What it covers.</param>
/// <param name="rules">The settings of its walls.</param>
internal sealed class IslandWork(Region region, SliceRules rules)
{
    public Region Region { get; } = region;

    public SliceRules Rules { get; } = rules;

    public IReadOnlyList<WallPath> Walls { get; set; } = [];

    /// <summary>Walls over air beyond those of the settings, from the innermost outwards.</summary>
    public IReadOnlyList<WallPath> OverAir { get; set; } = [];

    /// <summary>What the walls leave.</summary>
    public IReadOnlyList<InsideWork> Insides { get; set; } = [];
}

/// <summary>A part of what the walls of an island leave, filled by one set of settings.</summary>
internal sealed class InsideWork(SliceRules rules, Region region)
{
    public SliceRules Rules { get; } = rules;

    public Region Region { get; } = region;

    /// <summary>Held while the areas are found: layers above and below may ask for them, too.</summary>
    public object Gate { get; } = new();

    /// <summary>How it is filled, once that was asked for.</summary>
    public IslandAreas? Areas { get; set; }
}
