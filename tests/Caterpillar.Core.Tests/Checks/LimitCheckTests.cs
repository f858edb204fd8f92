using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

public class LimitCheckTests
{
    private static readonly PrintSetup Generic = new();

    private static readonly PrintSetup Delta = new(
        new Printer { Title = "Delta", BuildVolume = new Vec3(200, 200, 300), Origin = BedOrigin.Center, BedShape = BedShape.Round }, new Material(),
            new PrintSettings());

    [Test]
    public void Moves_inside_the_bed_are_fine()
        => Assert.That(Run(Generic, b => Print(b, new Vec3(220, 220, 250)), start: new Vec3(219, 220, 250)), Is.Empty);

    [TestCase(221, 10, 0.2)]
    [TestCase(10, -1, 0.2)]
    [TestCase(10, 10, 250.5)]
    public void Moves_outside_the_bed_are_errors_that_name_move_and_step(double x, double y, double z)
    {
        var found = Run(Generic, b =>
        {
            Print(b, new Vec3(20, 10, 0.2));
            b.Add(new Vec3(x, y, z), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 7);
            b.Add(new Vec3(x, y, z), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 8);
        }).Single();
        Assert.That((found.Severity, found.Code, found.Source!.Move, found.Source.Step, found.Count), Is.EqualTo((Severity.Error, "bed.outside", 1, 7, 2)));
        Assert.That(found.Message, Does.Contain("Generic printer"));
    }

    [Test]
    public void Moves_below_the_bed_are_reported_as_such()
        => Assert.That(Run(Generic, b => Print(b, new Vec3(20, 10, -0.1))).Single().Code, Is.EqualTo("bed.below"));

    [Test]
    public void A_round_bed_has_no_corners()
    {
        Assert.That(Run(Delta, b => Print(b, new Vec3(70, 70, 1)), new Vec3(69, 69, 1)), Is.Empty);
        Assert.That(Run(Delta, b => Print(b, new Vec3(72, 72, 1)), new Vec3(69, 69, 1)).Single().Code, Is.EqualTo("bed.outside"));
    }

    [TestCase(300, 0)]
    [TestCase(300.5, 1)]
    [TestCase(900, 1)]
    public void A_nozzle_hotter_than_the_hot_end_stands_is_an_error_with_its_move(double celsius, int errors)
    {
        var found = Run(Generic, b =>
        {
            Print(b, new Vec3(20, 10, 0.2));
            b.AddEvent(new NozzleTemperatureEvent(celsius));
            Print(b, new Vec3(30, 10, 0.2));
        });
        Assert.That(found.Select(d => (d.Code, d.Source!.Move)), Is.EqualTo(Enumerable.Repeat(("limit.nozzle_temperature", (int?)1), errors)));
    }

    [TestCase(120, 0)]
    [TestCase(120.5, 1)]
    public void A_bed_hotter_than_it_stands_is_an_error(double celsius, int errors)
        => Assert.That(Run(Generic, b => b.AddEvent(new BedTemperatureEvent(celsius))).Select(d => d.Code),
            Is.EqualTo(Enumerable.Repeat("limit.bed_temperature", errors)));

    [Test]
    public void The_temperatures_of_the_material_are_checked_before_any_move()
    {
        var hot = new PrintSetup(Generic.Printer, new Material { NozzleTemperature = 450, BedTemperature = 200 }, Generic.Settings);
        Assert.That(Run(hot, b => Print(b, new Vec3(20, 10, 0.2))).Select(d => d.Code),
            Is.EqualTo(new[] { "limit.nozzle_temperature", "limit.bed_temperature" }));
        var first = new PrintSetup(Generic.Printer, new Material { FirstLayerNozzleTemperature = 301 }, Generic.Settings);
        Assert.That(Run(first, b => Print(b, new Vec3(20, 10, 0.2))).Select(d => d.Code), Is.EqualTo(new[] { "limit.nozzle_temperature" }));
    }

    [Test]
    public void What_cannot_be_heated_says_so()
    {
        var cold = new PrintSetup(Generic.Printer with { MaxNozzleTemperature = 0, MinExtrusionTemperature = 0 }, new Material(), Generic.Settings);
        Assert.That(Run(cold, b => Print(b, new Vec3(20, 10, 0.2))).Single().Message, Does.Contain("has no heated nozzle"));
    }

    // 500 mm³ are 207.88 mm of filament of 1.75 mm.
    [TestCase(207.8, 0)]
    [TestCase(208, 1)]
    [TestCase(-208, 1)]
    [TestCase(1e9, 1)]
    public void Material_in_place_has_a_limit(double e, int errors)
    {
        var found = Run(Generic, b => b.Add(new Vec3(10, 10, 0.2), e, 0, 5, e > 0 ? MoveKind.Prime : MoveKind.Retract, Role.Unspecified, -1, 0, 3),
            new Vec3(10, 10, 0.2));
        Assert.That(found.Select(d => d.Code), Is.EqualTo(Enumerable.Repeat("limit.stationary", errors)));
    }

    // Around the center of a round bed of 200 mm, and around a place 30 mm aside.
    [TestCase(0, 99, 0)]
    [TestCase(0, 101, 1)]
    [TestCase(30, 69, 0)]
    [TestCase(30, 75, 1)]
    public void An_arc_stays_on_a_round_bed(double aside, double radius, int found)
    {
        void Arc(ToolpathBuilder b) => b.Add(new Vec3(aside, -radius, 1), 1, 1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0,
            new Arc(new Vec3(aside, 0, 1), -180));
        Assert.That(Run(Delta, Arc, new Vec3(aside, radius, 1)).Count(d => d.Code == "bed.outside"), Is.EqualTo(found));
    }

    [Test]
    public void An_arc_that_bulges_out_is_seen()
    {
        // Both ends at X 219, the half circle between them reaches X 229.
        void Arc(ToolpathBuilder b) => b.Add(new Vec3(219, 40, 1), 1, 1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(new Vec3(219, 30, 1), 180));
        Assert.That(Run(Generic, Arc, new Vec3(219, 20, 1)).Select(d => d.Code), Does.Contain("bed.outside"));
        void Round(ToolpathBuilder b) => b.Add(new Vec3(-90, 0, 1), 1, 1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(new Vec3(0, 0, 1), 180));
        Assert.That(Run(Delta, Round, new Vec3(90, 0, 1)), Is.Empty);
    }

    [Test]
    public void More_material_than_the_hot_end_can_push_is_an_error()
    {
        // 12 mm³/s at most: 10 mm at 60 mm/s with 2 mm³ are 12, with 2.1 mm³ 12.6.
        var filament = Math.PI / 4 * 1.75 * 1.75;
        void Line(ToolpathBuilder b, double volume)
            => b.Add(new Vec3(20, 10, 0.2), volume / filament, volume / filament, 60, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        Assert.That(Run(Generic, b => Line(b, 2)), Is.Empty);
        var found = Run(Generic, b => Line(b, 2.1)).Single();
        Assert.That((found.Code, found.Severity), Is.EqualTo(("limit.flow", Severity.Error)));
        Assert.That(found.Message, Does.Contain("12.6 mm³/s"));
    }

    [Test]
    public void Speeds_beyond_the_axes_are_warnings_and_do_not_count_as_flow()
    {
        // Straight up at 60 mm/s where Z does 12: 1 mm with 0.5 mm³ would be 30 mm³/s, but is 6.
        var filament = Math.PI / 4 * 1.75 * 1.75;
        var found = Run(Generic, b => b.Add(new Vec3(10, 10, 1.2), 0.5 / filament, 0.5 / filament, 60, MoveKind.Print, Role.Unspecified, -1, 0, 0)).Single();
        Assert.That((found.Code, found.Severity), Is.EqualTo(("limit.speed", Severity.Warning)));
    }

    [Test]
    public void Cold_extrusion_is_an_error_and_events_heat_and_cool()
    {
        var cold = new PrintSetup(new Printer(), new Material { NozzleTemperature = 0 }, new PrintSettings());
        Assert.That(Run(cold, b => Print(b, new Vec3(20, 10, 0.2))).Single().Code, Is.EqualTo("limit.cold_extrusion"));
        Assert.That(Run(cold, b =>
        {
            b.AddEvent(new NozzleTemperatureEvent(200, Wait: true));
            Print(b, new Vec3(20, 10, 0.2));
        }), Is.Empty);
        var cooled = Run(Generic, b =>
        {
            Print(b, new Vec3(20, 10, 0.2));
            b.AddEvent(new NozzleTemperatureEvent(150.4));
            Print(b, new Vec3(30, 10, 0.2));
        }).Single();
        Assert.That((cooled.Code, cooled.Source!.Move), Is.EqualTo(("limit.cold_extrusion", 1)));
        Assert.That(cooled.Message, Is.EqualTo("A move extrudes at 150 °C, but Generic printer needs 170 °C. Heat the nozzle first."));
        var clay = new PrintSetup(new Printer { MinExtrusionTemperature = 0 }, new Material { NozzleTemperature = 0 }, new PrintSettings());
        Assert.That(Run(clay, b => Print(b, new Vec3(20, 10, 0.2))), Is.Empty);
    }

    [Test]
    public void Each_nozzle_has_its_own_temperature_where_the_file_names_tools()
    {
        var two = new PrintSetup(new Printer { ToolOffsets = new(Vec3.Zero, Vec3.Zero) }, new Material { NozzleTemperature = 0 }, new PrintSettings());
        void With(ToolpathBuilder b, int tool, params PrinterEvent[] before)
        {
            foreach (var what in before) b.AddEvent(what);
            b.Add(new Vec3(20, 10, 0.2), 0.1, 0.1, 10, MoveKind.Print, Role.Unspecified, -1, tool, 0);
        }
        var shared = two with { Printer = two.Printer with { SharedNozzle = true } };
        Assert.That(Run(shared, b => With(b, 1, new NozzleTemperatureEvent(210), new ToolEvent(1))), Is.Empty, "one nozzle for both");
        Assert.That(Run(two, b => With(b, 1, new NozzleTemperatureEvent(210), new ToolEvent(1))).Single().Code, Is.EqualTo("limit.cold_extrusion"));
        Assert.That(Run(two, b => With(b, 0, new NozzleTemperatureEvent(210, Tool: 0), new NozzleTemperatureEvent(0, Tool: 1))), Is.Empty,
            "the other one is cold");
        Assert.That(Run(two, b => With(b, 1, new NozzleTemperatureEvent(210, Tool: 0), new ToolEvent(1))).Single().Code, Is.EqualTo("limit.cold_extrusion"));
        Assert.That(Run(two, b => With(b, 1, new NozzleTemperatureEvent(210, Tool: 0), new ToolEvent(1), new NozzleTemperatureEvent(205, true))), Is.Empty,
            "the current tool is meant");
    }

    [Test]
    public void A_tool_that_the_printer_lacks_is_an_error()
        => Assert.That(Run(Generic, b => b.Add(new Vec3(20, 10, 0.2), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 1, 0)).Single().ToString(),
            Is.EqualTo("step 0, move 0: error limit.tool: Move uses tool 1, but Generic printer has only tool 0."));

    [TestCase(1, 0)]
    [TestCase(1.0001, 1)]
    public void A_move_at_exactly_the_greatest_speed_is_fine(double factor, int findings)
    {
        var speed = Generic.Printer.MaxSpeed.X * factor;
        var found = Run(Generic, b => b.Add(new Vec3(210, 10, 0.2), 0.01, 0.01, speed, MoveKind.Print, Role.Unspecified, -1, 0, 0));
        Assert.That(found.Select(d => d.Code), Is.EqualTo(Enumerable.Repeat("limit.speed", findings)));
    }

    [Test]
    public void Null_arguments_are_a_misuse()
    {
        var toolpath = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero).Build([new ToolpathTool(1)]);
        Assert.That(() => PrintCheck.Run((Toolpath)null!, Generic), Throws.ArgumentNullException);
        Assert.That(() => PrintCheck.Run(toolpath, null!), Throws.ArgumentNullException);
        Assert.That(() => SafeWriter.Write(null!, Generic, System.IO.Stream.Null), Throws.ArgumentNullException);
        Assert.That(() => SafeWriter.Write(toolpath, null!, System.IO.Stream.Null), Throws.ArgumentNullException);
        Assert.That(() => SafeWriter.Write(toolpath, Generic, (System.IO.Stream)null!), Throws.ArgumentNullException);
    }

    private static void Print(ToolpathBuilder builder, Vec3 to)
        => builder.Add(to, 0.1, 0.1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0);

    private static Diagnostic[] Run(PrintSetup setup, Action<ToolpathBuilder> moves, Vec3? start = null)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, start ?? new Vec3(10, 10, 0.2));
        moves(builder);
        return PrintCheck.Run(builder.Build([new ToolpathTool(Math.PI / 4 * 1.75 * 1.75)]), setup)
            .Where(d => d.Code.StartsWith("bed.", StringComparison.Ordinal) || d.Code.StartsWith("limit.", StringComparison.Ordinal)).ToArray();
    }
}
