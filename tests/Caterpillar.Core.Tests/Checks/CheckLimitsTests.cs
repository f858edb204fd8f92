using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Each check just below its limit, at it and just above; its severity, its place and its sentence.</summary>
public class CheckLimitsTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();
    private static readonly double Half = new Bead(SmallPrint.Area, 0.2).Width(new PrintSettings().BeadShape) / 2;

    [TestCase(220.001, 0)]
    [TestCase(220.0011, 1)]
    [TestCase(-0.001, 0)]
    [TestCase(-0.0011, 1)]
    public void The_bed_ends_at_its_edge(double x, int found) => Expect(new SmallPrint().Go(x, 10, 0.2), CheckCodes.Outside, found, 0);

    [TestCase(-0.001, 0)]
    [TestCase(-0.0011, 1)]
    public void The_bed_is_at_zero(double z, int found)
        => Expect(new SmallPrint().Go(20, 10, z), CheckCodes.Below, found, 0, found > 0 ? "A move goes to Z -0.001 mm, below the bed. Raise it." : null);

    [TestCase(100, 0)]
    [TestCase(100.002, 1)]
    public void Nothing_is_printed_on_excluded_areas(double x, int found)
    {
        var setup = SmallPrint.Setup(p => p with { ExcludedAreas = new(new Bounds(new Vec3(100, 50), new Vec3(120, 70))) });
        Expect(new SmallPrint(80, 60, 0.2).Print(x, 60, 0.2), CheckCodes.ExcludedArea, found, 0, null, setup);
        Expect(new SmallPrint(80, 60, 0.2).Go(110, 60, 0.2), CheckCodes.ExcludedArea, 0, 0, null, setup);
        Expect(new SmallPrint(80, 50, 0.2).Print(130, 50, 0.2), CheckCodes.ExcludedArea, 0, 0, null, setup);
        Expect(new SmallPrint(80, 60, 0.2).Print(130, 60, 0.2), CheckCodes.ExcludedArea, 1, 0, null, setup);
        Expect(new SmallPrint(110, 45, 0.2).Arc(110, 75, 0.2, new Vec3(110, 60), 180, 0.08), CheckCodes.ExcludedArea, 0, 0, null, setup);
        Expect(new SmallPrint(110, 45, 0.2).Arc(110, 65, 0.2, new Vec3(110, 55), 180, 0.08), CheckCodes.ExcludedArea, 1, 0, null, setup);
    }

    // 5 mm free and 60 mm between supports; 4 mm above the bed. Lying ends at the fresh extrusion's cells.
    [TestCase(5, 0)]
    [TestCase(5.6, 1)]
    public void An_extrusion_may_end_in_the_air_after_5_mm(double length, int found)
        => Expect(new SmallPrint(50, 50, 4).Print(50 + length, 50, 4).Go(80, 80, 4), CheckCodes.Unsupported, found, 0,
            found > 0 ? "An extrusion is in the air for 5.6 mm, with a free end. Add supports below it." : null);

    [TestCase(60, 0)]
    [TestCase(63, 1)]
    public void An_extrusion_may_span_60_mm(double span, int found)
    {
        var print = new SmallPrint().Wall(50, 50.4, 50, 2).Wall(50.4 + span, 50.8 + span, 50, 2).Go(50, 50, 20).Go(50, 50, 2.2);
        var bridge = print.Count;
        print.Print(50.8 + span, 50, 2.2);
        var bridges = SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported);
        Assert.That(bridges.Where(d => d.Message.EndsWith("two supports. Add supports below it.", StringComparison.Ordinal)).Select(d => d.Source!.Move),
            Is.EqualTo(Enumerable.Repeat((int?)bridge, found)));
    }

    [TestCase(0.5, 0)]
    [TestCase(0.52, 1)]
    public void An_extrusion_lies_on_what_is_within_two_layers_and_a_tenth(double z, int found)
        => Expect(new SmallPrint(50, 50, z).Print(70, 50, z), CheckCodes.Unsupported, found, 0);

    // An extrusion of 0.08 mm², a quarter of its width aside at most.
    [TestCase(0, 1)]
    [TestCase(0.1, 1)]
    [TestCase(0.12, 0)]
    public void The_same_place_printed_twice_is_found(double aside, int found)
        => Expect(new SmallPrint(50, 50, 0.2).Print(100, 50, 0.2).Go(100, 50, 5).Go(50, 50 + aside, 0.2).Print(100, 50 + aside, 0.2), CheckCodes.Duplicate,
            found,
            3,
            found > 0 ? "Extrusions are in the same place as earlier ones (move 0). Remove the duplicates." : null);

    [TestCase(20, 1, 0, 0)]
    [TestCase(21.5, 1, 0, 1)]
    [TestCase(20, 0, 1, 0)]
    [TestCase(21.5, 0, 1, 1)]
    [TestCase(21.5, 0.6, -0.8, 1)]
    public void Twenty_millimeters_of_a_path_may_lie_on_another(double length, double x, double y, int found)
    {
        var print = new SmallPrint(50, 90, 0.2).Print(50 + 100 * x, 90 + 100 * y, 0.2).Go(80, 80, 5).Go(50, 90, 0.2);
        for (var k = 1; k <= length * 2; k++) print.Print(50 + 0.5 * k * x, 90 + 0.5 * k * y, 0.2);
        Expect(print.Go(80, 80, 5), CheckCodes.Duplicate, found, 3);
    }

    [Test]
    public void Crossing_extrusions_and_other_heights_are_not_doubled()
    {
        var print = new SmallPrint(50, 50, 0.2).Print(100, 50, 0.2).Go(100, 50, 5);
        for (var x = 51; x < 100; x++) print.Go(x, 40, 5).Go(x, 40, 0.2).Print(x, 60, 0.2).Go(x, 60, 5);
        Expect(print.Go(50, 50, 5).Go(50, 50, 0.4).Print(100, 50, 0.4), CheckCodes.Duplicate, 0, 0);
    }

    // 0.08 mm² are 0.2 mm high below a nozzle of 0.4 mm: an error at less than 30 % of it, a warning at less than 60 %.
    [TestCase(0, "nozzle.too_low")]
    [TestCase(0.01, "nozzle.too_low")]
    [TestCase(0.05, "nozzle.too_low")]
    [TestCase(0.0599, "nozzle.too_low")]
    [TestCase(0.0601, "extrusion.squeezed")]
    [TestCase(0.1, "extrusion.squeezed")]
    [TestCase(0.1199, "extrusion.squeezed")]
    [TestCase(0.1201, "")]
    [TestCase(0.15, "")]
    [TestCase(0.2, "")]
    public void A_bead_on_the_bed_needs_its_height(double z, string expected)
    {
        var print = new SmallPrint(50, 50, z).Print(70, 50, z);
        foreach (var code in new[] { CheckCodes.TooLow, CheckCodes.Squeezed })
            Expect(print, code, code == expected ? 1 : 0, 0);
    }

    // A disc of 4 mm and 0.2 mm is 2.513 mm³.
    [TestCase(2.5, 0)]
    [TestCase(2.53, 1)]
    public void A_blob_needs_a_gap(double volume, int found)
        => Expect(new SmallPrint(50, 50, 0.2).Print(70, 50, 0.2).Go(100, 100, 0.2).Prime(volume), CheckCodes.Squeezed, found, 2,
            found > 0 ? "2.53 mm³ extruded in place do not fit into the 0.2 mm under the nozzle: the blob would be 4.01 mm wide. Extrude less." : null);

    // A disc of 8 mm and 0.2 mm is 10.05 mm³; above a gap of one nozzle it hangs.
    [TestCase(0.2, 10, 0)]
    [TestCase(0.2, 10.1, 1)]
    [TestCase(0, 0.2, 1)]
    [TestCase(0.41, 100, 1)]
    [TestCase(2, 100, 0)]
    public void A_wide_blob_is_refused(double z, double volume, int found)
        => Expect(new SmallPrint(50, 50, 0.2).Print(70, 50, 0.2).Go(100, 100, z).Prime(volume), CheckCodes.Blob, found, 2);

    [Test]
    public void A_wide_blob_is_refused_before_anything_is_printed()
        => Expect(new SmallPrint(50, 50, 0.2).Prime(300), CheckCodes.Blob, 1, 0);

    // Area of a stadium of a width and 0.2 mm height.
    [TestCase(1.2, 0)]
    [TestCase(1.21, 1)]
    [TestCase(0.079, 1)]
    [TestCase(0.081, 0)]
    public void Extrusions_have_a_width_for_their_nozzle(double width, int found)
    {
        var area = width > 0.2 && new PrintSettings().BeadShape == BeadShape.Stadium ? 0.2 * (width - 0.2) + Math.PI / 4 * 0.04
            : width > 0.2 || new PrintSettings().BeadShape == BeadShape.Rectangle ? width * 0.2 : Math.PI / 4 * width * width;
        Expect(new SmallPrint(50, 50, 0.2).Print(56, 50, 0.2, area), CheckCodes.Width, found, 0);
        Expect(new SmallPrint(50, 50, 0.2).Print(55, 50, 0.2, area), CheckCodes.Width, 0, 0);
    }

    // A ramp of 60 mm that rises by its height, a loop, and the same flow the other way round over it.
    [TestCase(true, 0)]
    [TestCase(false, 1)]
    public void An_extrusion_that_runs_out_over_its_own_ramp_is_not_thin(bool ramp, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).InLayer(new Layer(0, 0.2, 0.2)).Print(150, 50, 0.2).Go(150, 50, 20).Go(50, 50, 20).Go(50, 50, 0.201);
        print.InLayer(new Layer(1, 0.4, 0.2));
        for (var i = 1; i <= 120; i++) print.Print(50 + 0.5 * i, 50, ramp ? 0.2 + 0.2 * i / 120 : 0.4, 0.08 * (i - 0.5) / 120);
        print.Print(150, 50, 0.4).Print(150, 60, 0.4).Print(45, 60, 0.4).Print(45, 50, 0.4).Print(50, 50, 0.4);
        for (var i = 1; i <= 120; i++) print.Print(50 + 0.5 * i, 50, 0.4, 0.08 * (120.5 - i) / 120);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Width).Length, Is.EqualTo(found));
    }

    // 0.6 mm² without a layer: 1 mm wide in a gap of 0.6, 1.7 in one of 0.35, and round in the air, 0.87; of 1.83 mm² that is three nozzles.
    [TestCase(0.6, 0.6, 0)]
    [TestCase(0.51, 0.6, 0)]
    [TestCase(0.45, 0.6, 1)]
    [TestCase(5, 0.6, 0)]
    [TestCase(5, 1.8, 0)]
    [TestCase(5, 1.9, 1)]
    public void Without_layers_a_extrusion_is_as_high_as_its_gap(double gap, double area, int found)
    {
        var setup = new PrintSetup(SmallPrint.Generic, new Material(), new PrintSettings { BeadShape = BeadShape.Rectangle });
        var print = new SmallPrint(50, 50, gap).Print(70, 50, gap, area);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Width).Sum(d => d.Count), Is.EqualTo(found));
    }

    [TestCase(0.4, 0)]
    [TestCase(0.41, 1)]
    public void A_layer_is_no_higher_than_the_nozzle_is_wide(double height, int found)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(50, 50, height));
        builder.Add(new Vec3(70, 50, height), 2, 2, 20, MoveKind.Print, Role.OuterWall, builder.AddLayer(new Layer(0, height, height)), 0, 3);
        var list = SmallPrint.Find(builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]), Setup, CheckCodes.Height);
        Assert.That(list.Select(d => (d.Severity, d.Source!.Step, d.Message)),
            Is.EqualTo(Enumerable.Repeat((Severity.Warning, (int?)3, "A layer is 0.41 mm high, more than the nozzle diameter of 0.4 mm. Lower it."), found)));
    }

    [TestCase(0.09, 0)]
    [TestCase(0.11, 1)]
    [TestCase(0.99, 1)]
    [TestCase(1.01, 0)]
    public void Gaps_of_straight_lines_are_found(double gap, int found)
    {
        Expect(new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2).Go(60 + gap, 50, 0.2).Print(70 + gap, 50, 0.2), CheckCodes.Gap, found, 2);
        Expect(new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2).Go(60, 50 + gap, 0.2).Print(60, 60 + gap, 0.2), CheckCodes.Gap, 0, 2);
    }

    // 20 mm of 0.4 are 8 mm² and 8 √8 is 22.6 mm; a stadium is a little wider.
    [TestCase(21, 0)]
    [TestCase(25, 1)]
    public void A_high_print_needs_area_on_the_bed(double height, int found)
    {
        var list = SmallPrint.Find(new SmallPrint().Wall(50, 70, 50, height).Build(), Setup, CheckCodes.FirstLayer);
        Assert.That(list.Select(d => (d.Severity, d.Message)),
            Is.EqualTo(Enumerable.Repeat((Severity.Warning, "The print is 25 mm high, but only 8 mm² of it touch the bed. Add a brim."), found)));
    }

    [TestCase(1000, 0)]
    [TestCase(1001, 1)]
    public void Accelerations_have_the_limits_of_the_axes(double value, int found)
    {
        Expect(new SmallPrint().Event(new AccelerationEvent(value)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.AccelerationX, value)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.AccelerationY, value)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.AccelerationZ, value - 900)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.AccelerationE, value + 4000)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.TravelAcceleration, value)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.RetractionAcceleration, value + 4000)).Go(20, 10, 0.2), CheckCodes.Acceleration, found, 0);
        Expect(new SmallPrint().Event(new LimitEvent(MotionLimit.SpeedX, value)).Go(20, 10, 0.2), CheckCodes.Acceleration, 0, 0);
    }

    [Test]
    public void Material_in_place_adds_up_until_the_head_moves()
    {
        Expect(new SmallPrint().Prime(300).Prime(199).Go(20, 10, 0.2).Prime(400), CheckCodes.Stationary, 0, 0);
        Expect(new SmallPrint().Prime(300).Prime(201).Prime(1), CheckCodes.Stationary, 1, 1,
            "501 mm³ are extruded in place, but Generic printer allows only 500 mm³. Move the head, or extrude less.");
    }

    // 30 extrusions of 3 mm, of which so many pull back and as many make up for it.
    [TestCase(7, 0)]
    [TestCase(8, 1)]
    public void E_that_is_pulled_back_along_extrusions_is_in_the_other_mode(int wipes, int found)
    {
        var text = new StringBuilder("G28\nM104 S200\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2\n");
        for (var i = 1; i <= 30; i++) text.Append("G1 X").Append(10 + 3 * i).Append(i <= 30 - 2 * wipes || i % 2 == 0 ? " E0.1\n" : " E-0.1\n");
        Expect(text + "M104 S0\n", CheckCodes.ExtrusionMode, found, 7 + 30 - 2 * wipes);
    }

    // Absolute E read as relative: the extrusions get thicker and thicker.
    [TestCase(0.9, 0)]
    [TestCase(1.2, 1)]
    public void Extrusions_that_no_nozzle_prints_are_in_the_other_mode(double e, int found)
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z5\n");
        for (var i = 1; i <= 20; i++) text.Append("G1 X").Append(10 + i).Append(" E").Append(NumberFormatter.Format(e, 3)).Append('\n');
        Expect(text + "M104 S0\n", CheckCodes.ExtrusionMode, found, 6);
    }

    [TestCase("G28\nM109 S200\nG1 X10 Y10 Z0.2\nG1 X20 E1\nM104 S0\n", null)]
    [TestCase("M109 S200\nG1 X10 Y10 Z0.2\nG1 X20 E1\nM104 S0\n", "file.no_homing:3")]
    [TestCase("G28\nG1 X10 Y10 Z0.2\nG1 X20 E1\n", "file.no_heating:3")]
    [TestCase("START_PRINT\nG1 X10 Y10 Z0.2\nG1 X20 E1\n", null)]
    [TestCase("G28\nM109 S200\nG1 X10 Y10 Z0.2\nG1 X20 E1\n", "file.heat_left_on:2")]
    [TestCase("G28\nM109 S200\nM140 S60\nG1 X10 Y10 Z0.2\nG1 X20 E1\nM104 S0\n", "file.heat_left_on:3")]
    [TestCase("G28 X Y\nM109 S200\nG1 X10 Y10\nG1 X20 E1\nM104 S0\n", "file.unknown_position:4")]
    [TestCase("G28\nM109 S200\nT0\nM104 T1 S180\nG1 X10 Y10 Z0.2\nG1 X20 E1\nM104 S0 T0\nM104 T1 S0\n", null)]
    public void A_file_homes_heats_and_switches_off(string text, string? expected)
    {
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes("M83\n" + text), Setup);
        var found = PrintCheck.Run(file, Setup).Where(d => d.Code.StartsWith("file.", StringComparison.Ordinal)).ToArray();
        Assert.That(found.Select(d => $"{d.Code}:{d.Source!.Line - 1}"), Is.EqualTo(expected is null ? [] : new[] { expected }));
        Assert.That(found.Select(d => d.Severity), Is.All.EqualTo(Severity.Warning));
    }

    [Test]
    public void Each_check_is_as_serious_as_the_printer_says([Values("off", "note", "warning", "error")] string word)
    {
        var setup = Setup.With("check_severities=limit.flow=" + word + ",extrusion.gap=error", "max_flow_mm3_s=1").OrThrow();
        var print = new SmallPrint().Go(20, 10, 0.2).Print(30, 10, 0.2).Build();
        var found = PrintCheck.Run(print, setup).Where(d => d.Code == CheckCodes.Flow).ToArray();
        Assert.That(found.Select(d => d.Severity.ToString().ToLowerInvariant()), Is.EqualTo(word == "off" ? [] : new[] { word }));
        var written = SafeWriter.ToDocument(print, setup);
        Assert.That(written.Value is null, Is.EqualTo(word == "error"));
    }

    [TestCase("limit.flaw=error", "\"limit.flaw=error\"")]
    [TestCase("limit.flow", "needs off, note, warning or error")]
    [TestCase("limit.flow=bad", "\"bad\"")]
    public void Severities_that_do_not_exist_are_errors(string value, string message)
    {
        var wrong = Setup.With("check_severities=" + value);
        Assert.That(wrong.Value, Is.Null);
        Assert.That(wrong.Diagnostics.Single().Message, Does.Contain(message.Trim('"').Split('=')[0]));
    }

    [Test]
    public void Every_code_has_one_rule()
    {
        var codes = typeof(CheckCodes).GetFields().Select(f => (string)f.GetValue(null)!).ToArray();
        Assert.That(CheckCodes.All.Select(r => r.Code), Is.Unique.And.EquivalentTo(codes));
        Assert.That(CheckCodes.All.Select(r => r.Summary.Length), Is.All.GreaterThan(10));
        Assert.That(codes.Length, Is.EqualTo(47));
        var manual = System.IO.File.ReadAllText(System.IO.Path.Combine(TestData.Repository, "docs", "checks.md"));
        foreach (var rule in CheckCodes.All)
            Assert.That(manual, Does.Contain($"| `{rule.Code}` | {rule.Severity.ToString().ToLowerInvariant()} | {rule.Summary} |"));
    }

    private static void Expect(SmallPrint print, string code, int count, int move, string? message = null, PrintSetup? setup = null)
    {
        var toolpath = print.Build();
        var found = SmallPrint.Find(toolpath, setup ?? Setup, code);
        Assert.That(found.Sum(d => d.Count), Is.EqualTo(count), string.Join("\n", PrintCheck.Run(toolpath, setup ?? Setup)));
        if (count == 0) return;
        Assert.That((found[0].Severity, found[0].Source!.Move), Is.EqualTo((CheckCodes.Find(code)!.Severity, move)));
        if (message is not null) Assert.That(found[0].Message, Is.EqualTo(message));
    }

    private static void Expect(string text, string code, int count, int line)
    {
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes(text), Setup);
        var found = PrintCheck.Run(file, Setup).Where(d => d.Code == code).ToArray();
        Assert.That(found.Select(d => (d.Severity, d.Source!.Line)), Is.EqualTo(Enumerable.Repeat((CheckCodes.Find(code)!.Severity, (int?)line), count)));
    }
}
