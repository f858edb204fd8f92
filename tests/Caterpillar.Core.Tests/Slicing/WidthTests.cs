using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Widths by role, in mm and in % of the nozzle.</summary>
public class WidthTests
{
    // What a stadium of 0.2 mm covers less than its width.
    private const double Round = (1 - Math.PI / 4) * 0.2;

    private static readonly PrintSettings Settings = new()
    {
        LineWidth = 0.45, FirstLayerHeight = 0.2, LayerHeight = 0.2, MinLayerTime = 0, WallCount = 3, InfillPattern = InfillPattern.Lines, SeamGap = 0,
    };

    private static IReadOnlyList<SlicedLayer> Cube(PrintSettings settings) => Solids.Slice(settings, Solids.Block(0, 0, 0, 20, 20, 4));

    // Width of a bead from its area.
    private static double WidthOf(PrintPath path) => path.BeadOf(0).Area / 0.2 + Round;

    private static double[] Widths(SlicedLayer layer, params Role[] roles)
        => Solids.Paths(layer, roles).Select(p => Math.Round(WidthOf(p), 3)).Distinct().OrderBy(w => w).ToArray();

    [TestCase(0.6, 0.45, true)]
    [TestCase(0.6, 0.45, false)]
    [TestCase(0.4, 0.6, true)]
    [TestCase(0.4, 0.6, false)]
    public void Walls_of_two_widths_lie_side_by_side(double outer, double inner, bool variable)
    {
        var layer = Cube(Settings with { OuterWallLineWidth = outer, InnerWallLineWidth = inner, VariableWallWidth = variable })[8];
        Assert.That(Widths(layer, Role.OuterWall), Is.EqualTo(new[] { outer }));
        Assert.That(Widths(layer, Role.InnerWall), Is.EqualTo(new[] { inner }));
        // Half a width from the outline, half of both spacings to the next, then a spacing.
        var first = outer / 2;
        var second = first + (outer - Round + inner - Round) / 2;
        var insets = Solids.Paths(layer, Role.OuterWall, Role.InnerWall).Select(p => p.RawPoints.Min(q => q.X)).OrderBy(x => x);
        Assert.That(insets, Is.EqualTo(new[] { first, second, second + inner - Round }).Within(0.003));
        if (outer == 0.6) Assert.That(second, Is.EqualTo(0.78208).Within(1e-5), "by hand: 0.3 + (0.55708 + 0.40708) / 2");
    }

    [Test]
    public void Each_role_has_its_width()
    {
        var layers = Cube(Settings with
        {
            OuterWallLineWidth = 0.4, InnerWallLineWidth = 0.5, InfillLineWidth = 0.6, SolidInfillLineWidth = 0.55, TopSurfaceLineWidth = 0.38,
            NarrowSolidInfill = 0, InfillBridges = false,
        });
        // Rows that share what is left are a little narrower or wider.
        Assert.That(Widths(layers[8], Role.Infill), Is.EqualTo(new[] { 0.6 }));
        Assert.That(WidthOf(Solids.Paths(layers[0], Role.BottomSurface)[0]), Is.EqualTo(0.55).Within(0.02));
        Assert.That(WidthOf(Solids.Paths(layers[1], Role.SolidInfill)[0]), Is.EqualTo(0.55).Within(0.02));
        Assert.That(WidthOf(Solids.Paths(layers[19], Role.TopSurface)[0]), Is.EqualTo(0.38).Within(0.02));
        var usual = Cube(Settings with { SolidInfillLineWidth = 0.55 })[19];
        Assert.That(WidthOf(Solids.Paths(usual, Role.TopSurface)[0]), Is.EqualTo(0.55).Within(0.02), "0 = as solid infill");
    }

    [Test]
    public void The_first_layer_extrudes_as_much_as_its_width_needs()
    {
        var setup = new PrintSetup { Settings = Settings }.With("first_layer_line_width_mm=140%", "skirt_loops=1", "brim_width_mm=2").OrThrow();
        var layers = Cube(setup.Settings);
        Role[] loops = [Role.OuterWall, Role.InnerWall, Role.Skirt, Role.Brim];
        Assert.That(Widths(layers[0], loops), Is.EqualTo(new[] { 0.56 }), "140 % of 0.4 mm");
        Assert.That(Widths(layers[1], loops), Is.EqualTo(new[] { 0.45 }));
        var plan = Planner.Plan([.. layers[0].Steps], setup).OrThrow();
        // (0.56 · 0.2 − (1 − π/4) · 0.2²) / (π/4 · 1.75²) for each mm.
        var wall = plan.Moves().Where(m => m.Kind == MoveKind.Print && m.Role == Role.OuterWall).ToArray();
        Assert.That(wall.Sum(m => m.E) / wall.Sum(m => m.Start.DistanceTo(m.End)), Is.EqualTo(0.1034159 / 2.4052819).Within(1e-6));
        Assert.That(Solids.Paths(layers[0], Role.OuterWall).Single().RawPoints.Min(p => p.X), Is.EqualTo(0.28).Within(1e-6));
    }

    [TestCase(0.6, 0.45, 0.5, 0.0)]
    [TestCase(0.4, 0.6, 0.4, 0.7)]
    [TestCase(0.5, 0.4, 0.6, 0.56)]
    public void A_solid_part_is_printed_with_its_volume(double outer, double inner, double solid, double first)
    {
        var settings = Settings with
        {
            InfillDensityPercent = 100, OuterWallLineWidth = outer, InnerWallLineWidth = inner, SolidInfillLineWidth = solid, FirstLayerLineWidth = first,
        };
        Assert.That(Solids.Volume(Cube(settings)), Is.EqualTo(20 * 20 * 4).Within(1).Percent);
    }

    [Test]
    public void Thin_walls_keep_their_volume_with_two_widths()
    {
        // From the width of one bead to that of four.
        for (var thickness = 0.5; thickness < 2.6; thickness += 0.15)
        {
            var settings = Settings with { OuterWallLineWidth = 0.6, InnerWallLineWidth = 0.4, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 100 };
            var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 30, thickness, 1));
            // The sides are round.
            var expected = (30 - Round) * (thickness - Round);
            Assert.That(Solids.Volume(layers), Is.EqualTo(expected).Within(2).Percent, NumberFormatter.Format(thickness, 2));
        }
    }

    [TestCase(SupportKind.Grid)]
    [TestCase(SupportKind.Tree)]
    public void Supports_have_their_width(SupportKind kind)
    {
        var settings = Settings with { Support = kind, SupportLineWidth = 0.35, FirstLayerLineWidth = 0.5, MaxBridgeLength = 0 };
        var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 6, 20, 8), Solids.Block(0, 0, 6, 20, 20, 8));
        var second = layers.Where(l => l.Layer.Index == 1).SelectMany(l => Solids.Paths(l, Role.Support)).ToArray();
        Assert.That(second.Select(WidthOf), Has.Some.EqualTo(0.35).Within(1e-6).And.All.LessThan(0.81));
        var lowest = layers.Where(l => l.Layer.Index == 0).SelectMany(l => Solids.Paths(l, Role.Support)).ToArray();
        Assert.That(lowest.Select(WidthOf), Has.Some.EqualTo(0.5).Within(1e-6));
    }

    [Test]
    public void A_raft_takes_the_width_of_the_first_layer()
    {
        var layers = Cube(Settings with { RaftLayers = 2, RaftLayerHeight = 0.2, FirstLayerLineWidth = 0.6 });
        Assert.That(layers.Take(2).Select(l => WidthOf(Solids.Paths(l, Role.Raft)[0])), Is.EqualTo(new[] { 0.6, 0.45 }).Within(1e-9));
        Assert.That(Widths(layers.First(l => Solids.Paths(l, Role.OuterWall).Length > 0), Role.OuterWall), Is.EqualTo(new[] { 0.45 }));
    }

    [Test]
    public void Percentages_follow_the_nozzle()
    {
        var setup = new PrintSetup().With("outer_wall_line_width_mm=120%", "line_width_mm=110 %", "min_wall_width_mm=50%").OrThrow();
        Assert.That((setup.Settings.OuterWallLineWidth, setup.Settings.LineWidth, setup.Settings.MinWallWidth), Is.EqualTo((0.48, 0.44, 0.2)).Within(1e-12));
        var large = setup with { Printer = new Printer { NozzleDiameter = 0.8 } };
        Assert.That((large.Settings.OuterWallLineWidth, large.Settings.LineWidth), Is.EqualTo((0.96, 0.88)).Within(1e-12));
        var json = ProfileWriter.Write(large.Settings);
        Assert.That(json, Does.Contain("\"outer_wall_line_width_mm\": \"120%\"").And.Contain("\"line_width_mm\": \"110%\""));
        var again = ProfileReader.Read<PrintSettings>(json, "again.json", "standard").OrThrow();
        Assert.That((setup with { Settings = again }).Settings.OuterWallLineWidth, Is.EqualTo(0.48).Within(1e-12));
        Assert.That(large.Values().Single(v => v.Key == "outer_wall_line_width_mm").Value, Is.EqualTo("0.96"), "what applies");
    }

    [TestCase("outer_wall_line_width_mm=wide", "profile.wrong_type", "needs a number, or a percentage of the nozzle diameter")]
    [TestCase("outer_wall_line_width_mm=-20%", "profile.wrong_type", "percentage")]
    [TestCase("outer_wall_line_width_mm=2000%", "profile.out_of_range", "at most 1000%")]
    [TestCase("infill_line_width_mm=-1", "profile.out_of_range", "0 to 1000")]
    public void Bad_values_name_their_key(string value, string code, string part)
    {
        var problem = new PrintSetup().With(value).Diagnostics.Single();
        Assert.That((problem.Code, problem.Source!.Key), Is.EqualTo((code, value.Split('=')[0])));
        Assert.That(problem.Message, Does.Contain(part));
    }

    [TestCase("infill_line_width_mm=0.15", "infill_line_width_mm")]
    [TestCase("first_layer_line_width_mm=40%", "first_layer_line_width_mm")]
    [TestCase("first_layer_line_width_mm=0.25", null)]
    public void No_width_is_less_than_its_layer_is_high(string value, string? key)
    {
        var setup = new PrintSetup { Settings = Settings with { LayerHeight = 0.2 } }.With(value).OrThrow();
        Assert.That(setup.Check().Where(d => d.Code == "setup.narrow_bead").Select(d => d.Source!.Key), Is.EqualTo(key is null ? [] : new[] { key }));
    }
}
