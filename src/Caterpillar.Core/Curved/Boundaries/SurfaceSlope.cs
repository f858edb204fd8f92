namespace Caterpillar.Curved;

/// <summary>How values at the vertices of a mesh change along its faces.</summary>
internal sealed class SurfaceSlope
{
    private readonly List<(double Slope, double Rise, double Area, Vec3 Place)> _faces = [];
    private readonly double _area;

    public SurfaceSlope(TriMesh mesh, double[] values)
    {
        var corners = mesh.RawTriangles;
        for (var t = 0; t < corners.Length; t += 3)
        {
            int a = corners[t], b = corners[t + 1], c = corners[t + 2];
            // Boundaries may be whole faces.
            if (values[a] == values[b] && values[b] == values[c]) continue;
            Vec3 p = mesh.RawVertices[a], q = mesh.RawVertices[b], r = mesh.RawVertices[c];
            var normal = Vec3.Cross(q - p, r - p);
            var square = normal.LengthSquared;
            if (!(square > 0)) continue;
            // The gradient of a linear function on a triangle.
            var gradient = Vec3.Cross(normal, (r - q) * values[a] + (p - r) * values[b] + (q - p) * values[c]) / square;
            var area = Math.Sqrt(square) / 2;
            _faces.Add((gradient.Length, gradient.Z, area, (p + q + r) / 3));
            _area += area;
        }
    }

    /// <summary>The distance along the surface over which the value changes by 1, mm: no more on a share of the area.</summary>
    public double Thickness(double share)
    {
        var faces = _faces.FindAll(f => f.Slope > 0);
        if (faces.Count == 0) return 1;
        faces.Sort((f, g) => g.Slope.CompareTo(f.Slope));
        var (sum, i) = (0.0, 0);
        while (i + 1 < faces.Count && sum + faces[i].Area < share * _area) sum += faces[i++].Area;
        return 1 / faces[i].Slope;
    }

    /// <summary>The share of the area on which values fall upward, and the middle of the largest such face.</summary>
    public double Falling(out Vec3 place)
    {
        place = Vec3.Zero;
        var (largest, sum) = (0.0, 0.0);
        foreach (var face in _faces)
        {
            if (face.Rise > 0) continue;
            sum += face.Area;
            if (face.Area <= largest) continue;
            (largest, place) = (face.Area, face.Place);
        }
        return sum / _area;
    }
}
