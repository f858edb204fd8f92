namespace Caterpillar.Slicing;

/// <summary>How the inside of an island is filled. The areas do not overlap and cover the inside together.</summary>
internal sealed record IslandAreas
{
    /// <summary>Seen from below.</summary>
    public Region Bottom { get; init; } = Region.Empty;

    /// <summary>Seen from below, over air that they span.</summary>
    public IReadOnlyList<BridgeArea> Bridges { get; init; } = [];

    /// <summary>Seen from above.</summary>
    public Region Top { get; init; } = Region.Empty;

    /// <summary>Closed because a surface is near.</summary>
    public Region Solid { get; init; } = Region.Empty;

    /// <summary>The rest, for infill.</summary>
    public Region Sparse { get; init; } = Region.Empty;
}

/// <summary>An area that spans air, and the direction of its extrusions in degrees from +X.</summary>
internal readonly record struct BridgeArea(Region Area, double Angle);
