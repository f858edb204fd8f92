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
            if (Gradient(mesh, values, t, out var area) is not { } gradient) continue;
            var place = (mesh.RawVertices[corners[t]] + mesh.RawVertices[corners[t + 1]] + mesh.RawVertices[corners[t + 2]]) / 3;
            _faces.Add((gradient.Length, gradient.Z, area, place));
            _area += area;
        }
    }

    /// <summary>The gradient along a face, per mm; null where values are the same, as on boundaries that are whole faces, and without an area.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="values">One for each vertex.</param>
    /// <param name="corner">First corner of the face.</param>
    /// <param name="area">mm².</param>
    public static Vec3? Gradient(TriMesh mesh, double[] values, int corner, out double area)
    {
        var corners = mesh.RawTriangles;
        int a = corners[corner], b = corners[corner + 1], c = corners[corner + 2];
        Vec3 p = mesh.RawVertices[a], q = mesh.RawVertices[b], r = mesh.RawVertices[c];
        var normal = Vec3.Cross(q - p, r - p);
        var square = normal.LengthSquared;
        area = Math.Sqrt(square) / 2;
        if (!(square > 0) || (values[a] == values[b] && values[b] == values[c])) return null;
        return Vec3.Cross(normal, (r - q) * values[a] + (p - r) * values[b] + (q - p) * values[c]) / square;
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

    /// <summary>The share of the area on which a tool points against rising values, and the middle of the largest such face.</summary>
    /// <param name="tilt">Maximum tilt of the tool toward the direction in which values rise, 0 to 90 degrees.</param>
    /// <param name="place">mm.</param>
    public double Falling(double tilt, out Vec3 place)
    {
        var lowest = -Angle.Sin(tilt);
        place = Vec3.Zero;
        var (largest, sum) = (0.0, 0.0);
        foreach (var face in _faces)
        {
            if (face.Rise > lowest * face.Slope) continue;
            sum += face.Area;
            if (face.Area <= largest) continue;
            (largest, place) = (face.Area, face.Place);
        }
        return sum / _area;
    }
}
