namespace Caterpillar.Geometry;

/// <summary>A hole of a surface that was filled.</summary>
/// <param name="Box">Bounding box of its edge, mm.</param>
/// <param name="Area">Area of the triangles that fill it, mm².</param>
internal readonly record struct FilledHole(Bounds Box, double Area)
{
    /// <summary>Diagonal of its box, mm.</summary>
    public double Width => Box.Size.Length;
}
