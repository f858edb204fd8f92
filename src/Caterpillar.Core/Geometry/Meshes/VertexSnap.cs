namespace Caterpillar.Geometry;

/// <summary>Moves vertices of a mesh onto others that are near.</summary>
internal static class VertexSnap
{
    /// <summary>The largest reach, mm.</summary>
    public const double Largest = 1;

    /// <summary>For each vertex the one it moves to, or itself: the nearest earlier one that stays, within the reach of both.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="reach">How far each vertex may go, mm.</param>
    /// <param name="rim">The vertices that may move, those first that rather stay.</param>
    public static (int[] Targets, int Moved, double Farthest) Targets(TriMesh mesh, double[] reach, int[] rim)
    {
        var targets = Enumerable.Range(0, mesh.VertexCount).ToArray();
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
