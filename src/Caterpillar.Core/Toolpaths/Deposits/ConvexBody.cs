namespace Caterpillar.Toolpaths;

/// <summary>A flat disc; a point if its radius is 0.</summary>
internal readonly record struct Disc(Vec3 Center, Vec3 Normal, double Radius)
{
    /// <summary>The farthest point along a direction.</summary>
    public Vec3 Farthest(Vec3 direction)
    {
        if (Radius == 0) return Center;
        var across = direction - Normal * Vec3.Dot(direction, Normal);
        var length = across.Length;
        // Straight across the disc what is left is rounding, which may point out of it.
        return length > 1e-9 * direction.Length ? Center + across * (Radius / length) : Center;
    }
}

/// <summary>The convex hull of discs and points.</summary>
internal sealed class ConvexBody(params Disc[] discs)
{
    /// <summary>The axis-parallel box around it.</summary>
    public Bounds Bounds
    {
        get
        {
            var low = new Vec3(Farthest(-Vec3.UnitX).X, Farthest(-Vec3.UnitY).Y, Farthest(-Vec3.UnitZ).Z);
            return new Bounds(low, new Vec3(Farthest(Vec3.UnitX).X, Farthest(Vec3.UnitY).Y, Farthest(Vec3.UnitZ).Z));
        }
    }

    /// <summary>The hull of the corners of a box, in each of some frames.</summary>
    public static ConvexBody Of(Bounds box, params Affine[] frames)
        => new([.. frames.SelectMany(frame => box.Corners().Select(corner => new Disc(frame.Apply(corner), Vec3.UnitZ, 0)))]);

    /// <summary>The hull of the centers.</summary>
    public ConvexBody MiddleLine() => new([.. discs.Select(d => d with { Radius = 0 })]);

    /// <summary>The farthest point along a direction.</summary>
    public Vec3 Farthest(Vec3 direction)
    {
        var best = discs[0].Farthest(direction);
        var most = Vec3.Dot(best, direction);
        for (var i = 1; i < discs.Length; i++)
        {
            var point = discs[i].Farthest(direction);
            var along = Vec3.Dot(point, direction);
            if (along > most) (best, most) = (point, along);
        }
        return best;
    }

    /// <summary>
    /// True if another body comes within a distance, mm (Gilbert, Johnson and Keerthi 1988). Where rounding leaves it open the answer is true.
    /// </summary>
    /// <param name="other">The other body.</param>
    /// <param name="distance">The distance, mm.</param>
    /// <param name="apart">A direction in which this one probably lies beyond the other, of length 1.</param>
    public bool Meets(ConvexBody other, double distance, Vec3 apart)
    {
        const int Most = 64;
        // The simplex of the difference of both bodies that is nearest to the origin.
        Vec3[]? simplex = null;
        var count = 0;
        var near = apart;
        var known = double.PositiveInfinity;
        for (var round = 0; round < Most; round++)
        {
            var corner = Farthest(-near) - other.Farthest(near);
            var length = near.Length;
            var along = Vec3.Dot(near, corner);
            if (along > distance * length) return false;
            if (count > 0 && known - along <= 1e-12 * known + 1e-15) return length <= distance;
            simplex ??= new Vec3[4];
            simplex[count++] = corner;
            near = NearestOnSimplex.Of(simplex, ref count);
            var square = near.LengthSquared;
            if (square <= distance * distance || count == 4) return true;
            // It no longer comes nearer: rounding.
            if (square >= known) return Math.Sqrt(square) <= distance + 1e-9;
            known = square;
        }
        return true;
    }
}

/// <summary>The point of a simplex that is nearest to the origin (Ericson, Real-Time Collision Detection, 5.1), and the corners that it needs.</summary>
internal static class NearestOnSimplex
{
    // Height of a corner over a face, as a share of their distance: less is rounding.
    private const double Flat = 1e-9;

    /// <summary>The point; what is not needed of the simplex is dropped. With four corners left the origin is inside.</summary>
    public static Vec3 Of(Vec3[] s, ref int count) => count switch
    {
        1 => s[0],
        2 => Segment(s, ref count),
        3 => Triangle(s, ref count),
        _ => Tetrahedron(s, ref count),
    };

    private static Vec3 Segment(Vec3[] s, ref int count)
    {
        var d = s[1] - s[0];
        var t = -Vec3.Dot(s[0], d);
        var square = d.LengthSquared;
        if (t <= 0) count = 1;
        else if (t >= square) (s[0], count) = (s[1], 1);
        else return s[0] + d * (t / square);
        return s[0];
    }

    private static Vec3 Triangle(Vec3[] s, ref int count)
    {
        Vec3 a = s[0], b = s[1], c = s[2], ab = b - a, ac = c - a;
        var (point, u, v, w) = TriangleDistance.Nearest(Vec3.Zero, a, b, c);
        if (u == 0 || v == 0 || w == 0)
        {
            count = 0;
            if (u != 0) s[count++] = a;
            if (v != 0) s[count++] = b;
            if (w != 0) s[count++] = c;
            return point;
        }
        if (Vec3.Cross(ab, ac).LengthSquared > Flat * Flat * ab.LengthSquared * ac.LengthSquared) return point;
        // A triangle that is a line: the nearest of its sides.
        var nearest = new Vec3(double.PositiveInfinity, 0);
        foreach (var (from, to) in new[] { (a, b), (a, c), (b, c) })
        {
            Vec3[] side = [from, to];
            var of = 2;
            var p = Segment(side, ref of);
            if (!(p.LengthSquared < nearest.LengthSquared)) continue;
            (nearest, s[0], s[1], count) = (p, side[0], side[1], of);
        }
        return nearest;
    }

    private static Vec3 Tetrahedron(Vec3[] s, ref int count)
    {
        Vec3[] face = new Vec3[3], best = new Vec3[3];
        var (nearest, square, corners) = (Vec3.Zero, double.PositiveInfinity, 4);
        for (var i = 0; i < 4; i++)
        {
            Vec3 a = s[i], b = s[(i + 1) & 3], c = s[(i + 2) & 3], d = s[(i + 3) & 3];
            var normal = Vec3.Cross(b - a, c - a);
            // Only a face with the origin on the other side than the fourth corner counts; where all four are nearly flat, any.
            var height = Vec3.Dot(d - a, normal);
            var isFlat = Math.Abs(height) <= Flat * normal.Length * (d - a).Length;
            if (!isFlat && -Vec3.Dot(a, normal) * height > 0) continue;
            (face[0], face[1], face[2]) = (a, b, c);
            var of = 3;
            var p = Triangle(face, ref of);
            if (!(p.LengthSquared < square)) continue;
            (nearest, square, corners) = (p, p.LengthSquared, of);
            Array.Copy(face, best, 3);
        }
        if (corners < 4) Array.Copy(best, s, corners);
        count = corners;
        return nearest;
    }
}
