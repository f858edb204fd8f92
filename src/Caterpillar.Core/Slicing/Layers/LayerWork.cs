using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>A layer of a body as it passes through the stages. Each stage writes its own part; a layer's neighbors are only read.</summary>
internal sealed class LayerWork(Body body, int index, PlannedLayer plan, SliceRules rules)
{
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

    /// <summary>What the plane cuts out of the mesh; let go once the region is there.</summary>
    public Section? Section { get; set; }

    /// <summary>What the layer covers.</summary>
    public Region Region { get; set; } = Region.Empty;

    public IslandWork[] Islands { get; set; } = [];

    /// <summary>What no wall fits into.</summary>
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
}

/// <summary>A connected piece of a layer.</summary>
internal sealed class IslandWork(Region region)
{
    public Region Region { get; } = region;

    public IReadOnlyList<WallPath> Walls { get; set; } = [];

    /// <summary>What the walls leave.</summary>
    public Region Inside { get; set; } = Region.Empty;
}
