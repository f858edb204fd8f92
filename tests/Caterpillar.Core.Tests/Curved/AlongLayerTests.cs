using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Distances measured along layers, beads that begin on objects, and what the head allows.</summary>
public class AlongLayerTests
{
    private static readonly PrintSettings Lines = CurvedSolids.Massive with { InfillAngle = 90, InfillRotation = 0 };

    [TestCase(10)]
    [TestCase(30)]
    public void Walls_and_lines_keep_their_distance_along_a_tilted_layer(double degrees)
    {
        var slope = Angle.Sin(degrees) / Angle.Cos(degrees);
        double Plan(double x, double y) => slope * x + 20;
        var part = CurvedSolids.Between(CurvedSolids.Plan(-15, -10, 15, 10), 4, (x, y) => Plan(x, y), (x, y) => Plan(x, y) + 2);
        var layers = CurvedSolids.Slice(LayerField.Vertical(PlanSurface.Of(Plan)), Lines, part);
        Assert.That(layers, Has.Count.EqualTo(4));
        foreach (var layer in layers)
        {
            var wall = layer.Steps.First(s => s.Path.Role == Role.OuterWall).Path;
            Assert.That(wall.Points.Max(p => p.X), Is.EqualTo(15 - 0.4 * Angle.Cos(degrees)).Within(2e-3));
            Assert.That(wall.Points.Max(p => p.Y), Is.EqualTo(10 - 0.4).Within(2e-3));
            var distances = Distances(layer).Select(d => d / Angle.Cos(degrees)).ToArray();
            Assert.That(distances, Has.Length.GreaterThan(30));
            Assert.That(distances, Is.All.EqualTo(0.8).Within(0.02), "mm along the slope");
            Assert.That(CurvedSolids.Volume(layer), Is.EqualTo(30 * 20 * 0.5).Within(0.5).Percent);
            Assert.That(layer.Region.Area, Is.EqualTo(30 * 20).Within(0.1).Percent, "The region is that in plan.");
        }
    }

    [Test]
    public void Extrusions_of_a_bowl_are_as_wide_as_asked_for_wherever_it_slopes()
    {
        static double Bowl(double x, double y) => (x * x + y * y) / 50;
        var part = CurvedSolids.Between(CurvedSolids.Plan(-15, -15, 15, 15), 60, (x, y) => Bowl(x, y) + 5, (x, y) => Bowl(x, y) + 7);
        var layers = CurvedSolids.Slice(LayerField.Vertical(PlanSurface.Of(Bowl, 2)), Lines, part);
        var widths = new List<double>();
        foreach (var path in layers.SelectMany(l => l.Steps).Select(s => s.Path).Where(p => p.Role != Role.OuterWall))
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                if (path.LengthOf(i) > 0.3) widths.Add(path.BeadOf(i).Area / path.BeadOf(i).Height);
            }
        }
        widths.Sort();
        // In the corners it slopes by 40 degrees: in plan extrusions would be up to 31 % wider there.
        Assert.That(widths[widths.Count / 50], Is.GreaterThan(0.74));
        Assert.That(widths[widths.Count - widths.Count / 50], Is.LessThan(0.86));
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(part.Volume).Within(0.5).Percent);
    }

    [Test]
    public void The_first_extrusions_on_an_object_fill_what_is_open_below_them()
    {
        var part = Solids.Block(-5, -5, 2, 5, 5, 4);
        // The object lies 0.1 mm lower than the part on the left, and as high on the right.
        var onto = PlanSurface.Of((x, _) => x < 0 ? 1.9 : 2);
        var result = CurvedSolids.Try(LayerField.Of(p => p.Z, double.PositiveInfinity), CurvedSolids.Massive, new CurvedOptions { Onto = onto }, part)
            .OrThrow();
        Assert.That(result.Layers, Has.Count.EqualTo(4));
        Assert.That(CurvedSolids.Volume(result.Layers[0]), Is.EqualTo(50 * 0.6 + 50 * 0.5).Within(1).Percent);
        Assert.That(CurvedSolids.Volume(result.Layers[1]), Is.EqualTo(100 * 0.5).Within(1).Percent);
    }

    [Test]
    public void The_check_refuses_layers_beyond_the_slope_of_the_head_and_passes_those_within()
    {
        Assert.That(Codes(25), Has.None.StartsWith("collision"));
        Assert.That(Codes(50), Has.Some.StartsWith("collision"));
    }

    private static string[] Codes(double degrees)
    {
        var slope = Angle.Sin(degrees) / Angle.Cos(degrees);
        double Plan(double x, double y) => slope * (x - 80);
        var part = CurvedSolids.Between(CurvedSolids.Plan(80, 95, 120, 105), 4, Plan, (x, y) => Plan(x, y) + 3);
        var setup = new PrintSetup().With("layer_height_mm=0.5", "first_layer_height_mm=0.5", "line_width_mm=1", "nozzle_diameter_mm=0.8",
            "infill_density_percent=10",
            "curved_max_slope_deg=60").OrThrow();
        var sliced = CurvedSlicer.Slice([new NamedMesh("wedge", part)], LayerField.Vertical(PlanSurface.Of(Plan)), setup).OrThrow();
        return SafeWriter.ToDocument(Planner.Plan(sliced.ToSteps(), setup).OrThrow(), setup).Diagnostics
            .Where(d => d.Severity == Severity.Error).Select(d => d.Code).ToArray();
    }

    // Between neighboring lines that run along Y, away from the walls.
    private static double[] Distances(SlicedLayer layer)
    {
        var places = new SortedSet<double>();
        foreach (var path in layer.Steps.Select(s => s.Path).Where(p => p.Role != Role.OuterWall))
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                Vec3 a = path.Points[i], b = path.EndOf(i);
                if (Math.Abs(a.X - b.X) < 1e-3 && Math.Abs(a.Y - b.Y) > 5) places.Add(Math.Round((a.X + b.X) / 2, 4));
            }
        }
        var x = places.ToArray();
        return Enumerable.Range(0, x.Length - 1).Select(i => x[i + 1] - x[i]).Where(d => d > 0.01).ToArray();
    }
}
