using System;
using System.Linq;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>What RhinoCommon and GH_IO do in cases that matter here; the same for the stand-ins and for the real assemblies.</summary>
[Category("Host")]
public sealed class RhinoFactsTests
{
    private static readonly Rg.Point3d A = new(0, 0, 0);
    private static readonly Rg.Point3d B = new(10, 0, 0);

    [Test]
    public void Polylines_with_doubled_points_and_lines_there_and_back_are_not_valid()
    {
        Assert.That(new Rg.PolylineCurve([A, B]).IsValid, Is.True);
        Assert.That(new Rg.PolylineCurve([A, A, B]).IsValid, Is.False);
        Assert.That(new Rg.PolylineCurve([A, new Rg.Point3d(2e-10, 0, 0), B]).IsValid, Is.False);
        Assert.That(new Rg.PolylineCurve([A, B, A]).IsValid, Is.False);
        Assert.That(new Rg.PolylineCurve([A, B, new Rg.Point3d(5, 0, 0), A]).IsValid, Is.True);
        Assert.That(new Rg.PolylineCurve([A, A, B]).TryGetPolyline(out var points), Is.True, "It is read all the same.");
        Assert.That(points.Count, Is.EqualTo(3));
    }

    [Test]
    public void A_curve_with_doubled_points_is_printed_without_them()
    {
        var canvas = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rg.PolylineCurve([A, A, B, B, new Rg.Point3d(10, 5, 0)])).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<PrintPath>("Print Path").Points, Has.Count.EqualTo(3));
        Assert.That(new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rg.PolylineCurve([A, A])).Solve().Errors, Has.One.Contains("no length"));
    }

    [Test]
    public void Faces_of_no_area_make_a_mesh_invalid_and_closed_is_a_matter_of_places()
    {
        Assert.That((Shapes.Box().IsValid, Shapes.Box().IsClosed), Is.EqualTo((true, true)), "Each face has corners of its own.");
        var flat = Shapes.Box();
        flat.Faces.AddFace(0, 0, 1);
        Assert.That(flat.IsValid, Is.False);
        Assert.That(Shapes.OpenBox().GetNakedEdges().Sum(e => e.Length), Is.EqualTo(40).Within(1e-9));
    }

    [Test]
    public void An_archive_takes_no_name_twice_and_names_what_it_lacks()
    {
        var chunk = new GH_LooseChunk("Chunk");
        chunk.SetInt32("Item", 1);
        Assert.That(() => chunk.SetInt32("Item", 2), Throws.InvalidOperationException);
        chunk.CreateChunk("Part");
        Assert.That(() => chunk.CreateChunk("Part"), Throws.ArgumentException);
        Assert.That(() => new GH_Archive().ExtractObject(new Grasshopper.Kernel.Parameters.Param_Number(), "Nothing"),
            Throws.InstanceOf<MemberAccessException>());
    }

    [TestCase("Größe 0.4 мм")]
    [TestCase("🐛 with \u0007 bell, \"quotes\" and \\ strokes")]
    public void Names_of_profiles_come_back_from_a_file_with_every_character(string title)
    {
        var goo = new PrinterGoo { Value = new Printer { Title = title } };
        var archive = new GH_Archive();
        archive.AppendObject(goo, "Printer");
        var text = archive.Serialize_Xml();
        Assert.That(text.All(c => c < 128), Is.True);
        var read = new GH_Archive();
        read.Deserialize_Xml(text);
        var copy = new PrinterGoo();
        Assert.That(read.ExtractObject(copy, "Printer"), Is.True);
        Assert.That(copy.Value.Title, Is.EqualTo(title));
    }
}
