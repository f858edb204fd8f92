namespace Caterpillar.Geometry;

/// <summary>
/// Joins naked edges: vertices on naked edges that are closer to each other than a quarter of the shortest edge at them, and than 1 mm, become one. The
/// vertex of the larger piece stays. The result is kept only if it has fewer naked edges.
/// </summary>
internal static class EdgeSnap
{
    private const double Share = 0.25;
    private const double Largest = 1;

    public static (TriMesh Mesh, int Moved, double Farthest) Close(TriMesh mesh)
    {
        if (mesh.NakedEdgeCount == 0) return (mesh, 0, 0);
        var reach = Reaches(mesh);
        var (targets, moved, farthest) = Targets(mesh, reach);
        if (moved == 0) return (mesh, 0, 0);
        var closed = MeshBuilder.Merging(mesh, targets).ToMesh();
        return closed.NakedEdgeCount < mesh.NakedEdgeCount ? (closed, moved, farthest) : (mesh, 0, 0);
    }

    // How far each vertex may go, 0 for those on no open edge.
    private static double[] Reaches(TriMesh mesh)
    {
        var partner = mesh.Topology.Partner;
        var shortest = new double[mesh.VertexCount];
        var open = new bool[mesh.VertexCount];
        for (var v = 0; v < shortest.Length; v++) shortest[v] = double.PositiveInfinity;
        for (var h = 0; h < partner.Length; h++)
        {
            int a = mesh.RawTriangles[h], b = mesh.RawTriangles[MeshTopology.Next(h)];
            var length = mesh.RawVertices[a].DistanceTo(mesh.RawVertices[b]);
            shortest[a] = Math.Min(shortest[a], length);
            shortest[b] = Math.Min(shortest[b], length);
            if (partner[h] < 0) open[a] = open[b] = true;
        }
        for (var v = 0; v < shortest.Length; v++) shortest[v] = open[v] ? Math.Min(Largest, Share * shortest[v]) : 0;
        return shortest;
    }

    private static (int[] Targets, int Moved, double Farthest) Targets(TriMesh mesh, double[] reach)
    {
        var targets = new int[mesh.VertexCount];
        for (var v = 0; v < targets.Length; v++) targets[v] = v;
        var rim = LargePiecesFirst(mesh, reach);
        var grid = new Grid(mesh.RawVertices, reach, rim.Length);
        var moved = 0;
        var farthest = 0.0;
        foreach (var v in rim)
        {
            var (best, distance) = grid.Nearest(v);
            if (best < 0)
            {
                grid.Add(v);
                continue;
            }
            targets[v] = best;
            moved++;
            farthest = Math.Max(farthest, distance);
        }
        return (targets, moved, farthest);
    }

    // The vertices that may move, those of large pieces first: a counting sort by the size of their piece in powers of two.
    private static int[] LargePiecesFirst(TriMesh mesh, double[] reach)
    {
        const int Sizes = 32;
        var pieces = new MeshPieces(mesh);
        var largest = 0.0;
        for (var i = 0; i < pieces.Count; i++) largest = Math.Max(largest, pieces.Area[i]);
        var kinds = new byte[pieces.Count];
        for (var i = 0; i < kinds.Length; i++)
        {
            for (var size = largest / 2; kinds[i] < Sizes - 1 && pieces.Area[i] < size; size /= 2) kinds[i]++;
        }
        var kind = new byte[mesh.VertexCount];
        for (var v = 0; v < kind.Length; v++) kind[v] = Sizes;
        for (var h = 0; h < mesh.RawTriangles.Length; h++)
        {
            var v = mesh.RawTriangles[h];
            if (reach[v] > 0) kind[v] = Math.Min(kind[v], kinds[pieces.Of[h / 3]]);
        }
        var starts = new int[Sizes + 2];
        foreach (var k in kind) starts[k + 1]++;
        for (var k = 0; k <= Sizes; k++) starts[k + 1] += starts[k];
        var rim = new int[starts[Sizes]];
        for (var v = 0; v < kind.Length; v++)
        {
            if (kind[v] < Sizes) rim[starts[kind[v]]++] = v;
        }
        return rim;
    }

    // Vertices that stay, hashed by cells that are as large as their reach, in powers of four: so a cell holds few vertices however much the lengths of
    // edges differ.
    private sealed class Grid
    {
        private const int MaxLevel = 12;
        private readonly Vec3[] _vertices;
        private readonly double[] _reach;
        private readonly int[] _heads;
        private readonly int[] _next;
        private readonly bool[] _levels = new bool[MaxLevel + 1];

        public Grid(Vec3[] vertices, double[] reach, int count)
        {
            (_vertices, _reach) = (vertices, reach);
            var size = 16;
            while (size < 2L * count && size < 1 << 28) size *= 2;
            _heads = new int[size];
            _next = new int[vertices.Length];
        }

        public void Add(int v)
        {
            var level = Level(_reach[v]);
            _levels[level] = true;
            var size = Size(level);
            var p = _vertices[v];
            var slot = Slot(level, Math.Floor(p.X / size), Math.Floor(p.Y / size), Math.Floor(p.Z / size));
            // Numbers from 1, so that 0 ends a chain.
            _next[v] = _heads[slot];
            _heads[slot] = v + 1;
        }

        // The nearest that is within the reach of both, or −1; of equally near ones that with the lowest number.
        public (int Vertex, double Distance) Nearest(int v)
        {
            var p = _vertices[v];
            var (best, nearest) = (-1, _reach[v]);
            for (var level = 0; level <= MaxLevel; level++)
            {
                if (!_levels[level]) continue;
                var size = Size(level);
                var r = Math.Min(_reach[v], size);
                double x1 = Math.Floor((p.X + r) / size), y1 = Math.Floor((p.Y + r) / size), z1 = Math.Floor((p.Z + r) / size);
                for (var z = Math.Floor((p.Z - r) / size); z <= z1; z++)
                {
                    for (var y = Math.Floor((p.Y - r) / size); y <= y1; y++)
                    {
                        for (var x = Math.Floor((p.X - r) / size); x <= x1; x++)
                        {
                            for (var other = _heads[Slot(level, x, y, z)] - 1; other >= 0; other = _next[other] - 1)
                            {
                                var distance = p.DistanceTo(_vertices[other]);
                                if (distance > _reach[other] || distance > nearest || (distance == nearest && best >= 0 && other > best)) continue;
                                (best, nearest) = (other, distance);
                            }
                        }
                    }
                }
            }
            return (best, nearest);
        }

        private static double Size(int level) => Largest / (1L << (2 * level));

        // The last level whose cells are not smaller than the reach.
        private static int Level(double reach)
        {
            var level = 0;
            while (level < MaxLevel && Size(level + 1) >= reach) level++;
            return level;
        }

        private int Slot(int level, double x, double y, double z)
        {
            unchecked
            {
                var h = ((ulong)(long)x * 0x9E3779B97F4A7C15UL) ^ ((ulong)(long)y * 0xD6E8FEB86659FD93UL) ^ ((ulong)(long)z * 0xA0761D6478BD642FUL);
                h = (h ^ (ulong)level) * 0xE7037ED1A0B428DBUL;
                return (int)(h >> 32) & (_heads.Length - 1);
            }
        }
    }
}
