using System;
using System.IO;
using System.Linq;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Components.Design;
using Caterpillar.Geometry;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Host;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Goos;

/// <summary>Native geometry, numbers and texts at the ports of the plug-in, and its data at native ports.</summary>
[Category("Host")]
public sealed class NativeCastTests
{
    private static readonly Rg.Plane Flat = new(new Rg.Point3d(10, 20, 0.2), Rg.Vector3d.XAxis, Rg.Vector3d.YAxis);
    private static readonly PrintPath Straight = new([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2)], new Bead(0.08));

    private static readonly object[] Curves =
    [
        new object[] { new Rg.LineCurve(new Rg.Point3d(0, 0, 0), new Rg.Point3d(10, 0, 0)), 10.0 },
        new object[] { new Rg.Line(new Rg.Point3d(0, 0, 0), new Rg.Point3d(0, 0, 5)), 5.0 },
        new object[] { new Rg.Polyline([new Rg.Point3d(0, 0, 0), new Rg.Point3d(3, 0, 0), new Rg.Point3d(3, 4, 0)]), 7.0 },
        new object[] { new Rg.Arc(Flat, 5, Math.PI), 5 * Math.PI },
        new object[] { new Rg.Circle(Flat, 5), 10 * Math.PI },
    ];

    private static PrintPath Circle(double sweep) => new([new Vec3(5, 0, 0.2), new Vec3(5, 0, 0.2)], [new Bead(0.08)], false,
        [new Arc(new Vec3(0, 0, 0.2), sweep)]);

    private static T To<T>(IGH_Goo goo)
    {
        Assert.That(goo.CastTo(out T made), Is.True, typeof(T).Name);
        return made;
    }

    private static bool Can<T>(IGH_Goo goo) => goo.CastTo(out T _);

    [TestCaseSource(nameof(Curves))]
    public void Anything_that_is_a_curve_can_be_printed(object curve, double length)
    {
        foreach (var source in new[] { curve, new GH_ObjectWrapper { Value = curve } })
        {
            var goo = new PrintPathGoo();
            Assert.That(goo.CastFrom(source), Is.True);
            Assert.That(goo.Value.Length, Is.EqualTo(length).Within(0.06), "Curves are divided into chords of 1 mm.");
            Assert.That(goo.Value.BeadOf(0).Height, Is.EqualTo(0.2));
        }
        var canvas = new Canvas<PlanToolpathComponent>().Feed("Steps", curve).Feed("Setup", "generic").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(ToolpathTotals.Of(canvas.One<Toolpath>("Toolpath")).PrintLength, Is.EqualTo(length).Within(0.06));
    }

    [Test]
    public void A_curve_at_a_port_is_the_path_that_Construct_Print_Path_makes_of_it()
    {
        var arc = new Rg.Arc(Flat, 5, Math.PI);
        var made = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rg.ArcCurve(arc)).Solve().One<PrintPath>("Print Path");
        var cast = new PrintPathGoo();
        cast.CastFrom(arc);
        Assert.That(cast.Value.Points, Is.EqualTo(made.Points));
        Assert.That(cast.Value.BeadOf(0), Is.EqualTo(made.BeadOf(0)));
    }

    [Test]
    public void What_is_no_curve_is_refused()
    {
        Assert.That(new PrintPathGoo().CastFrom(Shapes.Box()), Is.False);
        Assert.That(new PrintPathGoo().CastFrom("text"), Is.False);
        Assert.That(new PrintPathGoo().CastFrom(new Rg.PolylineCurve([Rg.Point3d.Origin, Rg.Point3d.Origin])), Is.False, "It has no length.");
        Assert.That(new Canvas<SortPathsComponent>().Feed("Print Paths", 5).Solve().Errors, Has.Some.Contains("Data conversion failed"));
    }

    [Test]
    public void A_path_is_a_line_polyline_or_curve()
    {
        var goo = new PrintPathGoo(Straight);
        Assert.That(To<GH_Line>(goo).Value.Length, Is.EqualTo(10));
        Assert.That(To<Rg.Line>(goo).To.X, Is.EqualTo(10));
        Assert.That(To<Rg.Polyline>(goo), Has.Count.EqualTo(2));
        Assert.That(To<GH_Curve>(goo).Value, Is.InstanceOf<Rg.PolylineCurve>());
        Assert.That(To<Rg.Curve>(goo).GetLength(), Is.EqualTo(10));
        Assert.That(Can<GH_Arc>(goo), Is.False);
        Assert.That(Can<GH_Circle>(goo), Is.False);
        Assert.That(Can<GH_Mesh>(goo), Is.False);
        var corner = new PrintPathGoo(new PrintPath([Vec3.Zero, new Vec3(1, 0), new Vec3(1, 1)], new Bead(0.08)));
        Assert.That(Can<GH_Line>(corner), Is.False);
    }

    [Test]
    public void Arcs_of_a_path_are_arcs_of_the_curve()
    {
        var half = new PrintPathGoo(new PrintPath([new Vec3(5, 0, 0.2), new Vec3(-5, 0, 0.2)], [new Bead(0.08)], false, [new Arc(new Vec3(0, 0, 0.2), -180)]));
        Assert.That(To<GH_Arc>(half).Value.AngleDegrees, Is.EqualTo(180).Within(1e-9));
        Assert.That(To<Rg.Arc>(half).EndPoint.X, Is.EqualTo(-5).Within(1e-9));
        Assert.That(To<Rg.Arc>(half).PointAt(Math.PI / 2).Y, Is.EqualTo(-5).Within(1e-9), "Clockwise.");
        Assert.That(To<GH_Curve>(half).Value.GetLength(), Is.EqualTo(5 * Math.PI).Within(1e-6));
        Assert.That(Can<GH_Circle>(half), Is.False);
        var full = new PrintPathGoo(Circle(360));
        Assert.That(To<GH_Circle>(full).Value.Radius, Is.EqualTo(5));
        Assert.That(To<Rg.Circle>(full).Center.Z, Is.EqualTo(0.2));
    }

    [Test]
    public void Native_parameters_take_paths_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var param = new Param_Curve();
        param.AddVolatileData(new Grasshopper.Kernel.Data.GH_Path(0), 0, new PrintPathGoo(Straight));
        Assert.That(((GH_Curve)param.VolatileData.get_Branch(0)[0]!).Value.GetLength(), Is.EqualTo(1));
        var back = new PrintPathGoo();
        Assert.That(back.CastFrom(param.VolatileData.get_Branch(0)[0]!), Is.True);
        Assert.That(back.Value.Length, Is.EqualTo(10).Within(1e-9));
    }

    [Test]
    public void A_toolpath_is_the_course_of_the_head_or_a_mesh_of_what_it_prints()
    {
        var toolpath = Planner.Plan([Straight], new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn }).Value!;
        var goo = new ToolpathGoo(toolpath);
        Assert.That(To<GH_Curve>(goo).Value.PointAtEnd.X, Is.EqualTo(10));
        var mesh = To<GH_Mesh>(goo).Value;
        Assert.That(mesh.GetBoundingBox(true).Max.X, Is.EqualTo(10).Within(0.5));
        Assert.That(To<Rg.Mesh>(goo).Faces.Count, Is.EqualTo(mesh.Faces.Count));
        Assert.That(Can<GH_Number>(goo), Is.False);
        var extrusions = new Canvas<DeconstructToolpathComponent>().Feed("Toolpath", goo).Solve();
        Assert.That(extrusions.All("Extrusions").Cast<Rg.Curve>().Single().GetLength(), Is.EqualTo(10).Within(1e-9));
    }

    [TestCase("0.6", 0.6, 0.2)]
    [TestCase("0.6 x 0.3", 0.6, 0.3)]
    [TestCase("0.6×0.3", 0.6, 0.3)]
    [TestCase("0.6, 0.3", 0.6, 0.3)]
    public void Text_is_the_width_and_height_of_a_bead(string text, double width, double height)
    {
        var goo = new BeadGoo();
        Assert.That(goo.CastFrom(text), Is.True);
        Assert.That(goo.Value, Is.EqualTo(Bead.FromWidth(width, height, shape: BeadShape.Stadium)));
    }

    [Test]
    public void A_number_is_the_width_of_a_bead()
    {
        foreach (var number in new object[] { 0.6, new GH_Number(0.6), new GH_ObjectWrapper { Value = 0.6 } })
        {
            var goo = new BeadGoo();
            Assert.That(goo.CastFrom(number), Is.True);
            Assert.That(goo.Value, Is.EqualTo(Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium)));
        }
        foreach (var wrong in new object[] { -1.0, 0.1, double.NaN, "wide", "0.5 x", "1 x 2 x 3", "0.1 x 0.3" })
        {
            var goo = new BeadGoo();
            Assert.That(goo.CastFrom(wrong), Is.EqualTo(Equals(wrong, "0.5 x")), wrong.ToString());
        }
        var canvas = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rg.Line(Rg.Point3d.Origin, new Rg.Point3d(9, 0, 0))).Feed("Bead", 0.8).Solve();
        Assert.That(canvas.One<PrintPath>("Print Path").BeadOf(0).Width(BeadShape.Stadium), Is.EqualTo(0.8).Within(1e-9));
    }

    [Test]
    public void Text_at_a_G_code_port_is_G_code_or_the_path_of_a_file()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        File.WriteAllText(file, "G28\nG1 X5 F3000\n");
        try
        {
            var goo = new GCodeGoo();
            Assert.That(goo.CastFrom(file), Is.True);
            Assert.That(goo.Value.ToBytes(), Has.Length.EqualTo(16));
        }
        finally
        {
            File.Delete(file);
        }
        foreach (var text in new[] { "G28", file, "G1 X5\nG1 X6", "", new string('G', 2000) })
        {
            var goo = new GCodeGoo();
            Assert.That(goo.CastFrom(text), Is.True);
            Assert.That(System.Text.Encoding.UTF8.GetString(goo.Value.ToBytes()), Is.EqualTo(text));
        }
    }

    [Test]
    public void A_definition_keeps_beads_and_scripts()
    {
        var bead = Kept<BeadParam, BeadGoo>("0.6 x 0.3");
        Assert.That(bead.Value, Is.EqualTo(Bead.FromWidth(0.6, 0.3, shape: BeadShape.Stadium)));
        var program = Kept<TurtleProgramParam, TurtleProgramGoo>("repeat 4 [ forward 10; left 90 ] # π 🐛");
        Assert.That(program.Value.Description, Is.EqualTo("Script of 1 lines"));
        var canvas = new Canvas<TurtleComponent>();
        canvas.Document.AddObject(Floating<TurtleProgramParam, TurtleProgramGoo>("forward 7"), false);
        canvas.Input("Program").AddSource((IGH_Param)canvas.Document.Objects.Last());
        Assert.That(canvas.Solve().All("Print Paths").Cast<PrintPath>().Single().Length, Is.EqualTo(7));
    }

    [Test]
    public void Solids_of_every_kind_are_models()
    {
        var (mesh, brep, box) = (Shapes.Box(), Shapes.Solid(), new Rg.Box(new Rg.BoundingBox(100, 100, 0, 110, 110, 2)));
        var volumes = new object[] { mesh, brep, box }.Select(model => new Canvas<PlanarSlicerComponent>().Feed("Geometry", model).Solve()
            .All("Print Paths").Cast<PrintPath>().Sum(p => p.Volume)).ToArray();
        Assert.That(volumes, Is.All.EqualTo(volumes[0]).Within(1e-6));
    }

    private static TParam Floating<TParam, TGoo>(string text)
        where TParam : GH_PersistentParam<TGoo>, new()
        where TGoo : class, IGH_Goo
    {
        var param = new TParam();
        param.SetPersistentData(text);
        return param;
    }

    private static TGoo Kept<TParam, TGoo>(string text)
        where TParam : GH_PersistentParam<TGoo>, new()
        where TGoo : class, IGH_Goo
    {
        var archive = new GH_Archive();
        archive.AppendObject(Floating<TParam, TGoo>(text), "Param");
        var written = archive.Serialize_Xml();
        Assert.That(written, Does.Contain("Version"));
        var read = new GH_Archive();
        read.Deserialize_Xml(written);
        var copy = new TParam();
        Assert.That(read.ExtractObject(copy, "Param"), Is.True);
        return (TGoo)copy.PersistentData.get_Branch(0)[0]!;
    }
}
