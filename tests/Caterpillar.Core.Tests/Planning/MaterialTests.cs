using System;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>What a material changes of printer and settings.</summary>
public class MaterialTests
{
    // Two lines in each of two layers, with travels between them.
    private static Step[] Lines()
    {
        var layers = new[] { new Layer(0, 0.2, 0.2), new Layer(1, 0.4, 0.2) };
        return layers.SelectMany(layer => new[] { 50.0, 90 }.Select(y => (Step)new PathStep(
            new PrintPath([new(50, y, layer.Z), new(80, y, layer.Z)], new Bead(0.08, 0.2)) with { Role = Role.InnerWall, Layer = layer },
            new StepGroup(layer.Index)))).ToArray();
    }

    private static Toolpath Plan(PrintSetup setup) => Planner.Plan(Lines(), setup, new PlanOptions { Start = new Vec3(0, 0, 5) }).Value!;

    private static string[] Written(PrintSetup setup)
        => Encoding.ASCII.GetString(NewFile.Of(Plan(setup), SetupFormat.Of(setup, Plan(setup)).Value!)).Split('\n');

    private static PrintSetup With(Material material, string flavor = "marlin2")
        => new(new Printer { Flavor = FlavorTable.All.Single(f => f.Name == flavor) }, material, new PrintSettings());

    [TestCase("marlin2", "M900 K0.045")]
    [TestCase("marlin1", "M900 K0.045")]
    [TestCase("prusa", "M900 K0.045")]
    [TestCase("bambu", "M900 K0.045")]
    [TestCase("reprapfirmware", "M572 D0 S0.045")]
    [TestCase("klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.045")]
    [TestCase("repetier", null)]
    [TestCase("smoothie", null)]
    [TestCase("grbl", null)]
    public void Each_flavor_has_its_command_for_pressure_advance(string flavor, string? line)
    {
        var setup = With(new Material { PressureAdvance = 0.045 }, flavor);
        var lines = Written(setup).Where(l => l.Contains("0.045")).ToArray();
        Assert.That(lines, Is.EqualTo(line is null ? [] : new[] { line }));
        var found = setup.Check().Select(d => d.Message).ToArray();
        if (line is null) Assert.That(found.Single(), Does.EndWith("has no command for pressure advance: pressure_advance_s has no effect."));
        else Assert.That(found, Is.Empty);
        Assert.That(Written(With(new Material { PressureAdvance = 0 }, flavor)).Count(l => l.Contains("ADVANCE=0") || l is "M900 K0" or "M572 D0 S0"),
            Is.EqualTo(line is null ? 0 : 1), "0 switches it off");
    }

    [Test]
    public void Each_tool_gets_its_pressure_advance()
    {
        var printer = new Printer { Flavor = FlavorTable.Find("reprapfirmware")!, ToolOffsets = new(Vec3.Zero, new Vec3(20, 0)) };
        Step[] steps = [.. Lines(), new EventStep(new ToolEvent(1)), .. Lines(), new EventStep(new ToolEvent(0))];
        var toolpath = Planner.Plan(steps, new PrintSetup(printer, new Material { PressureAdvance = 0.05 }, new PrintSettings())).Value!;
        var text = Encoding.ASCII.GetString(NewFile.Of(toolpath, new GCodeFormat(NewFile.Machine with { Flavor = printer.Flavor }))).Split('\n');
        Assert.That(text.Where(l => l.StartsWith("M572", StringComparison.Ordinal) || l.StartsWith("T", StringComparison.Ordinal)),
            Is.EqualTo(new[] { "M572 D0 S0.05", "T1", "M572 D1 S0.05", "T0", "M572 D0 S0.05" }));
    }

    [Test]
    public void A_material_has_its_own_retraction_lift_and_wipe()
    {
        var setup = With(new Material { RetractionLength = 2.5, RetractionSpeed = 20, ZHop = 1, WipeDistance = 3 });
        var moves = Plan(setup).Moves().ToArray();
        var wipe = moves.First(m => m.Kind == MoveKind.Wipe);
        Assert.That((wipe.E, wipe.Start.DistanceTo(wipe.End)), Is.EqualTo((-2.5, 3.0)));
        Assert.That(moves.First(m => m.Kind == MoveKind.Deretract && m.Index > wipe.Index).Speed, Is.EqualTo(20));
        Assert.That(moves[wipe.Index + 1].End.Z, Is.EqualTo(1.2).Within(1e-9));
        Assert.That(Plan(With(new Material { RetractionLength = 0 })).Moves().Any(m => m.Kind == MoveKind.Retract), Is.False, "0 is off");
        var usual = Plan(With(new Material())).Moves().First(m => m.Kind == MoveKind.Retract);
        Assert.That((usual.E, usual.Speed), Is.EqualTo((-0.8, 35.0)), "that of the printer");
    }

    [TestCase("marlin2", "M207 S2.5 F1200")]
    [TestCase("reprapfirmware", "M207 S2.5 F1200")]
    [TestCase("klipper", "SET_RETRACTION RETRACT_LENGTH=2.5 RETRACT_SPEED=20")]
    [TestCase("repetier", null)]
    public void The_firmware_retraction_gets_them_by_its_command(string flavor, string? line)
    {
        var setup = With(new Material { RetractionLength = 2.5, RetractionSpeed = 20 }, flavor);
        setup = setup with { Printer = setup.Printer with { FirmwareRetraction = true } };
        Assert.That(Written(setup).Where(l => l.Contains("2.5")), Is.EqualTo(line is null ? [] : new[] { line }));
        Assert.That(setup.Check().Count(d => d.Code == "setup.no_command"), Is.EqualTo(line is null ? 1 : 0));
    }

    [Test]
    public void The_bed_is_hotter_for_the_first_layer()
    {
        var library = new ProfileLibrary();
        foreach (var printer in library.Names<Printer>())
        {
            var setup = library.Setup(printer, values: ["first_layer_bed_temperature_c=70", "bed_temperature_c=60"]).OrThrow();
            if (setup.Printer.MaxBedTemperature == 0) continue;
            var lines = Written(setup).Select(l => l.Split(';')[0].Trim()).Where(l => l.StartsWith("M140", StringComparison.Ordinal)
                || l.StartsWith("M190", StringComparison.Ordinal)).ToArray();
            Assert.That(lines, Is.EqualTo(new[] { "M140 S70", "M190 S70", "M140 S60", "M140 S0" }), printer);
        }
        Assert.That(Plan(With(new Material())).Events.Select(e => e.Event).OfType<BedTemperatureEvent>(), Is.Empty);
    }

    [Test]
    public void A_chamber_is_heated_read_and_checked()
    {
        var library = new ProfileLibrary();
        var setup = library.Setup("generic", values: ["chamber_temperature_c=50", "max_chamber_temperature_c=60"]).OrThrow();
        var text = string.Join("\n", Written(setup));
        Assert.That(text, Does.Contain("M191 S50 ").And.Contain("M141 S0 "));
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!;
        Assert.That(decoded.Toolpath.Events.Select(e => e.Event).OfType<ChamberTemperatureEvent>(),
            Is.EqualTo(new[] { new ChamberTemperatureEvent(50, true), new ChamberTemperatureEvent(0) }));
        string[] Found(string file, PrintSetup with) => PrintCheck.Run(GCodeDecoder.Decode(Encoding.ASCII.GetBytes(file)).Value!, with)
            .Where(d => d.Message.Contains("chamber")).Select(d => d.Message).ToArray();
        Assert.That(Found(text, setup), Is.Empty);
        Assert.That(Found(text.Replace("M141 S0", "; M141 S0"), setup),
            Is.EqualTo(new[] { "The chamber is still heated to 50 °C at the end. Add M141 S0 to the end G-code." }));
        Assert.That(Found(text, setup.With("max_chamber_temperature_c=0", "chamber_temperature_c=0").OrThrow()).Single(),
            Does.StartWith("The chamber temperature is 50 °C, but").And.Contain("has no heated chamber"));
        var klipper = Written(library.Setup("klipper_256", values: ["chamber_temperature_c=50"]).OrThrow());
        Assert.That(klipper, Does.Contain("SET_HEATER_TEMPERATURE HEATER=chamber TARGET=50"));
        Assert.That(library.Setup("ender3", values: ["chamber_temperature_c=50"]).Diagnostics.Single(d => d.Code == "setup.no_command").Message,
            Does.EndWith("does not heat a chamber: chamber_temperature_c has no effect."));
    }

    [TestCase("material_retraction_length_mm=", null)]
    [TestCase("material_retraction_length_mm=0", 0.0)]
    [TestCase("material_retraction_length_mm=1.5", 1.5)]
    public void An_empty_value_is_that_of_the_printer(string value, double? expected)
    {
        var material = new PrintSetup().With("material_retraction_length_mm=3").OrThrow().With(value).OrThrow().Material;
        Assert.That(material.RetractionLength, Is.EqualTo(expected));
        Assert.That(ProfileReader.Read<Material>(ProfileWriter.Write(material), "m.json", material.Name).OrThrow(), Is.EqualTo(material));
        var template = PrintTemplate.Parse(["{material_retraction_length_mm}"]).OrThrow();
        Assert.That(template.Render(PrintValues.Of(new PrintSetup { Material = material })).OrThrow().Single(),
            Is.EqualTo(NumberFormatter.Shortest(expected ?? 0.8)), "templates get what applies");
    }

    [TestCase("material_z_hop_mm=high", "profile.wrong_type")]
    [TestCase("pressure_advance_s=-1", "profile.out_of_range")]
    public void Bad_values_name_their_key(string value, string code)
    {
        var problem = new PrintSetup().With(value).Diagnostics.Single();
        Assert.That((problem.Code, problem.Source!.Key), Is.EqualTo((code, value.Split('=')[0])));
    }
}
