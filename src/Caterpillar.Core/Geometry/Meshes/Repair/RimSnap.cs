using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>
/// Brings rims of a surface together: vertices on open edges that are nearer to each other than a quarter of the shortest edge that meets there (and than
/// a millimeter) become one. The vertex of the larger piece stays. Kept only where it leaves fewer open edges.
/// </summary>
internal static class RimSnap
{
    private const double Share = 0.25;
    private const double Largest = 1;

    public static (TriMesh Mesh, int Moved, double Farthest) Close(TriMesh mesh)
    {
        if (mesh.OpenEdgeCount == 0) return (mesh, 0, 0);
        var reach = Reaches(mesh);
        var (targets, moved, farthest) = Targets(mesh, reach);
        if (moved == 0) return (mesh, 0, 0);
        var builder = new MeshBuilder(mesh.VertexCount, mesh.TriangleCount);
        var ids = new int[mesh.VertexCount];
        for (var v = 0; v < ids.Length; v++)
        {
            var p = mesh.RawVertices[targets[v]];
            ids[v] = builder.AddVertex(p.X, p.Y, p.Z);
        }
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3) builder.AddTriangle(ids[triangles[t]], ids[triangles[t + 1]], ids[triangles[t + 2]]);
        var closed = builder.ToMesh();
        return closed.OpenEdgeCount < mesh.OpenEdgeCount ? (closed, moved, farthest) : (mesh, 0, 0);
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
        var rim = new List<int>();
        var cell = 0.0;
        for (var v = 0; v < targets.Length; v++)
        {
            targets[v] = v;
            if (!(reach[v] > 0)) continue;
            rim.Add(v);
            cell = Math.Max(cell, reach[v]);
        }
        var size = PieceSizes(mesh);
        rim.Sort((a, b) => size[a] != size[b] ? size[b].CompareTo(size[a]) : a.CompareTo(b));
        var cells = new Dictionary<(long, long, long), List<int>>();
        var moved = 0;
        var farthest = 0.0;
        foreach (var v in rim)
        {
            var p = mesh.RawVertices[v];
            var (x, y, z) = ((long)Math.Floor(p.X / cell), (long)Math.Floor(p.Y / cell), (long)Math.Floor(p.Z / cell));
            var best = -1;
            var nearest = reach[v];
            for (var i = 0; i < 27; i++)
            {
                if (!cells.TryGetValue((x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1), out var list)) continue;
                foreach (var other in list)
                {
                    var distance = p.DistanceTo(mesh.RawVertices[other]);
                    if (distance > reach[other] || distance > nearest || (distance == nearest && best >= 0)) continue;
                    (best, nearest) = (other, distance);
                }
            }
            if (best >= 0)
            {
                targets[v] = best;
                moved++;
                farthest = Math.Max(farthest, nearest);
                continue;
            }
            if (!cells.TryGetValue((x, y, z), out var own)) cells.Add((x, y, z), own = []);
            own.Add(v);
        }
        return (targets, moved, farthest);
    }

    // For each vertex the area of the largest piece it belongs to.
    private static double[] PieceSizes(TriMesh mesh)
    {
        var pieces = new MeshPieces(mesh);
        var sizes = new double[mesh.VertexCount];
        for (var h = 0; h < mesh.RawTriangles.Length; h++)
        {
            var v = mesh.RawTriangles[h];
            sizes[v] = Math.Max(sizes[v], pieces.Area[pieces.Of[h / 3]]);
        }
        return sizes;
    }
}
