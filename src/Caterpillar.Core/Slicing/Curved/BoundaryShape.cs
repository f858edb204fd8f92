using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>A surface or a set of curves that shows where a boundary of layers runs on a part.</summary>
public sealed class BoundaryShape
{
    private readonly Func<Vec3, double> _distance;

    private BoundaryShape(Func<Vec3, double> distance) => _distance = distance;

    /// <summary>A surface, which touches or cuts the part.</summary>
    /// <exception cref="ArgumentException">The mesh has no triangles.</exception>
    public static BoundaryShape Of(TriMesh surface)
    {
        var distance = new MeshDistance(surface ?? throw new ArgumentNullException(nameof(surface)));
        return new BoundaryShape(p => distance.Nearest(p).Point.DistanceTo(p));
    }

    /// <summary>Curves on the part.</summary>
    public static BoundaryShape Of(IReadOnlyList<Polyline> curves)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        return new BoundaryShape(p =>
        {
            var least = double.PositiveInfinity;
            foreach (var curve in curves)
            {
                for (var i = 0; i < curve.SegmentCount; i++) least = Math.Min(least, ToSegment(p, curve[i], curve[(i + 1) % curve.Count]));
            }
            return least;
        });
    }

    internal double DistanceTo(Vec3 point) => _distance(point);

    private static double ToSegment(Vec3 p, Vec3 a, Vec3 b)
    {
        var d = b - a;
        var square = d.LengthSquared;
        var t = square > 0 ? Math.Min(1, Math.Max(0, Vec3.Dot(p - a, d) / square)) : 0;
        return p.DistanceTo(a + d * t);
    }
}
