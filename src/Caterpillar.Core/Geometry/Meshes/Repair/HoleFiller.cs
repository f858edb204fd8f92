using System;
using System.Collections.Generic;
using System.Threading;

namespace Caterpillar.Geometry;

/// <summary>
/// Fills holes of a surface: closed rings of open edges, each with the triangles of the smallest area (dynamic programming over the ring, as in Barequet
/// and Sharir 1995, "Filling gaps in the boundary of a polyhedron"). One missing triangle so comes back as it was. Rings of many edges, and rings whose
/// filling is about as large as the surface around them (the rim of a sheet), stay open.
/// </summary>
internal static class HoleFiller
{
    private const int MaxEdges = 64;
    private const double MaxShare = 0.9;

    /// <summary>The mesh without holes and without what has come off at them, the holes, and the number of triangles that were left out.</summary>
    public static (TriMesh Mesh, IReadOnlyList<FilledHole> Holes, int Loose) Fill(TriMesh mesh, CancellationToken cancel)
    {
        if (mesh.Topology.IsPaired) return (mesh, [], 0);
        var pieces = new MeshPieces(mesh);
        var holes = new List<FilledHole>();
        var mended = new bool[pieces.Count];
        var added = new List<int>();
        var patch = new List<int>();
        foreach (var (ring, piece) in Rings(mesh, pieces))
        {
            cancel.ThrowIfCancellationRequested();
            if (ring.Length > MaxEdges) continue;
            patch.Clear();
            var area = Patch(mesh.RawVertices, ring, patch);
            if (area > MaxShare * pieces.Area[piece]) continue;
            added.AddRange(patch);
            mended[piece] = true;
            holes.Add(new FilledHole(BoxOf(mesh.RawVertices, ring), area));
        }
        if (holes.Count == 0) return (mesh, holes, 0);
        var loose = LoosePieces.Find(mesh, pieces, mended, holes);
        var triangles = new List<int>(mesh.RawTriangles.Length + added.Count);
        for (var h = 0; h < mesh.RawTriangles.Length; h++)
        {
            if (!loose[pieces.Of[h / 3]]) triangles.Add(mesh.RawTriangles[h]);
        }
        var left = mesh.TriangleCount - triangles.Count / 3;
        triangles.AddRange(added);
        var all = triangles.ToArray();
        return (TriMesh.Own(MeshCleaning.DropUnused(mesh.RawVertices, all), all), holes, left);
    }

    // Rings of at least three vertices in the direction in which the missing triangles run around them. A walk that passes a vertex twice is cut into
    // two rings there.
    private static IEnumerable<(int[] Ring, int Piece)> Rings(TriMesh mesh, MeshPieces pieces)
    {
        var partner = mesh.Topology.Partner;
        var triangles = mesh.RawTriangles;
        var seen = new bool[partner.Length];
        var walk = new List<int>();
        var places = new Dictionary<int, int>();
        for (var start = 0; start < partner.Length; start++)
        {
            if (partner[start] >= 0 || seen[start]) continue;
            walk.Clear();
            places.Clear();
            var edge = start;
            do
            {
                seen[edge] = true;
                var vertex = triangles[edge];
                if (places.TryGetValue(vertex, out var place))
                {
                    if (Cut(walk, places, place) is { } ring) yield return (ring, pieces.Of[start / 3]);
                }
                places[vertex] = walk.Count;
                walk.Add(vertex);
                edge = MeshTopology.Next(edge);
                // Around the vertex, through the triangles that meet in it, to the next open edge.
                while (partner[edge] >= 0) edge = MeshTopology.Next(partner[edge]);
            }
            while (edge != start);
            if (Cut(walk, places, 0) is { } last) yield return (last, pieces.Of[start / 3]);
        }
    }

    private static int[]? Cut(List<int> walk, Dictionary<int, int> places, int from)
    {
        var ring = walk.GetRange(from, walk.Count - from).ToArray();
        walk.RemoveRange(from, walk.Count - from);
        foreach (var vertex in ring) places.Remove(vertex);
        Array.Reverse(ring);
        return ring.Length >= 3 ? ring : null;
    }

    // Adds the triangles to the patch and returns their area.
    private static double Patch(Vec3[] vertices, int[] ring, List<int> patch)
    {
        var n = ring.Length;
        var best = new double[n * n];
        var split = new int[n * n];
        for (var span = 2; span < n; span++)
        {
            for (var i = 0; i + span < n; i++)
            {
                var j = i + span;
                var least = double.PositiveInfinity;
                for (var k = i + 1; k < j; k++)
                {
                    var p = vertices[ring[i]];
                    var area = best[i * n + k] + best[k * n + j] + Vec3.Cross(vertices[ring[k]] - p, vertices[ring[j]] - p).Length / 2;
                    if (!(area < least)) continue;
                    least = area;
                    split[i * n + j] = k;
                }
                best[i * n + j] = least;
            }
        }
        var open = new Stack<(int, int)>();
        open.Push((0, n - 1));
        while (open.Count > 0)
        {
            var (i, j) = open.Pop();
            if (j - i < 2) continue;
            var k = split[i * n + j];
            patch.Add(ring[i]);
            patch.Add(ring[k]);
            patch.Add(ring[j]);
            open.Push((i, k));
            open.Push((k, j));
        }
        return best[n - 1];
    }

    private static Bounds BoxOf(Vec3[] vertices, int[] ring)
    {
        var bounds = Bounds.Empty;
        foreach (var vertex in ring) bounds = bounds.Include(vertices[vertex]);
        return bounds;
    }
}
