namespace Caterpillar.Toolpaths;

/// <summary>A collision query for a box whose origin moves straight from one point to another.</summary>
internal readonly struct BoxQuery(Vec3 from, Vec3 to, double tolerance, Bounds box)
{
    // Rise of a piece of the path of a box that counts as level, mm.
    private const double Level = 0.02;

    public Vec3 From => from;

    public Vec3 To => to;

    public Bounds Box => box;

    /// <summary>Minimum height of its bottom with the tolerance, mm. Nothing below it collides.</summary>
    public double Lowest { get; } = Math.Min(from.Z, to.Z) + tolerance + box.Min.Z;

    /// <summary>True if it passes a square, seen from above.</summary>
    public bool Passes(Vec3 center, double half) => Passes(center, half, from, to);

    /// <summary>True if it hits a cell with a height, mm.</summary>
    public bool Meets(Vec3 center, double top, double cell) => Meets(center, top - tolerance - box.Min.Z, cell, from, to);

    // The cell is hit by an origin below a height.
    private bool Meets(Vec3 center, double below, double cell, Vec3 a, Vec3 b)
    {
        if (!(below > Math.Min(a.Z, b.Z)) || !Passes(center, cell / 2, a, b)) return false;
        // Straight up and down the lower end decides.
        if (Math.Abs(a.Z - b.Z) <= Level || (b - a).LengthXY <= cell / 8) return true;
        var middle = Vec3.Lerp(a, b, 0.5);
        return Meets(center, below, cell, a, middle) || Meets(center, below, cell, middle, b);
    }

    private bool Passes(Vec3 center, double half, Vec3 a, Vec3 b)
    {
        double low = 0, high = 1;
        return FlatSegment.Slab(a.X, b.X - a.X, center.X - box.Max.X - half, center.X - box.Min.X + half, ref low, ref high)
            && FlatSegment.Slab(a.Y, b.Y - a.Y, center.Y - box.Max.Y - half, center.Y - box.Min.Y + half, ref low, ref high);
    }
}
