namespace Caterpillar.Geometry;

/// <summary>
/// Chains the cut triangles of one plane to contours by walking from neighbor to neighbor. The cut point of an edge is computed from its lower to
/// its higher vertex number, so both triangles get the same bits and nothing is joined by distance. One per thread.
/// </summary>
internal sealed class SectionWalker(TriMesh mesh)
{
    private readonly Vec3[] _vertices = mesh.RawVertices;
    private readonly int[] _triangles = mesh.RawTriangles;
    private readonly int[] _partner = mesh.Topology.Partner;
    private readonly bool _paired = mesh.Topology.IsPaired;
    private readonly int[] _seen = new int[mesh.TriangleCount];
    private Vec3[] _points = new Vec3[256];
    private int _count;
    private int _round;

    /// <summary>Adds the contours of the plane to the lists, in the order of their first triangle; open ones from their start.</summary>
    public void Cut(double z, int[] layer, int from, int to, List<Polyline> loops, List<Polyline> open)
    {
        if (++_round == int.MaxValue)
        {
            Array.Clear(_seen, 0, _seen.Length);
            _round = 1;
        }
        if (!_paired)
        {
            for (var i = from; i < to; i++)
            {
                var (entry, _) = EntryAndExit(layer[i], z);
                if (_partner[entry] >= 0) continue;
                _count = 0;
                Push(CutPoint(entry, z));
                Walk(layer[i], z);
                PolylineCleaning.DropRepeats(_points, ref _count);
                if (_count > 1) open.Add(PolylineCleaning.ToPolyline(_points, _count, false));
            }
        }
        for (var i = from; i < to; i++)
        {
            if (_seen[layer[i]] == _round) continue;
            _count = 0;
            Walk(layer[i], z);
            var start = PolylineCleaning.DropSpikes(_points, ref _count);
            if (_count >= 3) loops.Add(PolylineCleaning.ToPolyline(_points, _count, true, start));
        }
    }

    private void Walk(int triangle, double z)
    {
        while (_seen[triangle] != _round)
        {
            _seen[triangle] = _round;
            var (_, exit) = EntryAndExit(triangle, z);
            Push(CutPoint(exit, z));
            var partner = _partner[exit];
            if (partner < 0) return;
            triangle = partner / 3;
        }
    }

    // A section runs with the solid on its left: it enters a triangle over the half-edge that goes down and leaves it over the one that goes up.
    private (int Entry, int Exit) EntryAndExit(int triangle, double z)
    {
        var h = 3 * triangle;
        var a = _vertices[_triangles[h]].Z >= z;
        var b = _vertices[_triangles[h + 1]].Z >= z;
        var c = _vertices[_triangles[h + 2]].Z >= z;
        if (a) return b ? (h + 1, h + 2) : c ? (h, h + 1) : (h, h + 2);
        return b ? (c ? (h + 2, h) : (h + 1, h)) : (h + 2, h + 1);
    }

    private Vec3 CutPoint(int halfEdge, double z)
    {
        int low = _triangles[halfEdge], high = _triangles[MeshTopology.Next(halfEdge)];
        if (low > high) (low, high) = (high, low);
        ref readonly var p = ref _vertices[low];
        ref readonly var q = ref _vertices[high];
        if (q.Z == z) return new Vec3(q.X, q.Y, z);
        var t = (z - p.Z) / (q.Z - p.Z);
        return new Vec3(p.X + (q.X - p.X) * t, p.Y + (q.Y - p.Y) * t, z);
    }

    private void Push(Vec3 p)
    {
        if (_count == _points.Length) Array.Resize(ref _points, 2 * _count);
        _points[_count++] = p;
    }
}
