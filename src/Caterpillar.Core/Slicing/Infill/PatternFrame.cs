namespace Caterpillar.Slicing;

/// <summary>The turned coordinates of a pattern: u along its direction, v to the left of it, and the box of an area in them. mm.</summary>
internal readonly struct PatternFrame
{
    private readonly double _sin;
    private readonly double _cos;

    public PatternFrame(Region area, double angle)
    {
        (_sin, _cos) = Angle.SinCos(angle);
        MinU = MinV = double.PositiveInfinity;
        MaxU = MaxV = double.NegativeInfinity;
        foreach (var path in area.Paths)
        {
            foreach (var p in path)
            {
                double x = p.X / Grid.PerMm, y = p.Y / Grid.PerMm, u = x * _cos + y * _sin, v = y * _cos - x * _sin;
                MinU = Math.Min(MinU, u);
                MaxU = Math.Max(MaxU, u);
                MinV = Math.Min(MinV, v);
                MaxV = Math.Max(MaxV, v);
            }
        }
    }

    public double MinU { get; }

    public double MaxU { get; }

    public double MinV { get; }

    public double MaxV { get; }

    /// <summary>The place (u, v) in world coordinates, at Z 0.</summary>
    public Vec3 At(double u, double v) => new(u * _cos - v * _sin, u * _sin + v * _cos);

    /// <summary>Distance of a place along the direction.</summary>
    public double U(Vec3 p) => p.X * _cos + p.Y * _sin;

    /// <summary>Distance of a place to the left of the direction.</summary>
    public double V(Vec3 p) => p.Y * _cos - p.X * _sin;
}
