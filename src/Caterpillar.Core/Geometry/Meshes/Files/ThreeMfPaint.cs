namespace Caterpillar.Geometry;

/// <summary>A painted triangle: for supports or seams, enforced or blocked.</summary>
internal readonly record struct ThreeMfPaint(bool IsSeam, bool IsBlocked, Vec3 A, Vec3 B, Vec3 C)
{
    private const int MaxDepth = 64;

    // Half the thickness of painted faces as bodies, mm: more than a layer.
    private const double Reach = 1;

    /// <summary>
    /// The painted triangles of a face from an attribute of PrusaSlicer or OrcaSlicer (TriangleSelector): a tree in hexadecimal digits from right to left. The
    /// low two bits of a digit are the number of divided sides. At 0 the others are the state; else they are the first side, and the children follow, last
    /// first.
    /// </summary>
    public static void Read(string digits, bool isSeam, Vec3 a, Vec3 b, Vec3 c, List<ThreeMfPaint> found)
    {
        var at = digits.Length;
        Read(a, b, c, 0);

        void Read(Vec3 p, Vec3 q, Vec3 r, int depth)
        {
            var code = Next();
            if (code < 0 || depth > MaxDepth) return;
            var (sides, high) = (code & 3, code >> 2);
            if (sides == 0)
            {
                var state = high == 3 ? Next() + 3 : high;
                if (state is 1 or 2) found.Add(new ThreeMfPaint(isSeam, state == 2, p, q, r));
                return;
            }
            for (var turn = 0; turn < high; turn++) (p, q, r) = (q, r, p);
            var (pq, qr, rp) = ((p + q) / 2, (q + r) / 2, (r + p) / 2);
            if (sides == 3) Read(pq, qr, rp, depth + 1);
            if (sides == 3) Read(qr, r, rp, depth + 1);
            if (sides == 2) Read(q, r, rp, depth + 1);
            if (sides == 1) Read(qr, r, p, depth + 1);
            if (sides > 1) Read(pq, q, sides == 3 ? qr : rp, depth + 1);
            if (sides > 1) Read(p, pq, rp, depth + 1);
            if (sides == 1) Read(p, q, qr, depth + 1);
        }

        int Next() => --at >= 0 ? digits[at] switch { >= '0' and <= '9' and var d => d - '0', >= 'A' and <= 'F' and var d => d - 'A' + 10, _ => -1 } : -1;
    }

    /// <summary>Painted faces as a mesh without thickness.</summary>
    public static TriMesh Faces(IEnumerable<ThreeMfPaint> painted)
    {
        var builder = new MeshBuilder(64, 64);
        foreach (var face in painted) builder.AddTriangle(Vertex(builder, face.A, 0), Vertex(builder, face.B, 0), Vertex(builder, face.C, 0));
        return builder.ToMesh();
    }

    /// <summary>Painted faces as bodies, which reach a little above and below them.</summary>
    public static TriMesh Bodies(IEnumerable<ThreeMfPaint> painted)
    {
        var builder = new MeshBuilder(64, 64);
        var edges = new HashSet<(Vec3, Vec3)>();
        var faces = new List<ThreeMfPaint>();
        foreach (var face in painted)
        {
            var up = Vec3.Cross(face.B - face.A, face.C - face.A).Z;
            if (up == 0) continue;
            var down = up < 0 ? face : face with { B = face.C, C = face.B };
            faces.Add(down);
            edges.UnionWith(Sides(down));
        }
        foreach (var face in faces)
        {
            builder.AddTriangle(Vertex(builder, face.A, -Reach), Vertex(builder, face.B, -Reach), Vertex(builder, face.C, -Reach));
            builder.AddTriangle(Vertex(builder, face.A, Reach), Vertex(builder, face.C, Reach), Vertex(builder, face.B, Reach));
            foreach (var (from, to) in Sides(face).Where(s => !edges.Contains((s.Item2, s.Item1))))
            {
                builder.AddTriangle(Vertex(builder, to, -Reach), Vertex(builder, from, -Reach), Vertex(builder, from, Reach));
                builder.AddTriangle(Vertex(builder, to, -Reach), Vertex(builder, from, Reach), Vertex(builder, to, Reach));
            }
        }
        return builder.ToMesh();
    }

    private static (Vec3, Vec3)[] Sides(ThreeMfPaint f) => [(f.A, f.B), (f.B, f.C), (f.C, f.A)];

    private static int Vertex(MeshBuilder builder, Vec3 p, double lift) => builder.AddVertex(p.X, p.Y, p.Z + lift);
}
