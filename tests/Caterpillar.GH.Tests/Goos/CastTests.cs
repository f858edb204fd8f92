using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Goos;

/// <summary>What turns into what on a wire.</summary>
[Category("Host")]
public sealed class CastTests
{
    private static readonly PrintPath Path = new([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2)], new Bead(0.08));

    private static readonly object[] Wrappable =
    [
        new object[] { new PrintPathGoo(), Path },
        new object[] { new StepGoo(), Path },
        new object[] { new BeadGoo(), new Bead(0.1) },
        new object[] { new GCodeGoo(), "G28" },
        new object[] { new TurtleProgramGoo(), "forward 1" },
        new object[] { new PrinterGoo(), "generic" },
        new object[] { new MaterialGoo(), new Material() },
        new object[] { new SettingsGoo(), new PrintSettings() },
    ];

    [TestCaseSource(nameof(Wrappable))]
    public void What_a_script_hands_out_is_unwrapped(IGH_Goo goo, object value)
    {
        Assert.That(goo.CastFrom(new GH_ObjectWrapper { Value = value }), Is.True);
        Assert.That(goo.IsValid, Is.True);
        Assert.That(goo.CastFrom(new GH_ObjectWrapper { Value = new GH_ObjectWrapper { Value = this } }), Is.False);
    }

    [Test]
    public void Text_that_cannot_be_read_is_answered_as_in_the_terminal()
    {
        var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", Path).Feed("Setup", "ender 3").Solve();
        Assert.That(plan.Errors, Has.One.Matches<string>(e => e.StartsWith("Setup: ") && e.Contains("\"ender 3\"") && e.Contains("id you mean ender3?")));
        Assert.That(plan.All("Toolpath"), Is.EqualTo(new object?[] { null }));
        var path = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rhino.Geometry.LineCurve(default, new Rhino.Geometry.Point3d(9, 0, 0)));
        Assert.That(path.Feed("Role", "wall").Solve().Errors, Has.One.StartsWith("Role has no choice \"wall\". Choose one of: Unspecified, Outer Wall, Inner"));
        Assert.That(path.All("Print Path"), Is.EqualTo(new object?[] { null }));
        Assert.That(path.Feed("Role", "outter wall").Solve().Errors, Has.One.EqualTo("Role has no choice \"outter wall\". Did you mean 'Outer Wall'?"));
        Assert.That(path.Feed("Role", "outer wall", "2").Solve().Errors, Is.Empty);
        Assert.That(path.All("Print Path").Cast<PrintPath>().Select(p => p.Role), Is.EqualTo(new[] { Role.OuterWall, Role.InnerWall }));
        var bead = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rhino.Geometry.LineCurve(default, new Rhino.Geometry.Point3d(9, 0, 0)));
        Assert.That(bead.Feed("Bead", "0.5 x 0.3", "wide").Solve().Errors, Has.One.EqualTo("Bead: This is not a bead. Use a width in mm, or width x height: "
            + "0.5 x 0.2."));
        Assert.That(bead.All("Print Path").Select(p => p is null), Is.EqualTo(new[] { false, true }));
    }

    [Test]
    public void A_toolpath_is_unwrapped_too()
    {
        var toolpath = Planner.Plan([Path], new PrintSetup()).Value!;
        var goo = new ToolpathGoo();
        Assert.That(goo.CastFrom(new GH_ObjectWrapper { Value = toolpath }), Is.True);
        Assert.That(goo.Value, Is.SameAs(toolpath));
    }

    [Test]
    public void An_extracted_choice_takes_the_names_of_its_port()
    {
        var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", Path).Feed("Setup", "generic");
        var archive = new GH_Archive();
        archive.AppendObject(plan.Input("Mode"), "Param");
        var read = new GH_Archive();
        read.Deserialize_Xml(archive.Serialize_Xml());
        var stored = new ChoiceParam();
        read.ExtractObject(stored, "Param");
        Assert.That(stored.Choices.Select(c => c.Key), Is.EqualTo(new[] { "Printer", "As Drawn" }), "From the file.");
        foreach (var extracted in new[] { stored, new ChoiceParam() })
        {
            plan.Document.AddObject(extracted, false);
            plan.Input("Mode").RemoveAllSources();
            plan.Input("Mode").AddSource(extracted);
            extracted.RemoveAllSources();
            var text = new Grasshopper.Kernel.Parameters.Param_String();
            text.SetPersistentData("as drawn");
            plan.Document.AddObject(text, false);
            extracted.AddSource(text);
            plan.Document.NewSolution(true);
            Assert.That(plan.Errors, Is.Empty);
            Assert.That(plan.One<Toolpath>("Toolpath").Moves().Select(m => m.Kind), Has.None.EqualTo(MoveKind.Retract));
        }
    }
}
