namespace Caterpillar.Curved;

/// <summary>A surface or a set of curves that marks a boundary of layers on a part.</summary>
public sealed class BoundaryShape
{
    private readonly Func<Vec3, double> _distance;

    private BoundaryShape(Func<Vec3, double> distance) => _distance = distance;

    /// <summary>A boundary from a surface that touches or cuts the part.</summary>
    /// <exception cref="ArgumentException">The mesh has no triangles.</exception>
    public static BoundaryShape Of(TriMesh surface)
    {
        var distance = new MeshDistance(surface ?? throw new ArgumentNullException(nameof(surface)));
        return new BoundaryShape(p => distance.Nearest(p).Point.DistanceTo(p));
    }

    /// <summary>A boundary from several shapes.</summary>
    public static BoundaryShape Of(IReadOnlyList<BoundaryShape> shapes)
    {
        if (shapes is null) throw new ArgumentNullException(nameof(shapes));
        return new BoundaryShape(p => shapes.Select(s => s.DistanceTo(p)).DefaultIfEmpty(double.PositiveInfinity).Min());
    }

    /// <summary>A boundary from curves on the part.</summary>
    public static BoundaryShape Of(IReadOnlyList<Polyline> curves)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        return new BoundaryShape(p =>
        {
            var least = double.PositiveInfinity;
            foreach (var curve in curves)
            {
                for (var i = 0; i < curve.SegmentCount; i++) least = Math.Min(least, p.DistanceToSegment(curve[i], curve[(i + 1) % curve.Count]));
            }
            return least;
        });
    }

    internal double DistanceTo(Vec3 point) => _distance(point);
}
