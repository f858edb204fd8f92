using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>Where models come to stand, and what the start code and projects add to them.</summary>
[Category("Arithmetic")]
public class PlacedModelTests
{
    private static readonly PrintSetup Setup = new();

    private static NamedMesh Box(double x, double y, double z, Vec3 at = default) => new("box", MeshMaker.Box(at.X, at.Y, at.Z, at.X + x, at.Y + y, at.Z + z));

    private static Bounds Placed(ModelPlacing placing, params NamedMesh[] models)
        => ModelPlacement.BoxOf(placing.Place(models, Setup).OrThrow());

    private static void Same(Bounds box, Vec3 min, Vec3 max) => Assert.That((box.Min - min).Length + (box.Max - max).Length, Is.LessThan(1e-9), box.ToString());

    [Test]
    public void A_model_comes_to_the_center_and_down_to_the_bed()
    {
        var model = Box(10, 20, 30, new Vec3(5, 5, 7));
        Same(Placed(new ModelPlacing(), model), new Vec3(105, 100, 0), new Vec3(115, 120, 30));
        Same(Placed(new ModelPlacing { Center = new Vec3(50, 60) }, model), new Vec3(45, 50, 0), new Vec3(55, 70, 30));
        Same(Placed(new ModelPlacing { KeepPosition = true }, model), new Vec3(5, 5, 7), new Vec3(15, 25, 37));
    }

    [Test]
    public void It_is_scaled_turned_and_laid_flat_before()
    {
        var model = Box(10, 20, 30);
        Same(Placed(new ModelPlacing { Scale = new Vec3(2, 1, 1) }, model), new Vec3(100, 100, 0), new Vec3(120, 120, 30));
        Same(Placed(new ModelPlacing { Size = new Vec3(10, 10, 10) }, model), new Vec3(105, 105, 0), new Vec3(115, 115, 10));
        Same(Placed(new ModelPlacing { LongestSide = 60 }, model), new Vec3(100, 90, 0), new Vec3(120, 130, 60));
        Same(Placed(new ModelPlacing { Rotate = new Vec3(0, 0, 90) }, model), new Vec3(100, 105, 0), new Vec3(120, 115, 30));
        Assert.That(Placed(new ModelPlacing { LayFlat = true }, model).Size.Z, Is.EqualTo(10).Within(1e-9));
    }

    [Test]
    public void What_does_not_fit_is_reported_and_heads_need_room_between_objects()
    {
        Assert.That(new ModelPlacing().Place([Box(300, 10, 10)], Setup).Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "models.too_large" }));
        var near = new[] { Box(10, 10, 40, new Vec3(100, 100)), Box(10, 10, 40, new Vec3(112, 100)) };
        var keep = new ModelPlacing { KeepPosition = true };
        Assert.That(keep.Place(near, Setup).Diagnostics, Is.Empty);
        var inTurn = Setup with { Settings = Setup.Settings with { PrintSequence = PrintSequence.ByObject } };
        Assert.That(keep.Place(near, inTurn).Value, Is.Null, "The head would hit the first one.");
        Assert.That(keep.Place([near[0], Box(10, 10, 40, new Vec3(10, 10))], inTurn).Value, Is.Not.Null);
    }

    [Test]
    public void Bodies_that_are_not_printed_move_along()
    {
        var placed = new ModelPlacing().Place([Box(10, 10, 10), Box(500, 5, 5, new Vec3(0, 0, -5))], Setup, [true, false]).OrThrow();
        Same(placed[0].Mesh.Bounds, new Vec3(105, 105, 0), new Vec3(115, 115, 10));
        Same(placed[1].Mesh.Bounds, new Vec3(105, 105, -5), new Vec3(605, 110, 0));
    }

    [TestCase("G28\nM109 S200\nM83\nG1 X10 Y20 Z0.3 F3000\nG1 X60 E5", 9.8, 19.8, 60.2, 20.2)]
    [TestCase("G28\nM109 S200\nM83\nG1 X10 Y20 Z0.3 F3000\nG1 X60 E5\nG1 X90\nG1 E-5\nG1 X120 E-1", 9.8, 19.8, 60.2, 20.2)]
    public void The_bed_is_primed_where_the_start_code_extrudes(string start, double left, double front, double right, double back)
    {
        var setup = Setup with { Printer = Setup.Printer with { StartGCode = new(start.Split('\n')) } };
        Same(PrimedArea.Of(setup), new Vec3(left, front, 0.3), new Vec3(right, back, 0.3));
        Assert.That(PrimedArea.Excluded(setup).ExcludedAreas.Count, Is.EqualTo(setup.Printer.ExcludedAreas.Count + 1));
    }

    [TestCase("G28\nM83\nG1 X10 Y20 Z0.3\nG1 X60")]
    [TestCase("G28")]
    public void A_start_code_that_does_not_extrude_primes_nothing(string start)
    {
        var setup = Setup with { Printer = Setup.Printer with { StartGCode = new(start.Split('\n')) } };
        Assert.That(PrimedArea.Of(setup).IsEmpty, Is.True);
        Assert.That(PrimedArea.Excluded(setup), Is.SameAs(setup.Printer));
    }
}
