namespace Caterpillar.Slicing;

/// <summary>One layer of one model: its area and the paths that print it.</summary>
/// <param name="Layer">Index, height, thickness and model of the layer.</param>
/// <param name="Region">Area of the layer, mm.</param>
/// <param name="Steps">Paths by island: walls by contour, then infill. They are grouped so that planning may sort them.</param>
public sealed record SlicedLayer(Layer Layer, Region Region, IReadOnlyList<PathStep> Steps)
{
    /// <summary>Area of the supports.</summary>
    public Region Support { get; init; } = Region.Empty;
}
