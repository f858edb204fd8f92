namespace Caterpillar.Geometry;

/// <summary>A box that grows in place.</summary>
internal sealed class GrowingBox
{
    public double MinX = double.PositiveInfinity;
    public double MinY = double.PositiveInfinity;
    public double MinZ = double.PositiveInfinity;
    public double MaxX = double.NegativeInfinity;
    public double MaxY = double.NegativeInfinity;
    public double MaxZ = double.NegativeInfinity;

    public bool IsEmpty => MinX > MaxX;

    public void Include(Vec3 p) => Include(p.X, p.Y, p.Z);

    public void Include(double x, double y, double z)
    {
        if (x < MinX) MinX = x;
        if (x > MaxX) MaxX = x;
        if (y < MinY) MinY = y;
        if (y > MaxY) MaxY = y;
        if (z < MinZ) MinZ = z;
        if (z > MaxZ) MaxZ = z;
    }

    public void Include(GrowingBox other)
    {
        if (other.IsEmpty) return;
        Include(other.MinX, other.MinY, other.MinZ);
        Include(other.MaxX, other.MaxY, other.MaxZ);
    }

    /// <summary>Includes the outermost points of the circle through <paramref name="start"/>, as far as the arc passes them.</summary>
    public void Include(Arc arc, Vec3 start, Vec3 end)
    {
        var (u, v, _) = arc.Local(start);
        var radius = Math.Sqrt(u * u + v * v);
        if (radius == 0) return;
        var from = Angle.Atan2(v, u);
        var to = from + arc.Sweep;
        var low = Math.Min(from, to);
        var high = Math.Max(from, to);
        var first = Math.Ceiling(low / 90);
        for (var k = 0; k < 4 && (first + k) * 90 <= high; k++)
        {
            var (sin, cos) = Angle.SinCos((first + k) * 90);
            var outermost = arc.World(radius * cos, radius * sin, arc.Across(end));
            Include(outermost.X, outermost.Y, outermost.Z);
        }
    }

    public Bounds ToBounds() => IsEmpty ? Bounds.Empty : new Bounds(new Vec3(MinX, MinY, MinZ), new Vec3(MaxX, MaxY, MaxZ));
}
