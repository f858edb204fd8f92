using System;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

public class WriterTests
{
    private static readonly ToolpathTool[] Filament = [new(Math.PI / 4 * 1.75 * 1.75)];

    [Test]
    public void It_states_its_modal_state_and_writes_only_what_changes()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(10, 20, 0.2), 0, 0, 150, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 20, 0.2), 0.5, 0.5, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 30, 0.2), 0.25, 0.25, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 30, 0.2), -0.8, 0, 40, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 30, 0.2), 0, 0, 40, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var toolpath = builder.Build(Filament);
        Assert.That(Text(toolpath, new GCodeFormat(NewFile.Machine)), Is.EqualTo(
            "G90\nM83\nG0 X10 Y20 Z0.2 F9000\nG1 X20 E0.5 F1800\nG1 Y30 E0.25\nG1 E-0.8 F2400\n"));
        Assert.That(Text(toolpath, new GCodeFormat(NewFile.Machine with { ExtrusionMode = ExtrusionMode.Absolute })), Is.EqualTo(
            "G90\nM82\nG92 E0\nG0 X10 Y20 Z0.2 F9000\nG1 X20 E0.5 F1800\nG1 Y30 E0.75\nG1 E-0.05 F2400\n"));
        Assert.That(Text(toolpath, new GCodeFormat(NewFile.Machine with { ExtrusionUnit = ExtrusionUnit.None })),
            Is.EqualTo("G90\nG0 X10 Y20 Z0.2 F9000\nG1 X20 F1800\nG1 Y30\n"));
    }

    [Test]
    public void Rounding_of_E_is_carried_on()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= 3000; i++) builder.Add(new Vec3(i, 0, 0), 0.0000123, 0.0000123, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        var decoded = Decode(NewFile.Of(builder.Build(Filament)));
        Assert.That(decoded.Report.ENet, Is.EqualTo(0.0369).Within(1e-9));
    }

    [Test]
    public void Layers_roles_and_objects_come_back()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var ground = builder.AddLayer(new Layer(0, 0.3, 0.3, "cube"));
        var other = builder.AddLayer(new Layer(0, 0.3, 0.3, "ring"));
        var upper = builder.AddLayer(new Layer(1, 0.5, 0.2, "ring"));
        builder.Add(new Vec3(1, 0, 0.3), 0, 0, 100, MoveKind.Travel, Role.Unspecified, ground, 0, 0);
        builder.Add(new Vec3(9, 0, 0.3), 1, 1, 30, MoveKind.Print, Role.OuterWall, ground, 0, 0);
        builder.Add(new Vec3(9, 9, 0.3), 1, 1, 30, MoveKind.Print, Role.Infill, ground, 0, 0);
        builder.Add(new Vec3(1, 9, 0.3), 1, 1, 30, MoveKind.Print, Role.OuterWall, other, 0, 0);
        builder.Add(new Vec3(1, 9, 0.5), 0, 0, 30, MoveKind.Travel, Role.Unspecified, upper, 0, 0);
        builder.Add(new Vec3(1, 1, 0.5), 1, 1, 30, MoveKind.Print, Role.TopSurface, upper, 0, 0);
        var toolpath = Decode(NewFile.Of(builder.Build(Filament))).Toolpath;
        var prints = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(prints.Select(m => m.Role), Is.EqualTo(new[] { Role.OuterWall, Role.Infill, Role.OuterWall, Role.TopSurface }));
        Assert.That(prints.Select(m => toolpath.Layers[m.Layer]), Is.EqualTo(new[]
        {
            new Layer(0, 0.3, 0.3, "cube"), new Layer(0, 0.3, 0.3, "cube"), new Layer(0, 0.3, 0.3, "ring"), new Layer(1, 0.5, 0.2, "ring"),
        }));
    }

    [Test]
    public void Events_are_written_in_their_places_and_come_back()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        PrinterEvent[] events =
        [
            new HomeEvent(), new NozzleTemperatureEvent(215), new NozzleTemperatureEvent(210.5, true, 1), new BedTemperatureEvent(60, true), new FanEvent(1),
                new FanEvent(0),
            new AccelerationEvent(800), new PauseEvent(), new DwellEvent(1.5),
        ];
        builder.Add(new Vec3(1, 0, 0.3), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        foreach (var what in events) builder.AddEvent(what);
        builder.Add(new Vec3(9, 0, 0.3), 1, 1, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        var text = Text(builder.Build(Filament), new GCodeFormat(NewFile.Machine));
        Assert.That(text, Does.Contain("G28\nM104 S215\nM109 T1 S210.5\nM190 S60\nM106 S255\nM107\nM204 S800\nM0\nG4 P1500\nG1 X9 Y0 Z0.3 E1 F1800"));
        var back = Decode(Encoding.ASCII.GetBytes(text)).Toolpath;
        Assert.That(back.Events.Select(e => e.Event), Is.EqualTo(events));
    }

    [TestCase("marlin2", "G3 X10 Y0 I-10 J0 P1 E1")]
    [TestCase("cnc", "G3 X10 Y0 I-10 J0 P2 A1")]
    [TestCase("marlin1", "G3 X10 Y0 I-10 J0 E0.5")]
    [TestCase("klipper", "G3 X10 Y0 Z0.5 I-10 J0 E0.5")]
    public void Arcs_stay_arcs(string flavor, string expected)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(10, 0, flavor == "klipper" ? 1 : 0), 1, 1, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 720));
        var format = new GCodeFormat(NewFile.Machine with { Flavor = FlavorTable.Find(flavor)! });
        Assert.That(Text(builder.Build(Filament), format), Does.Contain(expected));
        var back = GCodeDecoder.Decode(NewFile.Of(builder.Build(Filament), format), new DecodeOptions { Flavor = format.Flavor }).Value!;
        Assert.That(back.Report.Counters.PrintLengthXY, Is.EqualTo(40 * Math.PI).Within(1e-6));
    }

    private static string Text(Toolpath toolpath, GCodeFormat format) => Encoding.ASCII.GetString(NewFile.Of(toolpath, format));

    private static DecodedGCode Decode(byte[] bytes) => GCodeDecoder.Decode(bytes, new DecodeOptions { Flavor = FlavorTable.Marlin2 }).Value!;
}
