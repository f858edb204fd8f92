using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>
/// Damages meshes as bad exports do: triangles deleted, flipped, doubled and moved, alone and in patches. The same seed gives the same damage.
/// </summary>
internal static class MeshDamage
{
    /// <summary>A mesh with some triangles damaged in some ways, and a name that says which.</summary>
    public static (TriMesh Mesh, string What) Damage(TriMesh mesh, int seed)
    {
        var random = new Random(seed);
        var triangles = Enumerable.Range(0, mesh.TriangleCount)
            .Select(t => new[] { mesh.Vertices[mesh.Indices[3 * t]], mesh.Vertices[mesh.Indices[3 * t + 1]], mesh.Vertices[mesh.Indices[3 * t + 2]] }).ToList();
        var kinds = 1 + random.Next(15);
        var what = new List<string> { $"seed {seed}" };
        if ((kinds & 1) != 0) what.Add($"deleted {Change(mesh, triangles, random, _ => [])}");
        if ((kinds & 2) != 0) what.Add($"flipped {Change(mesh, triangles, random, t => [Flipped(t)])}");
        if ((kinds & 4) != 0) what.Add($"doubled {Change(mesh, triangles, random, t => [t, random.Next(2) == 0 ? t : Flipped(t)])}");
        if ((kinds & 8) != 0) what.Add($"moved {Change(mesh, triangles, random, t => [Moved(t, random)])}");
        var points = triangles.SelectMany(t => t).ToArray();
        return (TriMesh.Create(points, Enumerable.Range(0, points.Length).ToArray()), string.Join(", ", what));
    }

    // Half of the time single triangles here and there (up to 2 %, at least one), else a few patches of up to 3 mm.
    private static string Change(TriMesh mesh, List<Vec3[]> triangles, Random random, Func<Vec3[], Vec3[][]> change)
    {
        var chosen = new HashSet<int>();
        string size;
        if (random.Next(2) == 0)
        {
            var count = 1 + random.Next(Math.Max(1, triangles.Count / 50));
            for (var i = 0; i < count; i++) chosen.Add(random.Next(triangles.Count));
            size = $"{chosen.Count} single";
        }
        else
        {
            var patches = 1 + random.Next(4);
            for (var i = 0; i < patches; i++)
            {
                var center = Center(triangles[random.Next(triangles.Count)]);
                var radius = 0.5 + 2.5 * random.NextDouble();
                for (var t = 0; t < triangles.Count; t++)
                {
                    if (Center(triangles[t]).DistanceTo(center) <= radius) chosen.Add(t);
                }
            }
            size = $"{chosen.Count} in {patches} patches";
        }
        var kept = triangles.SelectMany((t, i) => chosen.Contains(i) ? change(t) : [t]).ToList();
        triangles.Clear();
        triangles.AddRange(kept);
        return size;
    }

    private static Vec3 Center(Vec3[] t) => (t[0] + t[1] + t[2]) / 3;

    private static Vec3[] Flipped(Vec3[] t) => [t[0], t[2], t[1]];

    private static Vec3[] Moved(Vec3[] t, Random random)
    {
        var size = random.Next(2) == 0 ? 0.05 : 1.0;
        var shift = new Vec3(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5) * size;
        return [t[0] + shift, t[1] + shift, t[2] + shift];
    }
}
