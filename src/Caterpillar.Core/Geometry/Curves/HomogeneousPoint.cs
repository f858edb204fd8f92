namespace Caterpillar.Geometry;

/// <summary>A point times its weight, and the weight.</summary>
internal readonly record struct HomogeneousPoint(Vec3 Weighted, double Weight)
{
    public Vec3 Point => Weighted / Weight;

    public static HomogeneousPoint Of(Vec3 point, double weight) => new(point * weight, weight);

    /// <summary>(1 − t)·a + t·b; exact at both ends.</summary>
    public static HomogeneousPoint Mix(in HomogeneousPoint a, in HomogeneousPoint b, double t)
    {
        var s = 1 - t;
        return new(a.Weighted * s + b.Weighted * t, a.Weight * s + b.Weight * t);
    }
}
