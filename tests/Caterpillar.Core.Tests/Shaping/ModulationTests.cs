using System;
using System.Linq;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

public class ModulationTests
{
    // Left half black, right half white.
    private static readonly GrayImage TwoHalves = new(2, 1, [0, 1]);

    private static readonly PrintPath Line = new([Vec3.Zero, new Vec3(20, 0, 0)], new Bead(0.4, 0.2, 30)) { Role = Role.OuterWall };

    [Test]
    public void Speed_changes_at_a_constant_flow()
    {
        var field = Fields.Image(TwoHalves, ImageMappings.Plan(Vec3.Zero, 20, 20));
        var path = new Modulation(ModulationMode.Speed, field, 1, 0.6) { Resolution = 1 }.Apply([Line]).Value!.Single();
        Assert.That(path.SegmentCount, Is.EqualTo(20));
        Assert.That(Enumerable.Range(0, 10).Select(i => path.BeadOf(i)), Is.All.EqualTo(new Bead(0.4, 0.2, 30)));
        Assert.That(Enumerable.Range(10, 10).Select(i => path.BeadOf(i).Speed), Is.All.EqualTo(18).Within(1e-12));
        Assert.That(Enumerable.Range(0, 20).Select(i => path.BeadOf(i).Speed * path.BeadOf(i).Area), Is.All.EqualTo(12).Within(1e-12));
        Assert.That(path.Role, Is.EqualTo(Role.OuterWall));
    }

    [Test]
    public void Flow_changes_at_a_constant_speed_and_a_mask_limits_it()
    {
        var modulation = new Modulation(ModulationMode.Flow, _ => 1, 1, 1.5) { Resolution = 2,
            Mask = place => place.Position.X <= 10 ? 1 : 0 };
        var path = modulation.Apply([Line]).Value!.Single();
        Assert.That(Enumerable.Range(0, 5).Select(i => path.BeadOf(i).Area), Is.All.EqualTo(0.6).Within(1e-12));
        Assert.That(Enumerable.Range(5, 5).Select(i => path.BeadOf(i)), Is.All.EqualTo(new Bead(0.4, 0.2, 30)));
    }

    [Test]
    public void Displacement_moves_to_the_left_or_up()
    {
        var left = new Modulation(ModulationMode.DisplaceLeft, place => place.Position.X / 20, 0, 2) { Resolution = 5 }.Apply([Line]).Value!.Single();
        Assert.That(left.Points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(5, 0.5), new Vec3(10, 1), new Vec3(15, 1.5), new Vec3(20, 2) }));
        var up = new Modulation(ModulationMode.DisplaceUp, _ => 1, 0, 0.3).Apply([Line]).Value!.Single();
        Assert.That(up.Points.Select(p => p.Z), Is.All.EqualTo(0.3));
    }

    [Test]
    public void A_circle_displaced_to_the_left_shrinks_evenly()
    {
        // Counterclockwise: left is inward. The vertices of a regular polygon move along their radius.
        var points = Enumerable.Range(0, 36).Select(i => new Vec3(10 * Basics(i).Cos, 10 * Basics(i).Sin));
        var circle = new PrintPath(points, new Bead(1), closed: true);
        var smaller = new Modulation(ModulationMode.DisplaceLeft, _ => 1, 0, 1).Apply([circle]).Value!.Single();
        Assert.That(smaller.IsClosed, Is.True);
        Assert.That(smaller.Points.Select(p => p.Length), Is.All.EqualTo(9).Within(1e-12));

        static (double Sin, double Cos) Basics(int i) => Caterpillar.Basics.Angle.SinCos(10 * i);
    }

    [Test]
    public void A_ratio_that_prints_badly_is_a_warning()
    {
        var field = Fields.Image(TwoHalves, ImageMappings.Plan(Vec3.Zero, 20, 20));
        Assert.That(new Modulation(ModulationMode.Speed, field, 1, 0.6) { Resolution = 1 }.Apply([Line]).Diagnostics, Is.Empty);
        Assert.That(new Modulation(ModulationMode.Speed, field, 1, 0.5) { Resolution = 1 }.Apply([Line]).Diagnostics.Single().Code,
            Is.EqualTo("shape.modulation_ratio"));
    }

    [Test]
    public void A_globe_is_read_by_longitude_and_latitude()
    {
        var map = new GrayImage(4, 2, [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]);
        var field = Fields.Image(map, ImageMappings.Globe(new Vec3(0, 0, 10)));
        double At(double x, double y, double z) => field(new PathSample(new Vec3(x, y, z), 0, 1, 0, Role.Unspecified));
        Assert.That(At(1, 0.1, 11), Is.EqualTo(0));
        Assert.That(At(-0.1, 1, 11), Is.EqualTo(0.1));
        Assert.That(At(-1, -0.1, 9), Is.EqualTo(0.6));
        Assert.That(At(0.1, -1, 9), Is.EqualTo(0.7));
        var repeated = Fields.Image(map, ImageMappings.Cylinder(0, 10, repeats: 2));
        Assert.That(repeated(new PathSample(new Vec3(-1, -0.01, 9), 0, 1, 0, Role.Unspecified)), Is.EqualTo(0));
    }

    [Test]
    public void Between_pixels_the_brightness_is_linear()
    {
        var field = Fields.Image(new GrayImage(4, 1, [0, 1, 0, 0]), ImageMappings.Plan(Vec3.Zero, 4, 1), smooth: true);
        Assert.That(field(new PathSample(new Vec3(1, 0.5), 0, 1, 0, Role.Unspecified)), Is.EqualTo(0.5).Within(1e-12));
        Assert.That(field(new PathSample(new Vec3(1.5, 0.5), 0, 1, 0, Role.Unspecified)), Is.EqualTo(1).Within(1e-12));
    }

    [Test]
    public void Fields_without_a_value_and_paths_without_a_speed_are_errors()
    {
        var nan = new Modulation(ModulationMode.Flow, _ => double.NaN, 1, 2).Apply([Line]);
        Assert.That((nan.Value, nan.Diagnostics.Single().Code), Is.EqualTo(((object?)null, "shape.field")));
        var slow = new Modulation(ModulationMode.Speed, _ => 1, 1, 0.8).Apply([new PrintPath([Vec3.Zero, new Vec3(1, 0)], new Bead(1))]);
        Assert.That(slow.Diagnostics.Single().Code, Is.EqualTo("shape.no_speed"));
        var zero = new Modulation(ModulationMode.Speed, _ => 1, 1, 0).Apply([Line]);
        Assert.That(zero.Diagnostics.Single().Code, Is.EqualTo("shape.modulation"));
    }

    [Test]
    public void Fields_and_masks_count_from_0_to_1()
    {
        Bead Of(double field, double? mask = null) => new Modulation(ModulationMode.Flow, _ => field, 0.5, 1.5)
            { Mask = mask is { } m ? new Field(_ => m) : null }.Apply([Line]).Value!.Single().BeadOf(0);
        Assert.That(Of(-3).Area, Is.EqualTo(0.4 * 0.5).Within(1e-12));
        Assert.That(Of(1.7).Area, Is.EqualTo(0.4 * 1.5).Within(1e-12));
        Assert.That(Of(1, 0.5).Area, Is.EqualTo(0.4 * 1.25).Within(1e-12));
        Assert.That(Of(1, 1.7).Area, Is.EqualTo(0.4 * 1.5).Within(1e-12));
    }

    [TestCase(ModulationMode.Flow, 0, true)]
    [TestCase(ModulationMode.Flow, -0.1, false)]
    [TestCase(ModulationMode.Speed, 0, false)]
    [TestCase(ModulationMode.Speed, 0.1, true)]
    public void A_flow_may_stop_and_a_speed_may_not(ModulationMode mode, double factor, bool works)
        => Assert.That(new Modulation(mode, _ => 0, factor, 1).Apply([Line]).Value is not null, Is.EqualTo(works));

    [Test]
    public void Rows_along_paths_repeat_and_a_path_without_length_is_at_its_beginning()
    {
        var mapping = ImageMappings.Along(4);
        PathSample At(double distance, double length, int path) => new(Vec3.Zero, distance, length, path, Role.Infill);
        Assert.That(mapping(At(5, 20, 0)), Is.EqualTo((0.25, 0.125)));
        Assert.That(mapping(At(20, 20, 3)), Is.EqualTo((1.0, 0.875)));
        Assert.That(mapping(At(20, 20, 5)), Is.EqualTo((1.0, 0.375)));
        Assert.That(mapping(At(0, 0, 1)), Is.EqualTo((0.0, 0.375)));
    }
}
