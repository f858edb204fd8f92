namespace Caterpillar.Slicing;

/// <summary>The convex outline of a model seen from above, counter-clockwise, mm. Immutable.</summary>
internal sealed class Footprint(Vec3[] corners, double height)
{
    // Counter-clockwise.
    private static readonly Vec3[] Directions =
        [new(1, 0), new(1, 1), new(0, 1), new(-1, 1), new(-1, 0), new(-1, -1), new(0, -1), new(1, -1)];

    private readonly Vec3[] _corners = corners;

    public Bounds Box { get; } = Bounds.Of(corners);

    /// <summary>Height of the model above its lowest point, mm.</summary>
    public double Height { get; } = height;

    public IReadOnlyList<Vec3> Corners => _corners;

    /// <summary>Andrew's monotone chain over the vertices.</summary>
    public static Footprint Of(TriMesh mesh) => new Footprint(Hull(Outer(mesh.RawVertices)), mesh.Bounds.IsEmpty ? 0 : mesh.Bounds.Size.Z);

    // The points that are not clearly inside the octagon of the outermost ones: of a model of many vertices only few have to be sorted (Akl and Toussaint, "A
    // fast convex hull algorithm", 1978).
    private static Vec3[] Outer(Vec3[] points)
    {
        var corners = new Vec3[8];
        for (var k = 0; k < corners.Length; k++)
        {
            var most = double.NegativeInfinity;
            var (x, y) = (Directions[k].X, Directions[k].Y);
            foreach (var p in points)
            {
                var reach = p.X * x + p.Y * y;
                if (!(reach > most)) continue;
                (most, corners[k]) = (reach, p);
            }
        }
        var outer = new List<Vec3>();
        foreach (var p in points)
        {
            var edges = 0;
            for (var k = 0; edges >= 0 && k < corners.Length; k++)
            {
                var (a, b) = (corners[k], corners[(k + 1) & 7]);
                if (a.X == b.X && a.Y == b.Y) continue;
                // Far more than what rounding makes of it.
                var inside = Turn(a, b, p) > 1e-9 * (Math.Abs(b.X - a.X) + Math.Abs(b.Y - a.Y)) * (1 + Math.Abs(p.X) + Math.Abs(p.Y));
                edges = inside ? edges + 1 : -1;
            }
            if (edges <= 0) outer.Add(p.WithZ(0));
        }
        return outer.ToArray();
    }

    /// <summary>A rectangle.</summary>
    public static Footprint Of(Bounds box) => new(
        [box.Min.WithZ(0), new Vec3(box.Max.X, box.Min.Y), box.Max.WithZ(0), new Vec3(box.Min.X, box.Max.Y)], box.Size.Z);

    public Footprint Moved(double x, double y) => new(Array.ConvertAll(_corners, p => new Vec3(p.X + x, p.Y + y)), Height);

    /// <summary>
    /// A distance in mm that two footprints keep at least: the widest strip between them along an axis or a normal of one of their edges; negative where they
    /// overlap.
    /// </summary>
    public double Separation(Footprint other)
        => Math.Max(BoxGap(other), Math.Max(Widest(_corners, other._corners), Widest(other._corners, _corners)));

    /// <summary>True if their separation is at least a distance, mm.</summary>
    public bool IsApart(Footprint other, double distance) => BoxGap(other) >= distance || Separation(other) >= distance;

    private double BoxGap(Footprint other)
        => Math.Max(
            Math.Max(other.Box.Min.X - Box.Max.X, Box.Min.X - other.Box.Max.X), Math.Max(other.Box.Min.Y - Box.Max.Y, Box.Min.Y - other.Box.Max.Y));

    private static double Widest(Vec3[] from, Vec3[] to)
    {
        var widest = double.NegativeInfinity;
        for (var i = 0; i < from.Length; i++)
        {
            var a = from[i];
            var b = from[i + 1 == from.Length ? 0 : i + 1];
            double nx = b.Y - a.Y, ny = a.X - b.X;
            var length = Math.Sqrt(nx * nx + ny * ny);
            if (!(length > 0)) continue;
            var nearest = double.PositiveInfinity;
            foreach (var p in to) nearest = Math.Min(nearest, ((p.X - a.X) * nx + (p.Y - a.Y) * ny) / length);
            widest = Math.Max(widest, nearest);
        }
        return widest;
    }

    private static Vec3[] Hull(Vec3[] points)
    {
        Array.Sort(points, (p, q) => p.X != q.X ? p.X.CompareTo(q.X) : p.Y.CompareTo(q.Y));
        var hull = new List<Vec3>();
        for (var pass = 0; pass < 2; pass++)
        {
            var start = hull.Count;
            foreach (var p in points)
            {
                while (hull.Count >= start + 2 && Turn(hull[hull.Count - 2], hull[hull.Count - 1], p) <= 0) hull.RemoveAt(hull.Count - 1);
                hull.Add(p);
            }
            if (hull.Count > 0) hull.RemoveAt(hull.Count - 1);
            Array.Reverse(points);
        }
        return hull.ToArray();
    }

    private static double Turn(Vec3 a, Vec3 b, Vec3 c) => (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}
