namespace Caterpillar.Geometry;

/// <summary>
/// Finds open pieces that lie at a hole which was filled: triangles that have come off, whose place the filling takes. A piece belongs to a hole where it
/// is not larger than the filling and its box is inside the box of the hole, grown by half of its diagonal.
/// </summary>
internal static class LoosePieces
{
    private const int MaxBins = 64;

    // The filling is the smallest there is: what was in its place may be a little larger.
    private const double MaxShare = 1.25;

    /// <summary>True for the pieces that are left out; those that were repaired stay.</summary>
    public static bool[] Find(TriMesh mesh, MeshPieces pieces, bool[] repaired, IReadOnlyList<FilledHole> holes)
    {
        var boxes = pieces.Boxes(mesh);
        var bins = new Bins(holes, mesh.Bounds);
        var loose = new bool[pieces.Count];
        for (var piece = 0; piece < loose.Length; piece++)
        {
            if (pieces.IsClosed[piece] || repaired[piece]) continue;
            foreach (var place in bins.At(boxes[piece].Min))
                loose[piece] |= pieces.Area[piece] <= MaxShare * place.Area && place.Box.Contains(boxes[piece]);
        }
        return loose;
    }

    // Holes by the cells that their grown boxes reach into: about as many cells as holes.
    private sealed class Bins
    {
        private readonly List<FilledHole>?[] _cells;
        private readonly Bounds _all;
        private readonly int _side;

        public Bins(IReadOnlyList<FilledHole> holes, Bounds all)
        {
            _all = all;
            for (_side = 1; _side < MaxBins && _side * _side * _side < holes.Count; _side++)
            {
            }
            _cells = new List<FilledHole>?[_side * _side * _side];
            foreach (var hole in holes)
            {
                var box = hole.Box.Grow(hole.Width / 2);
                var (x0, y0, z0) = Cell(box.Min);
                var (x1, y1, z1) = Cell(box.Max);
                for (var z = z0; z <= z1; z++)
                {
                    for (var y = y0; y <= y1; y++)
                    {
                        for (var x = x0; x <= x1; x++) (_cells[(z * _side + y) * _side + x] ??= []).Add(new FilledHole(box, hole.Area));
                    }
                }
            }
        }

        public IEnumerable<FilledHole> At(Vec3 p)
        {
            var (x, y, z) = Cell(p);
            return _cells[(z * _side + y) * _side + x] ?? (IEnumerable<FilledHole>)[];
        }

        private (int X, int Y, int Z) Cell(Vec3 p) => (Bin(p.X, _all.Min.X, _all.Size.X), Bin(p.Y, _all.Min.Y, _all.Size.Y), Bin(p.Z, _all.Min.Z, _all.Size.Z));

        private int Bin(double at, double from, double size) => (int)Math.Max(0, Math.Min(_side - 1, (at - from) / Math.Max(size, 1e-9) * _side));
    }
}
