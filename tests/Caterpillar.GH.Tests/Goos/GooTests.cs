using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.GCode;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Goos;

[Category("Host")]
public sealed class GooTests
{
    private static readonly Bead Bead = new(0.08, 0.2, 40);

    private static PrintPath Path() => new([new Vec3(0, 0, 1), new Vec3(10, 0, 1), new Vec3(10, 10, 1)], Bead) { Role = Role.OuterWall };

    private static PrintPath Turn() => new([new Vec3(10, 0, 1), new Vec3(-10, 0, 1)], [Bead], false, [new Arc(new Vec3(0, 0, 1), 180)]);

    private static Toolpath Toolpath()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0, 1), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, -1);
        builder.Add(new Vec3(20, 0, 1), 1, 1, 40, MoveKind.Print, Role.Infill, -1, 0, 0);
        builder.Add(new Vec3(20, 10, 1), 1, 1, 40, MoveKind.Print, Role.Infill, -1, 0, 0);
        builder.Add(new Vec3(0, 0, 5), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, -1);
        builder.Add(new Vec3(0, 30, 5), 2, 2, 40, MoveKind.Print, Role.Infill, -1, 0, 1);
        return builder.Build([new ToolpathTool(2.4)]);
    }

    private static readonly IGH_Goo[] Empty = [new PrintPathGoo(), new ToolpathGoo(), new PrinterGoo(), new MaterialGoo(), new SettingsGoo(), new GCodeGoo(),
        new StepGoo()];

    private static readonly IGH_Goo[] Full =
    [
        new PrintPathGoo(Path()), new ToolpathGoo(Toolpath()), new PrinterGoo { Value = new Printer() }, new MaterialGoo { Value = new Material() },
            new SettingsGoo { Value = new PrintSettings() },
        new GCodeGoo { Value = GCodeDocument.FromText("G28\n") }, new StepGoo(Path()),
    ];

    [TestCaseSource(nameof(Empty))]
    public void Goo_without_a_value_is_not_valid_and_harmless(IGH_Goo goo)
    {
        Assert.That(goo.IsValid, Is.False);
        Assert.That(goo.IsValidWhyNot, Is.Not.Empty);
        Assert.That(goo.ToString(), Does.StartWith("No "));
        Assert.That(goo.ScriptVariable(), Is.Null);
        Assert.That(goo.Duplicate().IsValid, Is.False);
        Assert.That(goo.CastTo<string>(out _), Is.False);
        Assert.That(goo.CastFrom(null!), Is.False);
        Assert.That(goo.CastFrom(1.0), Is.False, "A number is not one of these values.");
    }

    [TestCaseSource(nameof(Full))]
    public void Goo_with_a_value_describes_it_and_copies_share_it(IGH_Goo goo)
    {
        Assert.That(goo.IsValid && goo.IsValidWhyNot.Length == 0, Is.True);
        Assert.That(goo.TypeName, Is.Not.Empty);
        Assert.That(goo.TypeDescription, Does.EndWith("."));
        Assert.That(goo.ToString(), Does.Not.StartWith("No "));
        var copy = goo.Duplicate();
        Assert.That(copy, Is.TypeOf(goo.GetType()).And.Not.SameAs(goo));
        Assert.That(copy.ScriptVariable(), Is.SameAs(goo.ScriptVariable()));
        var other = (IGH_Goo)Activator.CreateInstance(goo.GetType())!;
        Assert.That(other.CastFrom(goo) && ReferenceEquals(other.ScriptVariable(), goo.ScriptVariable()), Is.True, "from goo");
        Assert.That(((IGH_Goo)Activator.CreateInstance(goo.GetType())!).CastFrom(goo.ScriptVariable()), Is.True, "from the bare value");
    }

    [Test]
    public void A_print_path_is_a_curve_for_native_components()
    {
        IGH_Goo goo = new PrintPathGoo(Turn());
        Assert.That(goo.CastTo<GH_Curve>(out var curve), Is.True);
        Assert.That(curve.Value.GetLength(), Is.EqualTo(Turn().Length).Within(0.01));
        Assert.That(goo.CastTo<Rg.Curve>(out var bare) && bare.IsValid, Is.True);
        var param = new Param_Curve();
        Assert.That(param.AddVolatileData(new Grasshopper.Kernel.Data.GH_Path(0), 0, goo), Is.True);
        Assert.That(new PrintPathParam().AddVolatileData(new Grasshopper.Kernel.Data.GH_Path(0), 0, curve), Is.True);
    }

    [Test]
    public void Moving_a_path_keeps_its_group_and_its_source()
    {
        var step = new PathStep(Path(), new StepGroup(2, 1, 3)) { KeepStart = true, Joined = true, Source = new SourceLocation(Line: 7) };
        var goo = new PrintPathGoo(step);
        Assert.That((goo.ToStep(), ((PrintPathGoo)goo.Duplicate()).ToStep()), Is.EqualTo((step, step)));
        var moved = (PrintPathGoo)goo.Transform(Rg.Transform.Translation(1, 2, 3))!;
        Assert.That(moved.Value.Start, Is.EqualTo(new Vec3(1, 2, 4)));
        Assert.That(goo.Value.Start, Is.EqualTo(new Vec3(0, 0, 1)), "The value is shared and must not change.");
        var after = moved.ToStep();
        Assert.That((after.Group, after.KeepStart, after.Joined, after.Source), Is.EqualTo((step.Group, true, true, step.Source)));
        Assert.That(moved.Boundingbox.Max, Is.EqualTo(new Rg.Point3d(11, 12, 4)));
        Assert.That(goo.GetBoundingBox(Rg.Transform.Translation(1, 2, 3)).Max, Is.EqualTo(new Rg.Point3d(11, 12, 4)));
    }

    [Test]
    public void A_move_is_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var moved = (PrintPathGoo)new PrintPathGoo(Path()).Transform(Rg.Transform.Translation(1, 0, 0))!;
        Assert.That(moved.Value.Start.DistanceTo(new Vec3(10, 0, 1)), Is.LessThan(1e-12));
        Assert.That(moved.Boundingbox.Min.X, Is.EqualTo(1).Within(1e-12));
    }

    [Test]
    public void Morphing_a_path_moves_its_points()
    {
        var bent = (PrintPathGoo)new PrintPathGoo(Turn()).Morph(new Lift())!;
        Assert.That(bent.Value.HasArcs, Is.False);
        Assert.That(bent.Value.Points.Select(p => p.Z - p.X), Has.All.EqualTo(1).Within(1e-9));
    }

    private sealed class Lift : Rg.SpaceMorph
    {
        public override Rg.Point3d MorphPoint(Rg.Point3d point) => new(point.X, point.Y, point.Z + point.X);
    }

    [Test]
    public void A_scaled_toolpath_prints_as_much_more_and_stays_planned_for_its_printer()
    {
        var setup = new PrintSetup();
        var scaled = (ToolpathGoo)new ToolpathGoo(Toolpath(), setup).Transform(Rg.Transform.Scale(Rg.Point3d.Origin, 2))!;
        Assert.That(ToolpathTotals.Of(scaled.Value).DepositedE, Is.EqualTo(4 * 8).Within(1e-12), "Twice as long, wide and high.");
        Assert.That(scaled.Setup, Is.SameAs(setup));
        Assert.That(((ToolpathGoo)scaled.Duplicate()).Setup, Is.SameAs(setup));
        Assert.That(scaled.Boundingbox.Max, Is.EqualTo(new Rg.Point3d(40, 60, 10)));
    }

    [Test]
    public void Morphing_a_toolpath_moves_what_it_prints()
    {
        var bent = (ToolpathGoo)new ToolpathGoo(Toolpath(), new PrintSetup()).Morph(new Lift())!;
        var before = Toolpath().Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        var after = bent.Value.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(after.Select(m => m.End), Is.EqualTo(before.Select(m => m.End.WithZ(m.End.Z + m.End.X))));
        Assert.That(after.Sum(m => m.Length), Is.GreaterThan(before.Sum(m => m.Length)));
    }

    [Test]
    public void Names_of_profiles_are_printers_materials_and_settings_at_their_ports_only()
    {
        Assert.That(new PrinterGoo().CastFrom("ender3") && new MaterialGoo().CastFrom(new GH_String("petg"))
            && new SettingsGoo().CastFrom("standard"), Is.True);
        Assert.That(new PrinterGoo().CastFrom("toaster"), Is.False);
        Assert.That(new ToolpathGoo().CastFrom("G28") || new PrintPathGoo().CastFrom("wall") || new StepGoo().CastFrom("forward 10"), Is.False);
        Assert.That(new GCodeGoo().CastFrom("G28\nG1 X1"), Is.True);
    }

    [Test]
    public void Steps_hold_paths_travels_and_events()
    {
        IGH_Goo step = new StepGoo();
        Assert.That(step.CastFrom(new PrintPathGoo(new PathStep(Path(), new StepGroup(4)))), Is.True);
        Assert.That(((PathStep)step.ScriptVariable()).Group, Is.EqualTo(new StepGroup(4)));
        Assert.That(step.CastTo<PrintPathGoo>(out var path) && path.ToStep().Group == new StepGroup(4), Is.True);
        Assert.That(new StepGoo(new TravelStep(Vec3.Zero)).ToString(), Is.EqualTo("Travel (1 points)"));
        IGH_Goo travel = new StepGoo(new TravelStep(Vec3.Zero));
        Assert.That(travel.CastTo<PrintPathGoo>(out _), Is.False);
        Assert.That(new StepGoo().CastFrom(new DwellEvent(1)), Is.True);
    }

    [Test]
    public void Printers_materials_and_settings_are_kept_in_definitions()
    {
        var printer = new Printer { Name = "mine", Title = "Mine", BuildVolume = new Vec3(100, 90, 80),
            StartGCode = new ValueList<string>("G28", "; \"quoted\" ü") };
        Assert.That(Stored<PrinterParam, PrinterGoo>(new PrinterParam(), printer).Value, Is.EqualTo(printer));
        var material = new Material { Name = "clay", NozzleTemperature = 0, FilamentDiameter = 50 };
        Assert.That(Stored<MaterialParam, MaterialGoo>(new MaterialParam(), material).Value, Is.EqualTo(material));
        var settings = new PrintSettings { Name = "fine", LayerHeight = 0.1, WallCount = 5 };
        Assert.That(Stored<SettingsParam, SettingsGoo>(new SettingsParam(), settings).Value, Is.EqualTo(settings));
    }

    private static TGoo Stored<TParam, TGoo>(TParam param, object value)
        where TParam : StoredParam<TGoo>, new()
        where TGoo : class, IGH_Goo
    {
        param.SetPersistentData(value);
        var archive = new GH_Archive();
        archive.AppendObject(param, "Container");
        var read = new GH_Archive();
        read.Deserialize_Xml(archive.Serialize_Xml());
        var copy = new TParam();
        Assert.That(read.ExtractObject(copy, "Container"), Is.True);
        return copy.PersistentData.Branches.Single().Single();
    }

    [Test]
    public void A_damaged_profile_in_a_definition_gives_no_value()
    {
        var chunk = new GH_LooseChunk("Item");
        chunk.SetString("Name", "x");
        chunk.SetString("Profile", "{ \"build_volume_mm\": \"large\" }");
        Assert.That(new PrinterGoo().Read(chunk), Is.False);
    }
}
