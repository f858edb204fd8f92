using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

/// <summary>Places on images, limits of gaps, and angles about an axis.</summary>
public class ShapingDetailTests
{
    private static (double U, double V) At(ImageMapping mapping, double x, double y, double z, double distance = 0, int path = 0)
        => mapping(new PathSample(new Vec3(x, y, z), distance, 8, path, Role.Unspecified));

    [TestCase(6, 0, 2, 0, 0)]
    [TestCase(5, 1, 7, 0.25, 0.5)]
    [TestCase(4, 0, 12, 0.5, 1)]
    [TestCase(5, -1, 17, 0.75, 1.5)]
    public void Around_an_axis_an_image_turns_once_and_rises_with_the_height(double x, double y, double z, double u, double v)
    {
        Assert.That(At(ImageMappings.Cylinder(2, 12, new Vec3(5, 0)), x, y, z), Is.EqualTo((u, v)).Within(1e-12));
        Assert.That(At(ImageMappings.Cylinder(2, 12, new Vec3(5, 0), repeats: 3), x, y, z).U, Is.EqualTo(3 * u).Within(1e-12));
        Assert.That(At(ImageMappings.Cylinder(2, 12, new Vec3(5, 0), from: 90), x, y, z).U, Is.EqualTo((u + 0.75) % 1).Within(1e-12));
    }

    [TestCase(6, 0, 3, 0, 0.5)]
    [TestCase(5, 2, 5, 0.25, 0.75)]
    [TestCase(5, 0, 9, 0, 1)]
    [TestCase(4, 0, 2, 0.5, 0.25)]
    [TestCase(5, -1, 3, 0.75, 0.5)]
    public void A_globe_has_longitudes_and_latitudes(double x, double y, double z, double u, double v)
        => Assert.That(At(ImageMappings.Globe(new Vec3(5, 0, 3)), x, y, z), Is.EqualTo((u, v)).Within(1e-12));

    [Test]
    public void A_plan_lies_on_its_rectangle_and_rows_follow_the_paths()
    {
        Assert.That(At(ImageMappings.Plan(new Vec3(10, 20), 40, 5), 20, 22, 9), Is.EqualTo((0.25, 0.4)).Within(1e-12));
        Assert.That(At(ImageMappings.Along(4), 0, 0, 0, distance: 2, path: 5), Is.EqualTo((0.25, 0.375)).Within(1e-12));
        Assert.That(ImageMappings.Along(4)(new PathSample(Vec3.Zero, 0, 0, 3, Role.Unspecified)), Is.EqualTo((0.0, 0.875)));
    }

    [TestCase(0)]
    [TestCase(-1)]
    [TestCase(double.NaN)]
    public void Limits_of_gaps_are_positive(double bad)
    {
        Assert.That(() => new GapBead { MinGap = bad }, Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new GapBead { MaxGap = bad }, Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new GapBead { AirGap = bad }, Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new GapBead { Resolution = bad }, Throws.InstanceOf<ArgumentOutOfRangeException>());
        if (bad != 0) Assert.That(() => new GapBead { Width = bad }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(0.03, 0.05, "gap.narrow")]
    [TestCase(0.4, 0.4, null)]
    [TestCase(0.999, 0.999, null)]
    [TestCase(1.5, 1, "gap.wide")]
    [TestCase(3.5, null, "gap.air")]
    public void By_default_gaps_are_filled_from_a_twentieth_of_a_millimeter_to_one(double height, double? filled, string? code)
    {
        var path = new PrintPath([new Vec3(0, 0, height), new Vec3(7, 0, height)], new Bead(0.1, 0.2));
        var shaped = new GapBead { Shape = BeadShape.Rectangle }.Apply([path]);
        Assert.That(shaped.Diagnostics.Select(d => d.Code), Is.EqualTo(code is null ? [] : new[] { code }));
        Assert.That(shaped.OrThrow()[0].SegmentCount, Is.EqualTo(1), "One gap, one segment.");
        Assert.That(shaped.OrThrow()[0].BeadOf(0).Area, Is.EqualTo(0.5 * (filled ?? 0.2)).Within(1e-9));
    }

    [Test]
    public void Paths_are_divided_before_they_are_modulated_but_not_without_end()
    {
        var path = new PrintPath([Vec3.Zero, new Vec3(10, 0)], new Bead(0.1, 0.2, 40));
        Modulation Of(double resolution) => new(ModulationMode.Flow, p => p.Position.X / 10, 0.8, 1.2) { Resolution = resolution };
        var parts = Of(2.5).Apply([path]).OrThrow()[0];
        Assert.That(Enumerable.Range(0, 4).Select(i => parts.BeadOf(i).Area), Is.EqualTo(new[] { 0.085, 0.095, 0.105, 0.115 }).Within(1e-9));
        Assert.That(Of(0).Apply([path]).OrThrow()[0].SegmentCount, Is.EqualTo(1));
        Assert.That(Of(1e-9).Apply([path]).Diagnostics.Single().Code, Is.EqualTo("shape.too_fine"));
        Assert.That(Of(2.5).Apply([path]).Diagnostics, Is.Empty, "0.85 to 1.15 is above 0.6.");
        Assert.That(new Modulation(ModulationMode.Flow, p => p.Position.X / 10, 0.1, 1) { Resolution = 2.5 }.Apply([path]).Diagnostics.Single().Code,
            Is.EqualTo("shape.modulation_ratio"));
    }

    [Test]
    public void A_path_that_begins_on_the_axis_has_the_angle_of_its_first_point_off_it()
    {
        var seen = new List<Vec3>();
        var map = Deformation.Cylindrical(p =>
        {
            seen.Add(p);
            return p;
        }, axis: new Vec3(5, 0));
        var mapped = map.Map([new Vec3(5, 0), new Vec3(5, 0, 1), new Vec3(5, 10), new Vec3(-5, 0), new Vec3(5, -10), new Vec3(15, 0), new Vec3(5, 0)]);
        Assert.That(seen.Select(p => p.X), Is.EqualTo(new[] { 0.0, 0, 10, 10, 10, 10, 0 }).Within(1e-12));
        Assert.That(seen.Select(p => p.Y), Is.EqualTo(new[] { 90.0, 90, 90, 180, 270, 360, 360 }).Within(1e-12));
        Assert.That(mapped[4].DistanceTo(new Vec3(5, -10)), Is.LessThan(1e-12));
        Assert.That(Deformation.Cylindrical(p => p).Map([Vec3.Zero, new Vec3(0, 0, 1)])[1], Is.EqualTo(new Vec3(0, 0, 1)));
    }
}
