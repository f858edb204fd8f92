namespace Caterpillar.Geometry;

/// <summary>The pieces of a mesh: triangles that are joined over paired edges. Numbered by their first triangle.</summary>
internal sealed class MeshPieces
{
    public MeshPieces(TriMesh mesh)
    {
        var partner = mesh.Topology.Partner;
        var origin = mesh.Bounds.IsEmpty ? Vec3.Zero : mesh.Bounds.Center;
        Of = new int[mesh.TriangleCount];
        for (var t = 0; t < Of.Length; t++) Of[t] = -1;
        var queue = new Stack<int>();
        for (var first = 0; first < Of.Length; first++)
        {
            if (Of[first] >= 0) continue;
            var number = Area.Count;
            double area = 0, volume = 0;
            var closed = true;
            Of[first] = number;
            queue.Push(first);
            while (queue.Count > 0)
            {
                var t = queue.Pop();
                var (a, b, c) = mesh.Triangle(t);
                var p = mesh.RawVertices[a];
                var cross = Vec3.Cross(mesh.RawVertices[b] - p, mesh.RawVertices[c] - p);
                area += cross.Length / 2;
                volume += Vec3.Dot(p - origin, cross) / 6;
                for (var h = 3 * t; h < 3 * t + 3; h++)
                {
                    if (partner[h] < 0) closed = false;
                    else if (Of[partner[h] / 3] < 0)
                    {
                        Of[partner[h] / 3] = number;
                        queue.Push(partner[h] / 3);
                    }
                }
            }
            Area.Add(area);
            Volume.Add(volume);
            IsClosed.Add(closed);
        }
    }

    public int Count => Area.Count;

    /// <summary>Number of the piece of each triangle.</summary>
    public int[] Of { get; }

    /// <summary>Area of the surface of each piece, mm².</summary>
    public List<double> Area { get; } = [];

    /// <summary>Signed volume of each piece, mm³; negative where its triangles face inward.</summary>
    public List<double> Volume { get; } = [];

    /// <summary>True where every edge of a piece has a partner.</summary>
    public List<bool> IsClosed { get; } = [];

    /// <summary>The box around each piece.</summary>
    public Bounds[] Boxes(TriMesh mesh)
    {
        var boxes = new Bounds[Count];
        for (var h = 0; h < mesh.RawTriangles.Length; h++) boxes[Of[h / 3]] = boxes[Of[h / 3]].Include(mesh.RawVertices[mesh.RawTriangles[h]]);
        return boxes;
    }
}
