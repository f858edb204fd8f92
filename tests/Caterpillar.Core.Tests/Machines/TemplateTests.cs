using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class TemplateTests
{
    private static readonly PrintSetup Pla = new(new Printer(), new Material { NozzleTemperature = 205, BedTemperature = 60 }, new PrintSettings());

    [Test]
    public void Conditions_are_nested_up_to_a_hundred_deep()
    {
        string Nested(int depth) => string.Concat(Enumerable.Repeat("{if 1}", depth)) + "G28" + string.Concat(Enumerable.Repeat("{endif}", depth));
        Assert.That(Render(Pla, Nested(100)), Is.EqualTo(new[] { "G28" }));
        var error = PrintTemplate.Parse([Nested(100_000)]).Diagnostics.Single();
        Assert.That((error.Code, error.Source!.Line, error.Source.Column), Is.EqualTo(("template.nesting", (int?)1, (int?)602)));
        Assert.That(error.Message, Is.EqualTo("Conditions are nested more than 100 deep."));
    }

    [Test]
    public void Keys_are_replaced_by_their_values()
        => Assert.That(Render(Pla, "M104 S{nozzle_temperature_c} ; {material_name} on {gcode_flavor}"), Is.EqualTo(new[] { "M104 S205 ; pla on marlin2" }));

    [Test]
    public void A_branch_that_is_not_taken_leaves_no_lines()
    {
        string[] template = ["G28", "{if bed_temperature_c > 0}", "M190 S{bed_temperature_c}", "{endif}", "", "G90"];
        Assert.That(Render(Pla, template), Is.EqualTo(new[] { "G28", "M190 S60", "", "G90" }));
        var cold = Pla with { Material = Pla.Material with { BedTemperature = 0 } };
        Assert.That(Render(cold, template), Is.EqualTo(new[] { "G28", "", "G90" }));
    }

    [TestCase(0, "cold")]
    [TestCase(50, "warm")]
    [TestCase(90, "hot")]
    [TestCase(120, "very hot")]
    public void The_first_branch_that_holds_is_taken(double bed, string expected)
    {
        var setup = Pla with { Material = Pla.Material with { BedTemperature = bed } };
        string[] template = ["{if bed_temperature_c == 0}", "cold", "{elsif bed_temperature_c < 80}", "warm",
            "{elsif bed_temperature_c < 100 and bed_max_x_mm > 0}", "hot", "{else}", "very hot", "{endif}"];
        Assert.That(Render(setup, template), Is.EqualTo(new[] { expected }));
    }

    [Test]
    public void Branches_nest_and_work_inside_lines()
    {
        Assert.That(Render(Pla, "A{if bed_temperature_c > 0}B{if nozzle_temperature_c > 300}C{else}D{endif}{endif}E"), Is.EqualTo(new[] { "ABDE" }));
        Assert.That(Render(Pla, "{if nozzle_temperature_c > 300}", "{if bed_temperature_c > 0}", "x", "{else}", "y", "{endif}", "{else}", "z", "{endif}"),
            Is.EqualTo(new[] { "z" }));
        Assert.That(Render(Pla, "{if nozzle_temperature_c > 300}M104{endif}", "G28"), Is.EqualTo(new[] { "G28" }));
    }

    [Test]
    public void Arithmetic_is_written_with_up_to_five_decimals()
        => Assert.That(Render(Pla, "G1 X{bed_max_x_mm / 3} Y{-bed_min_y_mm} Z{min(1000, bed_max_z_mm)} E{1 / 3}"),
            Is.EqualTo(new[] { "G1 X73.33333 Y0 Z250 E0.33333" }));

    [Test]
    public void Doubled_braces_are_braces_of_the_text()
        => Assert.That(Render(Pla, "{{a}} {{{nozzle_temperature_c}}}"), Is.EqualTo(new[] { "{a} {205}" }));

    [Test]
    public void The_first_layer_may_have_its_own_temperature()
    {
        Assert.That(Render(Pla, "{start_nozzle_temperature_c}").Single(), Is.EqualTo("205"));
        Assert.That(Render(Pla with { Material = Pla.Material with { FirstLayerNozzleTemperature = 215 } }, "{start_nozzle_temperature_c}").Single(),
            Is.EqualTo("215"));
    }

    [TestCase("G1 X{", 1, 5)]
    [TestCase("G1 X}", 1, 5)]
    [TestCase("G28|{else}", 2, 2)]
    [TestCase("{endif}", 1, 2)]
    [TestCase("{if 1}|a", 1, 2)]
    [TestCase("{if 1}a{else}b{else}c{endif}", 1, 16)]
    [TestCase("{if 1}a{else}b{elsif 2}c{endif}", 1, 16)]
    [TestCase("{if}a{endif}", 1, 2)]
    [TestCase("M104 S{nozle_temperature_c}", 1, 8)]
    [TestCase("M104 S{1 +* 2}", 1, 11)]
    [TestCase("M104 S{ }", 1, 8)]
    [TestCase("M104 S{random()}", 1, 8)]
    public void Errors_carry_line_and_column(string template, int line, int column)
    {
        var result = PrintTemplate.Parse(template.Split('|'), new SourceLocation("p.json", Key: "start_gcode"));
        Assert.That(result.Value, Is.Null);
        var error = result.Diagnostics[0];
        Assert.That((error.Source!.Line, error.Source.Column, error.Source.File, error.Source.Key), Is.EqualTo((line, column, "p.json", "start_gcode")),
            error.ToString());
    }

    [Test]
    public void A_wrong_name_suggests_the_right_one()
        => Assert.That(PrintTemplate.Parse(["M104 S{nozle_temperature_c}"]).Diagnostics.Single().Message, Does.Contain("nozzle_temperature_c"));

    [Test]
    public void What_is_not_yet_known_is_an_error()
    {
        var result = PrintTemplate.Parse(["{layer_count}", "{if print_max_z_mm > 3}a{endif}", "{1 / (nozzle_temperature_c - 205)}"])
            .Value!.Render(PrintValues.Of(Pla));
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Select(d => (d.Code, d.Source!.Line)),
            Is.EqualTo(new[] { ("template.no_value", (int?)1), ("template.no_value", 2), ("template.not_finite", 3) }));
    }

    [Test]
    public void The_print_is_measured()
    {
        // An extrusion of 0.1 mm² and 100 mm: 10 mm³, 12.4 mg, E 10 / 2.405.
        var law = Pla.Extrusion;
        var e = law.E(100, 0.1);
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 5));
        var layer = builder.AddLayer(new Layer(0, 0.2, 0.2));
        builder.Add(new Vec3(10, 20, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, layer, 0, 0);
        builder.Add(new Vec3(110, 20, 0.2), e, e, 50, MoveKind.Print, Role.OuterWall, layer, 0, 1);
        var values = PrintValues.Of(Pla with { Material = Pla.Material with { CostPerKg = 20 } }, builder.Build([new ToolpathTool(law.VolumePerE)]));
        Assert.That(values.Number("material_used_mm3"), Is.EqualTo(10).Within(1e-9));
        Assert.That(values.Number("material_used_g"), Is.EqualTo(0.0124).Within(1e-9));
        Assert.That(values.Number("material_cost"), Is.EqualTo(0.000248).Within(1e-9));
        Assert.That(values.Number("filament_used_mm"), Is.EqualTo(e).Within(1e-9));
        Assert.That(values.Number("print_min_x_mm"), Is.EqualTo(10));
        Assert.That(values.Number("print_max_x_mm"), Is.EqualTo(110));
        Assert.That(values.Number("print_max_z_mm"), Is.EqualTo(0.2));
        Assert.That(values.Number("layer_count"), Is.EqualTo(1));
    }

    [TestCase(ExtrusionUnit.None, 0)]
    [TestCase(ExtrusionUnit.Mm3, 1)]
    public void Volume_per_E_is_zero_where_there_is_no_E(ExtrusionUnit unit, double expected)
    {
        var setup = Pla with { Printer = Pla.Printer with { ExtrusionUnit = unit } };
        Assert.That(Render(setup, "{if volume_per_e_mm3 > 0}E{20 / volume_per_e_mm3}{else}pen {volume_per_e_mm3}{endif}"),
            Is.EqualTo(new[] { expected > 0 ? "E20" : "pen 0" }));
        Assert.That(PrintValues.Of(setup).Number("volume_per_e_mm3"), Is.EqualTo(expected));
        // A start code that divides by it is refused rather than written with an infinite E.
        var divided = PrintTemplate.Parse(["G1 X9 E{20 / volume_per_e_mm3}"]).Value!.Render(PrintValues.Of(setup));
        Assert.That(divided.Diagnostics.Select(d => d.Code), Is.EqualTo(expected > 0 ? Array.Empty<string>() : ["template.not_finite"]));
    }

    [Test]
    public void Moves_of_a_tool_of_unknown_volume_per_E_count_as_filament_only()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 5));
        var layer = builder.AddLayer(new Layer(0, 0.2, 0.2));
        builder.Add(new Vec3(100, 0, 0.2), 4, 4, 50, MoveKind.Print, Role.OuterWall, layer, 0, 0);
        builder.Add(new Vec3(200, 0, 0.2), 3, 3, 50, MoveKind.Print, Role.OuterWall, layer, 1, 1);
        var values = PrintValues.Of(Pla, builder.Build([new ToolpathTool(2), new ToolpathTool((double?)null)]));
        Assert.That((values.Number("material_used_mm3"), values.Number("filament_used_mm")), Is.EqualTo((8.0, 7.0)));
    }

    [Test]
    public void Every_name_has_a_value_or_belongs_to_a_hook()
    {
        var values = PrintValues.Of(Pla, new ToolpathBuilder(MoveSource.Steps, null).Build([new ToolpathTool(1)]));
        var missing = PrintTemplate.Names.Select(p => p.Key).Where(n => values.Number(n) is null && values.Text(n) is null);
        Assert.That(missing, Is.EquivalentTo(new[] { "layer", "layer_z_mm", "tool", "previous_tool" }));
    }

    [Test]
    public void Random_templates_never_throw()
    {
        var random = new Random(7);
        string[] pieces = ["{", "}", "{if ", "{elsif ", "{else}", "{endif}", "1", "bed_temperature_c", ">", "(", " ", "G1", "x", "{{", "}}", "\t", "ü", "\0"];
        for (var i = 0; i < 3000; i++)
        {
            var lines = Enumerable.Range(0, random.Next(4))
                .Select(_ => string.Concat(Enumerable.Range(0, random.Next(10)).Select(_ => pieces[random.Next(pieces.Length)]))).ToArray();
            var template = PrintTemplate.Parse(lines);
            Assert.That(template.Value is null, Is.EqualTo(template.Diagnostics.Count > 0));
            template.Value?.Render(PrintValues.Of(Pla));
        }
    }

    [Test]
    public void The_culture_does_not_matter()
    {
        var before = Thread.CurrentThread.CurrentCulture;
        try
        {
            foreach (var name in new[] { "de-DE", "tr-TR", "ar-SA" })
            {
                Thread.CurrentThread.CurrentCulture = new CultureInfo(name);
                Assert.That(Render(Pla, "{if layer_height_mm < 0.3}Z{layer_height_mm}{endif}"), Is.EqualTo(new[] { "Z0.2" }));
            }
        }
        finally
        {
            Thread.CurrentThread.CurrentCulture = before;
        }
    }

    private static IReadOnlyList<string> Render(PrintSetup setup, params string[] lines)
    {
        var template = PrintTemplate.Parse(lines);
        Assert.That(template.Diagnostics, Is.Empty);
        var result = template.Value!.Render(PrintValues.Of(setup));
        Assert.That(result.Diagnostics, Is.Empty);
        return result.Value!;
    }
}
