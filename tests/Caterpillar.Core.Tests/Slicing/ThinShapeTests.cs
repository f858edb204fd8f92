using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Solid prints of thin shapes have the volume of the shape, through all stages of slicing.</summary>
[TestFixture]
public class ThinShapeTests
{
    [Test]
    public void Thin_shapes_are_printed_in_full(
        [Values(0.4, 0.45, 0.6)] double width, [Values(1, 2)] int walls, [Values(BeadShape.Rectangle, BeadShape.Stadium)] BeadShape shape)
    {
        const double Height = 0.2;
        var settings = new PrintSetup().With(
        [
            FormattableString.Invariant($"line_width_mm={width}"), $"wall_count={walls}", "infill_density_percent=100", "layer_height_mm=0.2",
            "first_layer_height_mm=0.2", "top_layers=0", "bottom_layers=0", "top_thickness_mm=0", "bottom_thickness_mm=0", "skirt_loops=0", "seam_gap_mm=0",
        ]).Value!.Settings with { BeadShape = shape };
        var edge = shape == BeadShape.Stadium ? (1 - Math.PI / 4) * Height / 2 : 0;
        foreach (var (name, region) in Shapes())
        {
            var layer = Solids.Slice(settings, Prism.On(region, 3 * Height))[1];
            var full = layer.Steps.Sum(s => s.Path.Volume) / (region.Offset(-edge).Area * Height);
            Assert.That(full, Is.EqualTo(1).Within(0.03), name);
        }
    }

    private static IEnumerable<(string Name, Region Region)> Shapes()
    {
        foreach (var length in new[] { 8, 20 }) yield return ($"wedge of {length} mm", WallShapes.Wedge(0.3, 3, length));
        foreach (var tips in new[] { 5, 7 }) yield return ($"star of {tips}", WallShapes.Star(tips, 6, 2.5));
        foreach (var percent in new[] { 30, 55, 90, 130, 180 }) yield return ($"ring of {percent} % of a mm", WallShapes.Ring(4, percent / 100.0));
        foreach (var (letter, region) in WallShapes.Letters()) yield return ($"letter {letter}", region);
    }
}
