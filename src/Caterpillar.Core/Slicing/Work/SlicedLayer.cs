using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>One layer of one object: what it covers and the paths that print it.</summary>
/// <param name="Layer">Its place: number, height, thickness and object.</param>
/// <param name="Region">What it covers, mm.</param>
/// <param name="Steps">Its paths: by island, walls by contour, then infill; grouped, so that planning may sort them.</param>
public sealed record SlicedLayer(Layer Layer, Region Region, IReadOnlyList<PathStep> Steps)
{
    /// <summary>What its supports cover.</summary>
    public Region Support { get; init; } = Region.Empty;
}
