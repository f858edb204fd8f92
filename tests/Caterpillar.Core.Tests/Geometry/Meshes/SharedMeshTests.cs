using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>The readers against the known counts of the shared meshes.</summary>
[TestFixture]
public class SharedMeshTests
{
    public static IEnumerable<string> Names =>
    [
        "fandisk.stl", "igea.ply", "spot.obj", "cheburashka.ply", "homer.stl", "plate_holes.stl", "torus.obj", "nested_boxes.obj", "overlap_boxes.stl",
        "tube_thin.stl", "beetle_open.obj", "ogre_bodies.ply", "bowl_open.ply", "terrain.obj", "saddle.obj",
    ];

    [TestCaseSource(nameof(Names))]
    public void Shared_mesh_has_the_known_counts(string name)
    {
        var truth = (JObject)JObject.Parse(File.ReadAllText(TestData.Shared("meshes/meshes.json")))[name]!;
        var read = MeshReader.Read(TestData.Shared("meshes/" + name));
        Assert.That(read.HasErrors, Is.False, string.Join("\n", read.Diagnostics));
        var mesh = read.Value!.Single().Mesh;
        Assert.Multiple(() =>
        {
            Assert.That(mesh.TriangleCount, Is.EqualTo((int)truth["triangles"]!), "triangles");
            Assert.That(Count(read.Diagnostics, "mesh.degenerate_faces"), Is.EqualTo((int)truth["degenerate_faces"]!), "degenerate");
            Assert.That(Count(read.Diagnostics, "mesh.duplicate_faces"), Is.EqualTo((int)truth["duplicate_faces"]!), "duplicates");
            Assert.That(mesh.VertexCount, Is.EqualTo((int)truth["vertices_merged"]!), "vertices");
            Assert.That(mesh.NakedEdgeCount, Is.EqualTo((int)truth["open_edges"]!), "open edges");
            Assert.That(mesh.NonManifoldEdgeCount, Is.EqualTo((int)truth["nonmanifold_edges"]!), "non-manifold edges");
            Assert.That(mesh.WindingConflictCount, Is.EqualTo((int)truth["winding_conflict_edges"]!), "winding conflicts");
            Assert.That(mesh.IsWatertight, Is.EqualTo((bool)truth["watertight"]!), "watertight");
            Assert.That(mesh.BodyCount(), Is.EqualTo((int)truth["bodies"]!), "bodies");
            Assert.That(mesh.Area, Is.EqualTo((double)truth["area_mm2"]!).Within(6e-5), "area");
            Assert.That(mesh.Volume, Is.EqualTo((double)truth["volume_mm3"]!).Within(6e-5), "volume");
            Assert.That(mesh.Bounds.Min.DistanceTo(Point(truth["bounds_min"]!)), Is.LessThan(2e-6), "lower corner");
            Assert.That(mesh.Bounds.Max.DistanceTo(Point(truth["bounds_max"]!)), Is.LessThan(2e-6), "upper corner");
            Assert.That(Count(read.Diagnostics, "mesh.naked_edges"), Is.EqualTo((int)truth["open_edges"]!), "reported open edges");
            Assert.That(read.Diagnostics.Any(d => d.Severity > Caterpillar.Basics.Severity.Note), Is.False, "warnings");
        });
    }

    private static int Count(IReadOnlyList<Caterpillar.Basics.Diagnostic> diagnostics, string code)
        => diagnostics.Where(d => d.Code == code).Sum(d => d.Count);

    private static Vec3 Point(JToken token) => new((double)token[0]!, (double)token[1]!, (double)token[2]!);
}
