namespace Caterpillar.Geometry;

/// <summary>
/// Welds the corners of the facets of a binary STL file. Each thread takes the corners of its share of all points, by their hash, and notes for each the
/// first corner in the same place; points are then numbered in the order of their first corners, whatever the number of threads.
/// </summary>
internal sealed class StlCorners(MeshSource source, int start, int facetBytes, int facets)
{
    private const int FacetsPerThread = 10_000;
    private const int MostThreads = 4;
    private readonly int[] _first = new int[3 * facets];

    /// <summary>The points, and the number of the point of each corner; −1 where a coordinate cannot be used.</summary>
    public (Vec3[] Points, int[] Numbers) Weld()
    {
        var shares = 1;
        while (2 * shares <= Math.Min(source.Threads, Math.Min(facets / FacetsPerThread, MostThreads))) shares *= 2;
        var counts = new int[shares];
        if (shares == 1) counts[0] = Weld(0, 1);
        else Parallel.For(0, shares, new ParallelOptions { CancellationToken = source.Cancel }, share => counts[share] = Weld(share, shares));
        var points = new Vec3[counts.Sum()];
        var used = 0;
        for (var corner = 0; corner < _first.Length; corner++)
        {
            var first = _first[corner];
            if (first < 0) continue;
            if (first < corner)
            {
                _first[corner] = _first[first];
                continue;
            }
            points[used] = PointOf(corner);
            _first[corner] = used++;
        }
        return (points, _first);
    }

    // The number of points of a share.
    private int Weld(int share, int shares)
    {
        // A closed mesh has about half as many vertices as triangles.
        var welder = new VertexWelder(facets / (2 * shares) + 16);
        var firsts = new int[facets / (2 * shares) + 16];
        for (var corner = 0; corner < _first.Length; corner++)
        {
            if (corner % (3 << 16) == 0)
            {
                source.Cancel.ThrowIfCancellationRequested();
                if (share == 0) source.Pulse(corner, _first.Length);
            }
            var p = PointOf(corner);
            const double Max = TriMesh.MaxCoordinate;
            if (!(Math.Abs(p.X) <= Max && Math.Abs(p.Y) <= Max && Math.Abs(p.Z) <= Max))
            {
                _first[corner] = -1;
                continue;
            }
            var hash = VertexWelder.Hash(p.X, p.Y, p.Z);
            if ((int)(hash & (ulong)(shares - 1)) != share) continue;
            var known = welder.Count;
            var number = welder.Add(p.X, p.Y, p.Z, hash);
            if (number == known)
            {
                if (number == firsts.Length) Array.Resize(ref firsts, 2 * number);
                firsts[number] = corner;
            }
            _first[corner] = firsts[number];
        }
        return welder.Count;
    }

    private Vec3 PointOf(int corner)
    {
        var at = start + corner / 3 * facetBytes + corner % 3 * 12;
        var bytes = source.Bytes;
        // Turns -0.0 into 0.0.
        return new Vec3(BitConverter.ToSingle(bytes, at) + 0.0, BitConverter.ToSingle(bytes, at + 4) + 0.0, BitConverter.ToSingle(bytes, at + 8) + 0.0);
    }
}
