using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Projects of PrusaSlicer and OrcaSlicer: parts, their settings, and painted faces.</summary>
[TestFixture]
public class ThreeMfProjectTests
{
    private const string Start = MeshBytes.ModelStart;

    private static TriMesh Two => TriMesh.Merge([MeshBytes.Box, MeshBytes.Box.Moved(new Vec3(10, 0, 0))]);

    [Test]
    public void Ranges_of_triangles_are_parts_of_an_object()
    {
        var model = Start + "<resources>" + MeshBytes.ModelObject(3, Two) + "</resources><build><item objectid=\"3\"/></build></model>";
        var config = """
            <config><object id="3" instances_count="1">
            <metadata type="object" key="name" value="plate.stl"/><metadata type="object" key="fill_density" value="30%"/>
            <volume firstid="0" lastid="11"><metadata type="volume" key="name" value="body"/>
            <metadata type="volume" key="volume_type" value="ModelPart"/></volume>
            <volume firstid="12" lastid="23"><metadata type="volume" key="name" value="knob"/>
            <metadata type="volume" key="volume_type" value="ParameterModifier"/>
            <metadata type="volume" key="perimeters" value="5"/><metadata type="volume" key="infill_every_layers_odd" value="2"/></volume></object></config>
            """;
        var read = MeshReader.Read(MeshBytes.ThreeMf(model, ("Metadata/Slic3r_PE_model.config", config)), "x.3mf").OrThrow();
        Assert.That(read.Select(m => m.Name), Is.EqualTo(new[] { "plate.stl", "plate.stl: knob" }));
        Assert.That(read.Select(m => m.Mesh.TriangleCount), Is.EqualTo(new[] { 12, 12 }));
        Assert.That(read[1].Mesh.Bounds.Min.X, Is.EqualTo(10));
        var settings = ProjectModels.Settings(read, new PrintSetup());
        Assert.That(settings.Value!.Select(s => (s.ModelType, s.WallCount, s.InfillDensityPercent)),
            Is.EqualTo(new[] { (ModelType.Part, 2, 30.0), (ModelType.Modifier, 5, 30.0) }));
        Assert.That(settings.Diagnostics.Single().Message, Is.EqualTo("plate.stl: knob: without an equal here: infill_every_layers_odd=2."));
    }

    [Test]
    public void Objects_of_other_parts_of_the_package_have_their_kind_and_settings_and_the_first_plate_counts()
    {
        var model = Start + "<resources><object id=\"5\"><components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/>"
            + "<component p:path=\"/3D/Objects/a.model\" objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 4 0 0\"/></components></object>"
            + "<object id=\"6\"><components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/></components></object></resources>"
            + "<build><item objectid=\"5\" transform=\"1 0 0 0 1 0 0 0 1 100 0 0\"/><item objectid=\"6\"/></build></model>";
        var part = Start + "<resources>" + MeshBytes.ModelObject(1) + MeshBytes.ModelObject(2) + "</resources><build/></model>";
        var config = """
            <config><object id="5"><metadata key="name" value="cup"/><metadata key="wall_loops" value="4"/>
            <part id="1" subtype="normal_part"><metadata key="name" value="a"/><metadata key="matrix" value="1 0"/></part>
            <part id="2" subtype="support_blocker"><metadata key="name" value="b"/></part></object>
            <plate><metadata key="plater_id" value="1"/><model_instance><metadata key="object_id" value="5"/></model_instance></plate>
            <plate><metadata key="plater_id" value="2"/><model_instance><metadata key="object_id" value="6"/></model_instance></plate></config>
            """;
        var made = MeshReader.Read(MeshBytes.ThreeMf(model, ("3D/Objects/a.model", part), ("Metadata/model_settings.config", config)), "x.3mf");
        Assert.That(made.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "mesh.plates" }));
        Assert.That(made.Value!.Select(m => (m.Name, m.Mesh.Bounds.Min.X)), Is.EqualTo(new[] { ("cup", 100.0), ("cup: b", 104.0) }));
        var settings = ProjectModels.Settings(made.Value!, new PrintSetup()).OrThrow();
        Assert.That(settings.Select(s => (s.ModelType, s.WallCount)), Is.EqualTo(new[] { (ModelType.Part, 4), (ModelType.SupportBlocker, 4) }));
    }

    // A whole face; a half, at the first and the second corner; a third part; the middle and a corner of four; nothing.
    [TestCase("4", 6)]
    [TestCase("401", 3)]
    [TestCase("045", 3)]
    [TestCase("4002", 1.5)]
    [TestCase("0042", 3)]
    [TestCase("00043", 1.5)]
    [TestCase("40003", 1.5)]
    [TestCase("0", 0)]
    [TestCase("", 0)]
    [TestCase("x", 0)]
    public void A_painted_face_is_a_tree_from_right_to_left(string digits, double area)
    {
        var found = new List<ThreeMfPaint>();
        ThreeMfPaint.Read(digits, false, Vec3.Zero, new Vec3(4, 0, 0), new Vec3(0, 3, 0), found);
        Assert.That(found.Sum(f => Vec3.Cross(f.B - f.A, f.C - f.A).Length / 2), Is.EqualTo(area).Within(1e-12));
        Assert.That(found.All(f => Vec3.Cross(f.B - f.A, f.C - f.A).Z > 0), "the children turn as their face");
    }

    [TestCase('1')]
    [TestCase('2')]
    [TestCase('3')]
    public void A_painted_face_that_is_divided_without_end_is_read_to_a_depth(char division)
    {
        var found = new List<ThreeMfPaint>();
        ThreeMfPaint.Read(new string(division, 500_000), false, Vec3.Zero, new Vec3(4, 0, 0), new Vec3(0, 3, 0), found);
        Assert.That(found, Is.Empty);
    }

    [Test]
    public void Painted_faces_are_bodies_with_closed_sides()
    {
        ThreeMfPaint[] faces =
        [
            new(false, false, Vec3.Zero, new Vec3(4, 0, 0), new Vec3(4, 3, 0)),
            new(false, false, Vec3.Zero, new Vec3(4, 3, 0), new Vec3(0, 3, 0)),
        ];
        var body = ThreeMfPaint.Bodies(faces);
        Assert.That((body.IsWatertight, body.TriangleCount), Is.EqualTo((true, 12)));
        Assert.That(body.Volume, Is.EqualTo(24).Within(1e-12));
        Assert.That(ThreeMfPaint.Bodies([new(false, false, Vec3.Zero, new Vec3(0, 0, 1), new Vec3(0, 1, 0))]).TriangleCount, Is.Zero, "upright");
    }

    [Test]
    public void Painted_faces_become_enforcers_blockers_and_seams()
    {
        var model = (Start + "<resources>" + MeshBytes.ModelObject(1)
            + "</resources><build><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 50 0 0\"/></build></model>")
            .Replace("xmlns=", "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\" xmlns=");
        var faces = 0;
        model = System.Text.RegularExpressions.Regex.Replace(model, "(<triangle [^/]*)/>", m => faces++ switch
        {
            0 => m.Groups[1].Value + " slic3rpe:custom_supports=\"4\"/>",
            1 => m.Groups[1].Value + " paint_supports=\"8\" paint_seam=\"4\"/>",
            _ => m.Value,
        });
        var read = MeshReader.Read(MeshBytes.ThreeMf(model), "x.3mf").OrThrow();
        Assert.That(read.Select(m => m.Name.Split(':').Last().Trim()).Skip(1), Is.EqualTo(new[] { "painted supports", "painted no supports", "painted seam" }));
        var settings = ProjectModels.Settings(read, new PrintSetup()).OrThrow();
        ModelType[] types = [ModelType.Part, ModelType.SupportEnforcer, ModelType.SupportBlocker, ModelType.Modifier];
        Assert.That(settings.Select(s => s.ModelType), Is.EqualTo(types));
        var moved = read.Select(m => m with { Mesh = m.Mesh.Moved(new Vec3(0, 7, 0)) }).ToArray();
        var models = ProjectModels.Models(moved, settings);
        Assert.That(models.Select(m => m.Settings.SeamEnforcers.Count), Is.EqualTo(new[] { 1, 0, 0 }));
        var seam = read[3].Mesh;
        var center = (seam.Vertices[0] + seam.Vertices[1] + seam.Vertices[2]) / 3 + new Vec3(0, 7, 0);
        var mark = models[0].Settings.SeamEnforcers[0];
        Assert.That(mark.Place.DistanceTo(center), Is.LessThan(1e-9));
        Assert.That(mark.Radius, Is.EqualTo(seam.Vertices.Take(3).Max(v => (v + new Vec3(0, 7, 0)).DistanceTo(center))).Within(1e-9), "The whole face.");
    }
}
