using System;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Tests.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

public class StatisticsTests
{
    private static readonly Printer Printer = new()
    {
        Cornering = Cornering.Jerk,
        Jerk = new(0, 0, 0, 0),
        PrintAcceleration = 1000,
        TravelAcceleration = 2000,
        RetractionAcceleration = 1000,
        MaxAcceleration = new(1e6, 1e6, 1e6, 1e6),
        MaxSpeed = new(500, 500, 500, 500),
        LookaheadMoves = 0,
        NozzleHeating = 2,
        BedHeating = 1,
        HomingTime = 5,
        ToolChangeTime = 3,
    };

    private const string Print = """
        M190 S60
        M109 S220
        G28
        M83
        ;LAYER_CHANGE
        ;Z:0.3
        ;TYPE:External perimeter
        G1 X100 E5 F6000
        M400
        G1 E-1 F600
        M400
        G1 X150
        M400
        G1 E1
        M400
        ;TYPE:Solid infill
        G1 X250 E10 F6000
        T1
        ;LAYER_CHANGE
        ;Z:0.6
        G4 S2
        G1 X150 E2
        """;

    [Test]
    public void Times_lengths_and_material_are_those_of_the_moves()
    {
        var s = Of(Print);
        // Extrusions of 100 mm: 1.1 s. The travel is still at 10 mm/s: 5 s and 0.005 s. Retraction and restore: 0.1 + 0.01 each.
        Assert.That(s.PrintTime, Is.EqualTo(3.3).Within(1e-9));
        Assert.That(s.TravelTime, Is.EqualTo(5.005).Within(1e-9));
        Assert.That(s.ExtruderTime, Is.EqualTo(0.22).Within(1e-9));
        Assert.That(s.Waits, Is.EqualTo(new WaitTimes(40 + 100, 2, 3, 5)));
        Assert.That(s.Duration, Is.EqualTo(3.3 + 5.005 + 0.22 + 150).Within(1e-9));
        Assert.That((s.PrintLength, s.TravelLength, s.Retractions, s.Moves), Is.EqualTo((300, 50, 1, 7)));
        var area = Math.PI * 1.75 * 1.75 / 4;
        Assert.That(s.Filament, Is.EqualTo(17).Within(1e-9));
        Assert.That(s.Volume, Is.EqualTo(17 * area).Within(1e-9));
        Assert.That(s.Mass, Is.EqualTo(17 * area / 1000 * 1.24).Within(1e-9));
        Assert.That(s.Cost, Is.EqualTo(17 * area / 1000 * 1.24 / 1000 * 25).Within(1e-12));
        Assert.That(s.GreatestFlow, Is.EqualTo(0.1 * 100 * area).Within(1e-9));
        Assert.That(s.GreatestFlowMove, Is.EqualTo(4));
        Assert.That(s.GreatestSpeed, Is.EqualTo(100).Within(1e-9));
        Assert.That(s.PrintBounds, Is.EqualTo(new Bounds(Vec3.Zero, new Vec3(250, 0, 0))));
    }

    [Test]
    public void Roles_tools_and_layers_share_the_time()
    {
        var s = Of(Print);
        var roles = s.Roles.Select(r => (r.Role, Math.Round(r.Time, 9), r.Length));
        Assert.That(roles, Is.EqualTo(new[] { (Role.OuterWall, 1.1, 100.0), (Role.SolidInfill, 2.2, 200.0) }));
        Assert.That(s.Tools.Select(t => (t.Tool, Math.Round(t.Time, 9), t.Filament)), Is.EqualTo(new[] { (0, 7.425, 15.0), (1, 1.1, 2.0) }));
        Assert.That(s.Layers.Select(l => (l.Layer, Math.Round(l.Time, 9), l.Length)), Is.EqualTo(new[] { (0, 152.425, 200.0), (1, 6.1, 100.0) }));
        Assert.That(s.Layers[1].Start, Is.EqualTo(152.425).Within(1e-9));
    }

    [Test]
    public void What_is_not_known_is_not_said()
    {
        var s = Of(Print, diameter: null);
        Assert.That((s.Volume, s.Mass, s.Cost, s.GreatestFlow), Is.EqualTo(((double?)null, (double?)null, (double?)null, (double?)null)));
        Assert.That(Of(Print, price: 0).Cost, Is.Null);
        var nothing = Of("");
        Assert.That((nothing.Duration, nothing.Volume, nothing.Roles.Count, nothing.Layers.Count), Is.EqualTo((0.0, (double?)0.0, 0, 0)));
    }

    [TestCase("ps_overlap_two_tools.gcode")]
    [TestCase("cu_plate_marlin_absE.gcode")]
    [TestCase("ps_plate_smoothie_volE_fwr.gcode")]
    public void Sums_of_a_print_are_those_of_its_moves_and_of_its_slicer(string file)
    {
        var decoding = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!;
        var s = PrintStatistics.Of(Timeline.Of(decoding.Toolpath, new PrintSetup { Printer = Printer }));
        var totals = ToolpathTotals.Of(decoding.Toolpath);
        Assert.That(s.PrintTime + s.TravelTime + s.ExtruderTime + s.Waits.Total, Is.EqualTo(s.Duration).Within(1e-6));
        Assert.That(s.PrintLength, Is.EqualTo(totals.PrintLength).Within(1e-6));
        Assert.That(s.TravelLength, Is.EqualTo(totals.TravelLength).Within(1e-6));
        Assert.That(s.Volume, Is.EqualTo(totals.DepositedVolume).Within(1e-6));
        Assert.That(s.Roles.Sum(r => r.Time), Is.EqualTo(s.PrintTime).Within(1e-6));
        Assert.That(s.PrintBounds, Is.EqualTo(totals.PrintBounds));
        Assert.That(s.Layers.Sum(l => l.Time), Is.LessThanOrEqualTo(s.Duration + 1e-6));
        if (file.StartsWith("ps_plate", StringComparison.Ordinal)) Assert.That(s.Volume, Is.EqualTo(4157.34).Within(0.5).Percent);
    }

    private static PrintStatistics Of(string lines, double? diameter = 1.75, double price = 25)
    {
        var document = GCodeDocument.FromBytes(System.Text.Encoding.ASCII.GetBytes(lines + "\n"), "program");
        var toolpath = GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = diameter }).Value!.Toolpath;
        return PrintStatistics.Of(Timeline.Of(toolpath, new PrintSetup { Printer = Printer, Material = new Material { CostPerKg = price } }));
    }
}
