namespace Caterpillar.Toolpaths;

/// <summary>A collision query for a box whose origin moves straight from one point to another.</summary>
internal readonly record struct BoxQuery(Vec3 From, Vec3 To, double Tolerance, Bounds Box)
{
    /// <summary>Minimum height of its bottom with the tolerance, mm. Nothing below it collides.</summary>
    public double Lowest { get; } = Math.Min(From.Z, To.Z) + Tolerance + Box.Min.Z;

    /// <summary>The same while it passes a square, seen from above. Infinite if it does not.</summary>
    public double LowestOver(Vec3 center, double half)
    {
        double low = 0, high = 1;
        return FlatSegment.Slab(From.X, To.X - From.X, center.X - Box.Max.X - half, center.X - Box.Min.X + half, ref low, ref high)
            && FlatSegment.Slab(From.Y, To.Y - From.Y, center.Y - Box.Max.Y - half, center.Y - Box.Min.Y + half, ref low, ref high)
            ? Math.Min(From.Z + (To.Z - From.Z) * low, From.Z + (To.Z - From.Z) * high) + Tolerance + Box.Min.Z
            : double.PositiveInfinity;
    }
}
