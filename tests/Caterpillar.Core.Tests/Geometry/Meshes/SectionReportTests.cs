using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Measures of sections by non-zero winding against the exact ones of the shared test data, within 1e-6 relative.</summary>
[Category("Arithmetic")]
[TestFixture]
public class SectionReportTests
{
    public static IEnumerable<string> Names => MeshSectionSharedTests.Names;

    [TestCaseSource(nameof(Names))]
    public void Sections_have_the_known_measures(string name)
    {
        var rows = MeshSectionSharedTests.Truth(name)["rows"]!.Cast<JObject>().ToArray();
        var report = SectionReport.Of(name, MeshSectionSharedTests.Mesh(name), rows.Select(r => (double)r["z"]!).ToArray());
        Assert.That(report.Diagnostics, Is.Empty);
        Assert.Multiple(() =>
        {
            for (var i = 0; i < rows.Length; i++) AssertRow(report.Value!.Sections[i], rows[i]);
        });
    }

    [TestCaseSource(nameof(Names))]
    public void Flat_faces_give_the_limit_from_below_throughout(string name)
    {
        if (MeshSectionSharedTests.Truth(name)["on_flat_faces"] is not JArray flats) return;
        var report = SectionReport.Of(name, MeshSectionSharedTests.Mesh(name), flats.Select(f => (double)f["z"]!).ToArray());
        Assert.That(report.Diagnostics, Is.Empty);
        Assert.Multiple(() =>
        {
            for (var i = 0; i < flats.Count; i++) AssertRow(report.Value!.Sections[i], (JObject)flats[i]["below"]!);
        });
    }

    [TestCaseSource(nameof(Names))]
    public void Stacks_have_the_known_sums(string name)
    {
        var stack = MeshSectionSharedTests.Truth(name)["stack"]!;
        var h = (double)stack["h"]!;
        var heights = Enumerable.Range(0, (int)stack["planes"]!).Select(k => (k + 0.5) * h).ToArray();
        var report = SectionReport.Of(name, MeshSectionSharedTests.Mesh(name), heights).Value!;
        Assert.That(report.Sections.Sum(s => s.Area), Is.EqualTo((double)stack["area_sum"]!).Within(1e-4).Percent);
        Assert.That(report.Sections.Sum(s => s.Length), Is.EqualTo((double)stack["perimeter_sum"]!).Within(1e-4).Percent);
        Assert.That(report.Sections.Sum(s => s.Open), Is.EqualTo(0));
    }

    [Test]
    public void Dirty_meshes_give_measures_and_diagnostics()
    {
        var beetle = MeshSectionSharedTests.Mesh("beetle_open.obj");
        var report = SectionReport.Of("beetle", beetle, Enumerable.Range(1, 23).Select(z => z + 0.1).ToArray());
        Assert.That(report.Diagnostics.Select(d => d.Code), Does.Contain("mesh.naked_edges"));
        Assert.That(report.Value!.Sections.Sum(s => s.Open), Is.EqualTo(report.Diagnostics.Single(d => d.Code == "mesh.naked_edges").Count).And.GreaterThan(0));
        Assert.That(report.Value.Sections.Sum(s => s.Area), Is.GreaterThan(1000));
        var ogre = SectionReport.Of("ogre", MeshSectionSharedTests.Mesh("ogre_bodies.ply"), [20.03, 60.01, 70.02]);
        Assert.That(ogre.Value!.Sections.All(s => s.Area > 10));
        var bowl = SectionReport.Of("bowl", MeshSectionSharedTests.Mesh("bowl_open.ply"), [10, 46]);
        Assert.That(bowl.Value!.Sections.Select(s => s.Open == 0), Is.EqualTo(new[] { true, false }), "closed contours up to the wavy rim");
    }

    [Test]
    public void Json_has_the_documented_form()
    {
        var box = SectionReport.Of("a \"box\".stl", MeshBytes.Box, [1.5, 7]).Value!;
        Assert.That(SectionReport.ToJson([box, box]), Is.EqualTo(
            "[\n {\"model\": \"a \\\"box\\\".stl\", \"sections\": [\n"
            + "  {\"z\": 1.5, \"length\": 6, \"area\": 2, \"outer\": 1, \"holes\": 0, \"open\": 0},\n  {\"z\": 7, \"length\": 0, \"area\": 0, \"outer\": 0, "
                + "\"holes\": 0, \"open\": 0}\n ]},\n"
            + " {\"model\": \"a \\\"box\\\".stl\", \"sections\": [\n"
            + "  {\"z\": 1.5, \"length\": 6, \"area\": 2, \"outer\": 1, \"holes\": 0, \"open\": 0},\n  {\"z\": 7, \"length\": 0, \"area\": 0, \"outer\": 0, "
                + "\"holes\": 0, \"open\": 0}\n ]}\n]\n"));
        Assert.That(SectionReport.ToJson([]), Is.EqualTo("[]\n"));
        Assert.That(SectionReport.ToJson([SectionReport.Of("x", MeshBytes.Box, []).Value!]), Is.EqualTo("[\n {\"model\": \"x\", \"sections\": []}\n]\n"));
    }

    // The numbers of the test data have six decimals.
    private static void AssertRow(SectionMeasure row, JObject truth)
    {
        var (area, perimeter) = ((double)truth["area_nonzero"]!, (double)truth["perimeter"]!);
        Assert.That(row.Area, Is.EqualTo(area).Within(Math.Max(1e-6 * area, 1e-6)), $"area at {row.Z}");
        Assert.That(row.Length, Is.EqualTo(perimeter).Within(Math.Max(1e-6 * perimeter, 1e-6)), $"length at {row.Z}");
        Assert.That((row.Outer, row.Holes, row.Open), Is.EqualTo(((int)truth["outer"]!, (int)truth["holes"]!, 0)), $"contours at {row.Z}");
    }
}
