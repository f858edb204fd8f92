namespace Caterpillar.Geometry;

/// <summary>An axis-aligned bounding box in mm, which may be empty (<see cref="IsEmpty"/>).</summary>
public readonly record struct Bounds
{
    private readonly bool _any;

    /// <summary>The corner with the minimum coordinates, mm.</summary>
    public Vec3 Min { get; }

    /// <summary>The corner with the maximum coordinates, mm.</summary>
    public Vec3 Max { get; }

    /// <summary>A box from its corners.</summary>
    /// <exception cref="ArgumentException">A coordinate of <paramref name="max"/> is below the same one of <paramref name="min"/>.</exception>
    public Bounds(Vec3 min, Vec3 max)
    {
        if (!(min.X <= max.X && min.Y <= max.Y && min.Z <= max.Z)) throw new ArgumentException("The minimum must not exceed the maximum.", nameof(max));
        Min = min;
        Max = max;
        _any = true;
    }

    /// <summary>The empty box.</summary>
    public static Bounds Empty => default;

    /// <summary>True if the box contains nothing, not even a point.</summary>
    public bool IsEmpty => !_any;

    /// <summary>Size in mm along each axis. Zero if empty.</summary>
    public Vec3 Size => Max - Min;

    /// <summary>Center, mm.</summary>
    public Vec3 Center => (Min + Max) * 0.5;

    /// <summary>The box around points. Empty if there are none.</summary>
    public static Bounds Of(IEnumerable<Vec3> points)
    {
        var bounds = Empty;
        foreach (var point in points) bounds = bounds.Include(point);
        return bounds;
    }

    /// <summary>The box extended to include a point.</summary>
    public Bounds Include(Vec3 p) => Contains(p) ? this : _any
        ? new Bounds(
            new Vec3(Math.Min(Min.X, p.X), Math.Min(Min.Y, p.Y), Math.Min(Min.Z, p.Z)),
            new Vec3(Math.Max(Max.X, p.X), Math.Max(Max.Y, p.Y), Math.Max(Max.Z, p.Z)))
        : new Bounds(p, p);

    /// <summary>The box around this box and another.</summary>
    public Bounds Include(Bounds other) => other.IsEmpty ? this : Include(other.Min).Include(other.Max);

    /// <summary>The box grown by <paramref name="margin"/> mm on every side. An empty box stays empty.</summary>
    public Bounds Grow(double margin) => _any ? new Bounds(Min - new Vec3(margin, margin, margin), Max + new Vec3(margin, margin, margin)) : this;

    /// <summary>True if the boxes have a volume in common; touching is not enough.</summary>
    internal bool Overlaps(Bounds other) => _any && other._any
        && Min.X < other.Max.X && other.Min.X < Max.X && Min.Y < other.Max.Y && other.Min.Y < Max.Y && Min.Z < other.Max.Z && other.Min.Z < Max.Z;

    /// <summary>True if the point is inside or on the box, within <paramref name="tolerance"/> mm.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Contains(Vec3 p, double tolerance = 0) => _any
        && p.X >= Min.X - tolerance && p.X <= Max.X + tolerance
        && p.Y >= Min.Y - tolerance && p.Y <= Max.Y + tolerance
        && p.Z >= Min.Z - tolerance && p.Z <= Max.Z + tolerance;

    public bool Contains(Bounds other, double tolerance = 0) => other.IsEmpty || (Contains(other.Min, tolerance) && Contains(other.Max, tolerance));

    /// <summary>Its corners: corner k has the highest X, Y and Z by its bits.</summary>
    internal IEnumerable<Vec3> Corners()
    {
        for (var k = 0; k < 8; k++) yield return new Vec3((k & 1) == 0 ? Min.X : Max.X, (k & 2) == 0 ? Min.Y : Max.Y, (k & 4) == 0 ? Min.Z : Max.Z);
    }

    /// <summary>Greatest distance from the Z axis.</summary>
    internal double ReachXY => Corners().Max(corner => corner.LengthXY);

    public override string ToString() => _any ? $"{Min} to {Max}" : "empty";
}
