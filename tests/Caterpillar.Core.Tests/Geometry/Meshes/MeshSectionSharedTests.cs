using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Plane sections against the exact ones of the shared test data.</summary>
[Category("Arithmetic")]
[TestFixture]
public class MeshSectionSharedTests
{
    public static IEnumerable<string> Names =>
    [
        "fandisk.stl", "igea.ply", "spot.obj", "cheburashka.ply", "homer.stl", "plate_holes.stl", "torus.obj", "nested_boxes.obj", "overlap_boxes.stl",
            "tube_thin.stl", "bumpy_sphere",
    ];

    [TestCaseSource(nameof(Names))]
    public void Raw_sections_have_the_known_signed_areas(string name)
    {
        var truth = Truth(name);
        var mesh = Mesh(name);
        var rows = truth["rows"]!.Cast<JObject>().ToArray();
        var sections = MeshSections.At(mesh, rows.Select(r => (double)r["z"]!).ToArray());
        Assert.That(sections.Diagnostics, Is.Empty);
        Assert.Multiple(() =>
        {
            for (var i = 0; i < rows.Length; i++)
            {
                var loops = sections.Value![i].Loops;
                Assert.That(sections.Value[i].OpenLines, Is.Empty);
                Assert.That(loops.Sum(l => l.SignedAreaXY),
                    Is.EqualTo((double)rows[i]["area_signed"]!).Within(1e-6).Percent.Or.EqualTo((double)rows[i]["area_signed"]!).Within(1e-6));
                if ((int)rows[i]["crossings"]! > 0) continue;
                Assert.That(loops.Sum(l => l.Length), Is.EqualTo((double)rows[i]["perimeter"]!).Within(2e-6));
                Assert.That(loops.Count(l => l.SignedAreaXY > 0), Is.EqualTo((int)rows[i]["outer"]!));
                Assert.That(loops.Count(l => l.SignedAreaXY < 0), Is.EqualTo((int)rows[i]["holes"]!));
            }
        });
    }

    [TestCaseSource(nameof(Names))]
    public void Stacks_of_sections_have_the_known_sums(string name)
    {
        var stack = Truth(name)["stack"]!;
        var mesh = Mesh(name);
        var h = (double)stack["h"]!;
        var heights = Enumerable.Range(0, (int)stack["planes"]!).Select(k => (k + 0.5) * h).ToArray();
        Assert.That((heights.Length + 0.5) * h, Is.GreaterThanOrEqualTo(mesh.Bounds.Max.Z));
        var sections = MeshSections.At(mesh, heights);
        Assert.That(sections.Diagnostics, Is.Empty);
        var loops = sections.Value!.SelectMany(s => s.Loops).ToArray();
        Assert.That(loops.Sum(l => l.SignedAreaXY), Is.EqualTo((double)stack["area_signed_sum"]!).Within(1e-4));
        Assert.That(loops.Sum(l => l.Length), Is.EqualTo((double)stack["length_all_sum"]!).Within(1e-4));
    }

    internal static JObject Truth(string name) => (JObject)JObject.Parse(File.ReadAllText(TestData.Shared("meshes/sections.json")))[name]!;

    internal static TriMesh Mesh(string name)
        => name == "bumpy_sphere" ? MeshMaker.BumpySphere() : TestData.Mesh(TestData.Shared("meshes/" + name));
}
