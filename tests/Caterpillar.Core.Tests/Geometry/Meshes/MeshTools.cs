using System.Linq;
using Caterpillar.Geometry;

namespace Caterpillar.Tests;

/// <summary>What only tests ask of meshes.</summary>
internal static class MeshTools
{
    public static TriMesh Scaled(this TriMesh mesh, double factor) => mesh.Transformed(Affine.Scale(factor));

    /// <summary>Turned by degrees about an axis through the origin.</summary>
    public static TriMesh Rotated(this TriMesh mesh, Vec3 axis, double degrees) => mesh.Transformed(Affine.Rotate(axis, degrees));

    /// <summary>Sets of triangles that are connected across edges.</summary>
    public static int BodyCount(this TriMesh mesh)
    {
        var parents = Enumerable.Range(0, mesh.TriangleCount).ToArray();
        int Root(int at)
        {
            while (parents[at] != at) at = parents[at] = parents[parents[at]];
            return at;
        }
        var edges = Enumerable.Range(0, mesh.Indices.Count).GroupBy(h =>
        {
            int a = mesh.Indices[h], b = mesh.Indices[h % 3 == 2 ? h - 2 : h + 1];
            return a < b ? (a, b) : (b, a);
        });
        foreach (var edge in edges)
        {
            foreach (var half in edge) parents[Root(half / 3)] = Root(edge.First() / 3);
        }
        return Enumerable.Range(0, parents.Length).Count(t => parents[t] == t);
    }
}
