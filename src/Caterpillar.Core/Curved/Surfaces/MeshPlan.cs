namespace Caterpillar.Curved;

/// <summary>The highest faces of a mesh as a plan.</summary>
internal sealed class MeshPlan(TriMesh mesh) : PlanSurface
{
    // mm: a part as large as its plan may reach over its edge by rounding.
    private static readonly double[] Steps = [1e-8, 1e-5, 1e-3, 0.02];

    // The highest faces of a solid face up.
    private readonly MeshHeights _heights = new(mesh, mesh.IsWatertight && mesh.Volume > 0);

    // About the length of an edge.
    public override double Detail { get; } = mesh.TriangleCount == 0 ? 1 : Math.Max(0.25, Math.Sqrt(2 * mesh.Area / mesh.TriangleCount));

    public override bool Covers(double x, double y) => !double.IsInfinity(Covered(x, y, out _));

    public override double Height(double x, double y)
    {
        var height = Covered(x, y, out _);
        return double.IsInfinity(height) ? Beyond(x, y).Height : height;
    }

    // That of the triangle: differences of heights would be wrong where points are moved onto the edge.
    internal override (double ByX, double ByY) Slope(double x, double y)
    {
        if (double.IsInfinity(Covered(x, y, out var triangle))) triangle = Beyond(x, y).Triangle;
        if (triangle < 0) return (0, 0);
        var (a, b, c) = mesh.Triangle(triangle);
        var normal = Vec3.Cross(mesh.RawVertices[b] - mesh.RawVertices[a], mesh.RawVertices[c] - mesh.RawVertices[a]);
        return (-normal.X / normal.Z, -normal.Y / normal.Z);
    }

    internal override void Check(DiagnosticList problems)
    {
        if (mesh.TriangleCount == 0)
        {
            problems.Add(Severity.Error, "curved.plan_empty", "The plan has no faces.");
            return;
        }
        if (mesh.IsWatertight) return;
        int up = 0, down = 0, firstDown = -1, firstUp = -1;
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var z = mesh.Normal(t).Z;
            if (z > 1e-6 && up++ == 0) firstUp = t;
            if (z < -1e-6 && down++ == 0) firstDown = t;
        }
        if (up == 0 && down == 0)
        {
            problems.Add(Severity.Error, "curved.plan_vertical", "The plan is vertical: it has no height over the part.");
        }
        else if (up > 0 && down > 0)
        {
            var (a, b, c) = mesh.Triangle(down < up ? firstDown : firstUp);
            var place = (mesh.Vertices[a] + mesh.Vertices[b] + mesh.Vertices[c]) / 3;
            problems.Add(Severity.Error, "curved.plan_folded",
                $"The plan folds over itself, first at {place}. A nozzle from above cannot follow it.{Otherwise}");
        }
        else if (up == 0)
        {
            problems.Add(Severity.Warning, "curved.plan_upside_down", "The plan faces down. Its layers are still printed upward.");
        }
    }

    private double Covered(double x, double y, out int triangle)
    {
        var height = Top(x, y, out triangle);
        if (!double.IsInfinity(height)) return height;
        // Points on the outermost edge may miss it by rounding; the less they are moved the better.
        var center = mesh.Bounds.Center;
        int dx = Math.Sign(center.X - x), dy = Math.Sign(center.Y - y);
        foreach (var step in Steps)
        {
            height = Top(x + dx * step, y, out triangle);
            if (double.IsInfinity(height)) height = Top(x, y + dy * step, out triangle);
            if (double.IsInfinity(height)) height = Top(x + dx * step, y + dy * step, out triangle);
            if (!double.IsInfinity(height)) break;
        }
        return height;
    }

    // The height where the line to the middle of the surface first meets it.
    private (double Height, int Triangle) Beyond(double x, double y)
    {
        const int Parts = 64;
        var center = mesh.Bounds.Center;
        for (var i = 1; i <= Parts; i++)
        {
            double inside = (double)i / Parts, outside = (i - 1.0) / Parts;
            if (double.IsInfinity(At(inside, out _))) continue;
            for (var k = 0; k < 30; k++)
            {
                var middle = (inside + outside) / 2;
                if (double.IsInfinity(At(middle, out _))) outside = middle;
                else inside = middle;
            }
            return (At(inside, out var triangle), triangle);
        }
        return (center.Z, -1);

        double At(double t, out int triangle) => Top(x + (center.X - x) * t, y + (center.Y - y) * t, out triangle);
    }

    private double Top(double x, double y, out int triangle) => _heights.TopUnder(x, y, double.PositiveInfinity, out triangle);
}
