namespace Caterpillar.Geometry;

/// <summary>A point or a vector in space; lengths in mm.</summary>
public readonly struct Vec3 : IEquatable<Vec3>
{
    public double X { get; init; }

    public double Y { get; init; }

    public double Z { get; init; }

    public Vec3(double x, double y, double z = 0)
    {
        X = x;
        Y = y;
        Z = z;
    }

    public void Deconstruct(out double x, out double y, out double z) => (x, y, z) = (X, Y, Z);

    public static Vec3 Zero => default;

    public static Vec3 UnitX => new(1, 0, 0);

    public static Vec3 UnitY => new(0, 1, 0);

    public static Vec3 UnitZ => new(0, 0, 1);

    /// <summary>Length in mm.</summary>
    public double Length => Math.Sqrt(X * X + Y * Y + Z * Z);

    /// <summary>Square of the length in mm².</summary>
    public double LengthSquared => X * X + Y * Y + Z * Z;

    /// <summary>Length of the projection on the XY plane, mm.</summary>
    public double LengthXY => Math.Sqrt(X * X + Y * Y);

    /// <summary>True if all coordinates are finite numbers.</summary>
    public bool IsFinite => !double.IsNaN(X - X) && !double.IsNaN(Y - Y) && !double.IsNaN(Z - Z);

    public static Vec3 operator +(Vec3 a, Vec3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Vec3 operator -(Vec3 a, Vec3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vec3 operator -(Vec3 a) => new(-a.X, -a.Y, -a.Z);

    public static Vec3 operator *(Vec3 a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    public static Vec3 operator *(double s, Vec3 a) => new(a.X * s, a.Y * s, a.Z * s);

    public static Vec3 operator /(Vec3 a, double s) => new(a.X / s, a.Y / s, a.Z / s);

    public static bool operator ==(Vec3 a, Vec3 b) => a.X == b.X && a.Y == b.Y && a.Z == b.Z;

    public static bool operator !=(Vec3 a, Vec3 b) => !(a == b);

    /// <summary>Distance from the segment between two points.</summary>
    internal double DistanceToSegment(Vec3 a, Vec3 b)
    {
        var d = b - a;
        var square = d.LengthSquared;
        var t = square > 0 ? Math.Max(0, Math.Min(1, Dot(this - a, d) / square)) : 0;
        return DistanceTo(a + d * t);
    }

    public static double Dot(Vec3 a, Vec3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

    public static Vec3 Cross(Vec3 a, Vec3 b) => new(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

    /// <summary>The point at parameter <paramref name="t"/> from <paramref name="a"/> (0) to <paramref name="b"/> (1). Both ends are exact.</summary>
    public static Vec3 Lerp(Vec3 a, Vec3 b, double t) => t == 1 ? b : a + (b - a) * t;

    /// <summary>Distance in mm.</summary>
    public double DistanceTo(Vec3 other) => (other - this).Length;

    /// <summary>The unit vector in the same direction. The zero vector stays zero.</summary>
    public Vec3 Unit()
    {
        var length = Length;
        return length > 0 ? this / length : default;
    }

    public Vec3 WithZ(double z) => new(X, Y, z);

    public bool Equals(Vec3 other) => this == other;

    public override bool Equals(object? obj) => obj is Vec3 other && this == other;

    public override int GetHashCode()
    {
        // -0.0 and 0.0 are equal, so they hash alike.
        unchecked
        {
            return ((X + 0.0).GetHashCode() * 397 ^ (Y + 0.0).GetHashCode()) * 397 ^ (Z + 0.0).GetHashCode();
        }
    }

    /// <summary>For example <c>(1.5, 0, 20)</c>, with at most 6 decimals.</summary>
    public override string ToString() => IsFinite
        ? $"({NumberFormatter.Format(X, 6)}, {NumberFormatter.Format(Y, 6)}, {NumberFormatter.Format(Z, 6)})"
        : "(not finite)";
}
