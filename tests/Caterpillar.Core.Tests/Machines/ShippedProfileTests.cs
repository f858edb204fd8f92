using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

/// <summary>The profiles that come with Caterpillar.</summary>
public class ShippedProfileTests
{
    private static readonly ProfileLibrary Library = new();

    public static IEnumerable<string> Printers => Library.Names<Printer>();

    [Test]
    public void All_of_them_exist()
    {
        Assert.That(Library.Names<Printer>(), Is.SupersetOf(new[]
        {
            "ender3", "five_axis_head", "five_axis_table", "generic", "klipper_256", "lutum", "pen_plotter", "potter_super", "prusa_mk3s", "rrf_delta",
            "wasp_2040_clay",
        }));
        Assert.That(Library.Names<Material>(), Is.SupersetOf(new[] { "abs", "clay", "clay_285", "pen", "petg", "pla", "tpu" }));
        Assert.That(Library.Names<PrintSettings>(), Is.SupersetOf(new[] { "clay", "fine", "pen", "standard" }));
    }

    [TestCaseSource(nameof(Printers))]
    public void Every_printer_makes_a_setup_without_problems(string name)
    {
        var setup = Library.Setup(name);
        Assert.That(setup.Diagnostics, Is.Empty);
        Assert.That(setup.Value!.Printer.Name, Is.EqualTo(name));
    }

    [Test]
    public void Every_material_and_every_settings_can_be_read()
    {
        foreach (var name in Library.Names<Material>()) Assert.That(Library.Material(name).Diagnostics, Is.Empty, name);
        foreach (var name in Library.Names<PrintSettings>()) Assert.That(Library.Settings(name).Diagnostics, Is.Empty, name);
    }

    [Test]
    public void The_generic_printer_has_the_defaults_of_the_records()
    {
        var setup = Library.Setup().Value!;
        var plain = new PrintSetup();
        Assert.That(setup.Printer with { StartGCode = ValueList<string>.Empty, EndGCode = ValueList<string>.Empty, Title = plain.Printer.Title },
            Is.EqualTo(plain.Printer));
        Assert.That(setup.Settings with { Title = plain.Settings.Title }, Is.EqualTo(plain.Settings));
    }

    [TestCaseSource(nameof(Printers))]
    public void Its_templates_render_with_every_material(string name)
    {
        foreach (var material in Library.Names<Material>()) Assert.That(Lines(name, material), Is.Not.Empty);
    }

    [TestCaseSource(nameof(Printers))]
    public void It_heats_to_the_temperatures_of_the_material_and_cools_down_at_the_end(string name)
    {
        var printer = Library.Printer(name).Value!;
        var start = Start(name, null);
        var heats = printer.MinExtrusionTemperature > 0;
        Assert.That(start.Any(l => l.StartsWith("M109 S215")), Is.EqualTo(heats));
        Assert.That(start.Any(l => l.StartsWith("M190 S60")), Is.EqualTo(heats));
        var cold = Start(name, "clay");
        Assert.That(cold.Any(l => l.StartsWith("M109") || l.StartsWith("M104") || l.StartsWith("M190") || l.StartsWith("M140")), Is.False);
        if (!heats) return;
        var end = End(name);
        Assert.That(end.Any(l => l.StartsWith("M104 S0")) && end.Any(l => l.StartsWith("M140 S0")), Is.True);
        Assert.That(start.TakeWhile(l => !l.StartsWith("G28")), Has.None.StartsWith("G1 "), "It moves before it is homed.");
    }

    [TestCaseSource(nameof(Printers))]
    public void It_states_units_positions_and_e_before_it_moves(string name)
    {
        var printer = Library.Printer(name).Value!;
        var start = Start(name, null).TakeWhile(l => !l.StartsWith("G1 ") && !l.StartsWith("G0 ")).ToList();
        Assert.That(start, Has.Some.StartsWith("G21"));
        var absolute = start.FindIndex(l => l.StartsWith("G90"));
        Assert.That(absolute, Is.GreaterThanOrEqualTo(0));
        if (printer.ExtrusionUnit == ExtrusionUnit.None) return;
        // G90 sets E to absolute on Marlin and Smoothie, so M82 or M83 comes after it.
        Assert.That(start.FindIndex(l => l.StartsWith(printer.ExtrusionMode == ExtrusionMode.Relative ? "M83" : "M82")), Is.GreaterThan(absolute));
        Assert.That(Lines(name, null), Has.None.EqualTo("G92"));
    }

    [TestCaseSource(nameof(Printers))]
    public void It_primes_and_parks_inside_its_space_whatever_the_height_of_the_print(string name)
    {
        var printer = Library.Printer(name).Value!;
        foreach (var top in new[] { 0.2, printer.BuildVolume.Z - 1 })
        {
            var at = new Vec3(0, 0, top);
            foreach (var line in Start(name, null).Concat(End(name, top)))
            {
                var words = line.Split(';')[0].Split('(')[0].Split(' ');
                if (words[0] is not ("G0" or "G1")) continue;
                foreach (var word in words.Skip(1).Where(w => w.Length > 1))
                {
                    var number = double.Parse(word.Substring(1), System.Globalization.CultureInfo.InvariantCulture);
                    if (word[0] == 'X') at = new Vec3(number, at.Y, at.Z);
                    if (word[0] == 'Y') at = new Vec3(at.X, number, at.Z);
                    if (word[0] == 'Z') at = new Vec3(at.X, at.Y, number);
                }
                Assert.That(printer.CanReach(at), Is.True, $"{line} leads to {at}");
            }
            Assert.That(at.Z, Is.GreaterThan(top));
        }
    }

    private static List<string> Lines(string printer, string? material) => Start(printer, material).Concat(End(printer)).ToList();

    private static IReadOnlyList<string> Start(string printer, string? material)
    {
        var setup = Library.Setup(printer, material).Value!;
        return Render(setup.Printer.StartGCode, PrintValues.Of(setup));
    }

    private static IReadOnlyList<string> End(string printer, double top = 10)
    {
        var setup = Library.Setup(printer).Value!;
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(0, 0, top), 1, 1, 10, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        return Render(setup.Printer.EndGCode, PrintValues.Of(setup, builder.Build([new ToolpathTool(setup.Extrusion.VolumePerE)])));
    }

    private static IReadOnlyList<string> Render(IReadOnlyList<string> template, TemplateValues values)
    {
        var lines = PrintTemplate.Parse(template).Value!.Render(values);
        Assert.That(lines.Diagnostics, Is.Empty);
        return lines.Value!;
    }
}
