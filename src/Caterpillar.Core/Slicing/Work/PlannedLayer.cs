namespace Caterpillar.Slicing;

/// <summary>A planar layer before it is cut.</summary>
/// <param name="Top">Height of its top above the bed, mm.</param>
/// <param name="Thickness">mm.</param>
/// <param name="Cut">Height at which the mesh is cut, mm.</param>
internal readonly record struct PlannedLayer(double Top, double Thickness, double Cut)
{
    /// <summary>A layer that is cut at its middle or right above its bottom.</summary>
    public static PlannedLayer Of(double top, double thickness, SlicingPlane plane)
        => new(top, thickness, plane == SlicingPlane.Middle ? top - thickness / 2 : top - thickness + Math.Min(0.01, thickness / 10));
}
