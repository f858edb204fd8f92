using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

/// <summary>Numbers by role, by height and by temperature, and keys from the command line.</summary>
[Category("Arithmetic")]
public class RoleAndRangeTests
{
    private static readonly PrintSettings Own = new()
    {
        OuterWallAcceleration = 1000, InnerWallAcceleration = 1100, InfillAcceleration = 1200, SolidInfillAcceleration = 1300,
        TopSurfaceAcceleration = 1400, BridgeAcceleration = 1500, SupportAcceleration = 1600, FirstLayerAcceleration = 1250,
        OuterWallJerk = 5, InnerWallJerk = 6, InfillJerk = 7, TopSurfaceJerk = 4, FirstLayerJerk = 6.5,
    };

    [TestCase(Role.OuterWall, 1000, 1000, 5, 5)]
    [TestCase(Role.OverhangWall, 1000, 1000, 5, 5)]
    [TestCase(Role.InnerWall, 1100, 1100, 6, 6)]
    [TestCase(Role.GapFill, 1100, 1100, 6, 6)]
    [TestCase(Role.Infill, 1200, 1200, 7, 6.5)]
    [TestCase(Role.SolidInfill, 1300, 1250, 7, 6.5)]
    [TestCase(Role.BottomSurface, 1300, 1250, 7, 6.5)]
    [TestCase(Role.TopSurface, 1400, 1250, 4, 4)]
    [TestCase(Role.Ironing, 1400, 1250, 4, 4)]
    [TestCase(Role.Bridge, 1500, 1250, 9, 6.5)]
    [TestCase(Role.Support, 1600, 1250, 9, 6.5)]
    [TestCase(Role.SupportInterface, 1600, 1250, 9, 6.5)]
    [TestCase(Role.Skirt, 2000, 1250, 9, 6.5)]
    public void Each_role_has_its_acceleration_and_jerk(Role role, double acceleration, double first, double jerk, double firstJerk)
    {
        Assert.That((Own.AccelerationOf(role, false, 2000), Own.AccelerationOf(role, true, 2000)), Is.EqualTo((acceleration, first)));
        Assert.That((Own.JerkOf(role, false, 9), Own.JerkOf(role, true, 9)), Is.EqualTo((jerk, firstJerk)));
        // The least value is a value, too.
        var least = Own with { SolidInfillAcceleration = 1, TopSurfaceAcceleration = 1 };
        Assert.That((least.AccelerationOf(Role.SolidInfill, false, 2000), least.AccelerationOf(Role.TopSurface, false, 2000)), Is.EqualTo((1, 1)));
        var plain = new PrintSettings();
        Assert.That((plain.AccelerationOf(role, true, 2000), plain.JerkOf(role, true, 9)), Is.EqualTo((2000.0, 9.0)));
    }

    [TestCase(Role.TopSurface, 1000)]
    [TestCase(Role.SolidInfill, 1200)]
    [TestCase(Role.BottomSurface, 1200)]
    public void A_role_without_a_number_has_that_of_a_similar_one(Role role, double acceleration)
        => Assert.That((Own with { TopSurfaceAcceleration = 0, SolidInfillAcceleration = 0 }).AccelerationOf(role, false, 2000), Is.EqualTo(acceleration));

    [TestCase(Role.OuterWall, 1)]
    [TestCase(Role.InnerWall, 1)]
    [TestCase(Role.OverhangWall, 1)]
    [TestCase(Role.GapFill, 1)]
    [TestCase(Role.Infill, 2)]
    [TestCase(Role.SolidInfill, 3)]
    [TestCase(Role.TopSurface, 3)]
    [TestCase(Role.BottomSurface, 3)]
    [TestCase(Role.Bridge, 3)]
    [TestCase(Role.Ironing, 3)]
    [TestCase(Role.Support, 4)]
    [TestCase(Role.Raft, 4)]
    [TestCase(Role.SupportInterface, 5)]
    [TestCase(Role.Skirt, 0)]
    public void Each_role_has_its_tool(Role role, int tool)
    {
        var settings = new PrintSettings { WallTool = 1, InfillTool = 2, SolidInfillTool = 3, SupportTool = 4, SupportInterfaceTool = 5 };
        Assert.That(settings.ToolOf(role), Is.EqualTo(tool));
        Assert.That(new PrintSettings { PartTool = 7 }.ToolOf(role), Is.EqualTo(7));
        Assert.That(settings.Tools.OrderBy(t => t), Is.EqualTo(new[] { 0, 1, 2, 3, 4, 5 }));
        Assert.That(new PrintSettings().Tools, Is.EqualTo(new[] { 0 }));
        Assert.That((settings with { SupportInterfaceTool = -1 }).ToolOf(Role.SupportInterface), Is.EqualTo(4));
    }

    [TestCase(0, 1)]
    [TestCase(5, 1)]
    [TestCase(5.001, 2)]
    [TestCase(9, 2)]
    [TestCase(9.5, 3)]
    public void Tools_of_a_part_change_above_heights(double top, int tool)
    {
        var settings = new PrintSettings { PartTool = 1, ToolChanges = new([new ToolChange(5, 2), new ToolChange(9, 3)]) };
        Assert.That(settings.ToolOf(Role.OuterWall, top), Is.EqualTo(tool));
    }

    [TestCase(150, 5)]
    [TestCase(200, 5)]
    [TestCase(210, 7)]
    [TestCase(220, 9)]
    [TestCase(230, 10)]
    [TestCase(240, 11)]
    [TestCase(300, 11)]
    public void The_flow_of_a_material_is_on_lines_between_its_limits(double temperature, double flow)
        => Assert.That(FlowLimit.At(new([new(200, 5), new(220, 9), new(240, 11)]), temperature), Is.EqualTo(flow).Within(1e-12));

    [Test]
    public void Lists_must_ascend_and_ranges_must_not_overlap()
    {
        Assert.That(FlowLimit.Problem(new([new(200, 5), new(220, 9)])), Is.Null);
        Assert.That(FlowLimit.Problem(new([new(200, 5), new(200, 9)])), Is.EqualTo("must have ascending temperatures"));
        Assert.That(LayerRange.Problem(new([new(0, 5, 0.1), new(5, 9, 0.2), new(-3, 0, 0.001)])), Is.Null);
        Assert.That(LayerRange.Problem(new([new(5, 5, 0.1)])), Is.EqualTo("must go upward, not from 5 to 5 mm"));
        Assert.That(LayerRange.Problem(new([new(0, 5, 0.0009)])), Does.Contain("at least 0.001 mm"));
        Assert.That(LayerRange.Problem(new([new(0, 5, 0.1), new(6, 9, 0.1), new(4, 7, 0.1)])), Is.EqualTo("has two ranges for 4 to 5 mm"));
        OverhangClass usual = new(50, 30, 100, 1);
        Assert.That(OverhangClass.Problem(new([usual, usual with { Percent = 100 }])), Is.Null);
        Assert.That(OverhangClass.Problem(new([usual, usual])), Is.EqualTo("must have ascending percentages"));
        Assert.That(OverhangClass.Problem(new([usual with { Percent = 101 }])), Is.EqualTo("must have percentages up to 100"));
        Assert.That(OverhangClass.Problem(new([usual with { MinFanSpeedPercent = 101 }])), Is.EqualTo("must have percentages up to 100"));
        Assert.That(OverhangClass.Problem(new([usual with { Flow = 0 }])), Is.EqualTo("must have flow ratios above 0"));
    }

    [Test]
    public void A_round_bed_ends_at_its_circle_and_a_centered_one_reaches_to_both_sides()
    {
        var round = new Printer { BedShape = BedShape.Round, Origin = BedOrigin.Center, BuildVolume = new Vec3(200, 100, 300) };
        Assert.That(round.BuildBounds, Is.EqualTo(new Bounds(new Vec3(-100, -50, 0), new Vec3(100, 50, 300))));
        Assert.That(round.CanReach(new Vec3(0, 50, 1)) && round.CanReach(new Vec3(-100, 0, 300)) && round.CanReach(new Vec3(60, 40, 1)), Is.True);
        Assert.That(round.CanReach(new Vec3(61, 40, 1)) || round.CanReach(new Vec3(-61, -40, 1)) || round.CanReach(new Vec3(0, 0, 301)), Is.False);
        Assert.That(round.CanReach(new Vec3(61, 40, 1), 2), Is.True);
        Assert.That((round with { BedShape = BedShape.Rectangle }).CanReach(new Vec3(99, 49, 1)), Is.True);
        Assert.That(new Printer().BuildBounds.Min, Is.EqualTo(Vec3.Zero));
    }

    [TestCase(0.5, 0.6, 0.45, true, 0.6)]
    [TestCase(0.5, 0.6, 0.45, false, 0.45)]
    [TestCase(0.5, 0, 0.45, true, 0.45)]
    [TestCase(0.5, 0, 0, true, 0.5)]
    public void Extrusions_of_the_first_layer_have_its_width(double line, double first, double own, bool isFirst, double width)
        => Assert.That(new PrintSettings { LineWidth = line, FirstLayerLineWidth = first }.WidthOf(own, isFirst), Is.EqualTo(width));

    [TestCase("jerk", 8, 12, 8)]
    [TestCase("jerk", 12, 8, 8)]
    [TestCase("junction_deviation", 8, 12, null)]
    public void Jerk_is_commanded_up_to_the_smaller_limit_of_both_axes(string cornering, double x, double y, double? most)
    {
        var kind = cornering == "jerk" ? Cornering.Jerk : Cornering.JunctionDeviation;
        var printer = new Printer { Cornering = kind, Jerk = new(x, y, 1, 1), MaxAcceleration = new(3000, 1100.5, 100, 5000) };
        var motion = new CommandedMotion(new PrintSetup { Printer = printer, Settings = Own with { TravelMoveJerk = 99, TravelMoveAcceleration = 5000 } });
        Assert.That((motion.MostJerk, motion.TravelJerk), Is.EqualTo((most, most)));
        Assert.That(motion.Jerk(Role.OuterWall, false), Is.EqualTo(most is null ? null : 5.0));
        Assert.That((motion.MostAcceleration, motion.TravelAcceleration), Is.EqualTo(((double?)1100.5, (double?)1100)));
        Assert.That(motion.Acceleration(Role.Bridge, false), Is.EqualTo(1100));
        Assert.That(motion.Acceleration(Role.OuterWall, false), Is.EqualTo(1000));
        var none = new CommandedMotion(new PrintSetup { Printer = printer });
        Assert.That(new[] { none.MostAcceleration, none.MostJerk, none.TravelAcceleration, none.TravelJerk }, Is.All.Null);
    }

    private static PrintSetup TwoTools => new() { ToolMaterials = new([new Material { NozzleTemperature = 190 }]) };

    [TestCase("nozzle_temperature_c=230", 230, 230)]
    [TestCase("nozzle_temperature_c[0]=230", 230, 190)]
    [TestCase("nozzle_temperature_c[1]=230", 205, 230)]
    [TestCase(" nozzle_temperature_c[1] = 230", 205, 230)]
    public void A_value_of_a_material_is_for_all_tools_or_for_one(string entry, double first, double second)
    {
        var setup = SetupValues.Apply(TwoTools with { Material = new Material { NozzleTemperature = 205 } }, [entry]).OrThrow();
        Assert.That((setup.Material.NozzleTemperature, setup.ToolMaterials[0].NozzleTemperature), Is.EqualTo((first, second)));
    }

    [TestCase("nozzle_temperature_c[2]=230", "profile.unknown_key")]
    [TestCase("layer_height_mm[1]=0.2", "profile.unknown_key")]
    [TestCase("title=a", "profile.unknown_key")]
    [TestCase("title[1]=a", "profile.unknown_key")]
    [TestCase("layer_height_mm", "profile.no_value")]
    [TestCase("layer_hight_mm=0.2", "profile.unknown_key")]
    public void A_value_that_belongs_nowhere_is_an_error(string entry, string code)
        => Assert.That(SetupValues.Apply(TwoTools, [entry]).Diagnostics.Single().Code, Is.EqualTo(code));

    [TestCase("print_speed_mm_s=150%", 90)]
    [TestCase("print_speed_mm_s=150 %", 90)]
    [TestCase("print_speed_mm_s=70", 70)]
    public void Speeds_take_percents_of_what_they_are(string entry, double speed)
    {
        var setup = new PrintSetup { Settings = new PrintSettings { PrintSpeed = 60 } };
        Assert.That(SetupValues.Apply(setup, [entry]).OrThrow().Settings.PrintSpeed, Is.EqualTo(speed));
    }

    [Test]
    public void Presets_of_a_bundle_inherit_and_later_parents_win()
    {
        const string Bundle = "# a comment\n;x = 1\n[printer:A]\na = 1\nb = 1\n[printer:B]\nb = 2\nc=2\n"
            + "[printer:C]\ninherits = A; \"B\"; D\nc = 3\n= 4\n[other]\nd = 5\n[printer:*E*]\na = 9\n";
        var problems = new List<Diagnostic>();
        var presets = IniPresets.Read(Bundle, "a.ini", problems);
        Assert.That(presets.Select(p => p.Kind + ":" + p.Name + (p.IsBase ? " base" : "")),
            Is.EqualTo(new[] { ":", "printer:A", "printer:B", "printer:C", "printer:*E* base" }));
        Assert.That(presets[3].Values.Where(v => v.Key != "inherits").OrderBy(v => v.Key).Select(v => v.Key + v.Value),
            Is.EqualTo(new[] { "a1", "b2", "c3" }));
        Assert.That(problems.Select(p => (p.Code, p.Source!.Line)), Is.EqualTo(new[] { ("import.no_parent", (int?)9) }));
    }

    [Test]
    public void Presets_without_letters_get_names_of_their_own()
    {
        const string Bundle = "[printer:!!!]\nnozzle_diameter = 0.6\n[printer:???]\nnozzle_diameter = 0.8\n[printer:A B]\nnozzle_diameter = 0.3\n";
        var made = Caterpillar.Jobs.ProfileImport.Read(System.Text.Encoding.UTF8.GetBytes(Bundle), null, "x", fileName: "a.ini").OrThrow();
        Assert.That(made.Printers.Select(p => p.Name), Is.EqualTo(new[] { "imported", "imported_2", "a_b" }));
    }

    [TestCase("a = 1", true)]
    [TestCase("; note\n[print:A]\nb = 2", true)]
    [TestCase("G1 X1\na = 1", false)]
    [TestCase("= 1", false)]
    [TestCase("a b = 1", false)]
    [TestCase("; only a note", false)]
    [TestCase("", false)]
    public void Sections_and_assignments_make_an_ini_file(string text, bool isIni) => Assert.That(IniPresets.IsIni(text), Is.EqualTo(isIni));

    [TestCase(40)]
    [TestCase(41)]
    public void Long_texts_are_cut_in_messages(int length)
        => Assert.That(KeyFormat.Describe(new string('a', length)), Is.EqualTo("the text \"" + new string('a', 40) + (length > 40 ? "…\"" : "\"")));
}
