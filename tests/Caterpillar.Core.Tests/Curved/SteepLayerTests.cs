using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Layers steeper than 45 degrees, for heads that allow it.</summary>
public class SteepLayerTests
{
    // A loop of 20 mm in plan, tilted about Y.
    private static PathStep Loop(double slope)
    {
        var rise = Angle.Sin(slope) / Angle.Cos(slope);
        var points = Solids.Circle(10, 48).Select(p => p.WithZ(20 + rise * p.X)).ToArray();
        return new PathStep(new PrintPath(points, Enumerable.Range(1, 48).Select(i => new Bead(0.01 * i, 0.2)), closed: true), new StepGroup(3));
    }

    [TestCase(44)]
    [TestCase(-44)]
    public void Loops_that_are_less_steep_stay_whole(double slope)
    {
        var loop = Loop(slope);
        Assert.That(UphillPaths.Of(loop).Single(), Is.SameAs(loop));
    }

    [TestCase(50)]
    [TestCase(-60)]
    public void A_steep_loop_is_printed_upward_on_both_sides(double slope)
    {
        var loop = Loop(slope);
        var parts = UphillPaths.Of(loop).ToArray();
        Assert.That(parts, Has.Length.EqualTo(2));
        Assert.That(parts[0].Path.Points[12].Y, Is.GreaterThan(9), "the side that the loop begins with");
        foreach (var part in parts)
        {
            Assert.That((part.KeepStart, part.Path.IsClosed, part.Group), Is.EqualTo((true, false, loop.Group)));
            Assert.That(part.Path.Points.Zip(part.Path.Points.Skip(1), (a, b) => b.Z - a.Z).Min(), Is.GreaterThan(-0.1));
        }
        Assert.That(parts.Sum(p => p.Path.Length), Is.EqualTo(loop.Path.Length).Within(1e-9));
        Assert.That(parts.Sum(p => p.Path.Volume), Is.EqualTo(loop.Path.Volume).Within(1e-9), "each segment keeps its extrusion");
    }

    [Test]
    public void Only_steep_descents_of_an_open_path_are_turned()
    {
        Vec3[] points = [new(0, 0, 1), new(5, 0, 4), new(10, 0, 2), new(12, 0, -2), new(15, 0, -3), new(20, 0, 5)];
        var parts = UphillPaths.Of(new PathStep(new PrintPath(points, Enumerable.Range(1, 5).Select(i => new Bead(i, 1)), closed: false))).ToArray();
        Assert.That(parts.Select(p => (p.Path.Start.X, p.Path.End.X)), Is.EqualTo(new[] { (0.0, 5.0), (15.0, 5.0), (15.0, 20.0) }));
        Assert.That(Enumerable.Range(0, 3).Select(i => parts[1].Path.BeadOf(i).Area), Is.EqualTo(new[] { 4.0, 3, 2 }));
    }

    // An open tube whose upper end leans by 53 degrees, for clay: a slender nozzle prints it, and one that is told to be too blunt by a fraction does not.
    [TestCase(2.5, 22, 300, true)]
    [TestCase(2.5, 51, 60, false)]
    public void A_tube_with_a_steep_end_is_printed_by_a_slender_nozzle_without_a_collision(double tip, double radius, double height, bool passes)
    {
        var rise = Angle.Sin(53.0) / Angle.Cos(53.0);
        var low = Solids.Circle(14, 24).Select(p => p + new Vec3(100, 100)).ToArray();
        var high = low.Select(p => p.WithZ(40 + rise * (p.X - 100))).ToArray();
        var triangles = Enumerable.Range(0, 24).SelectMany(i => new[] { i, (i + 1) % 24, 24 + i, 24 + i, (i + 1) % 24, 24 + (i + 1) % 24 }).ToArray();
        var tube = TriMesh.Create([.. low, .. high], triangles);
        var setup = new ProfileLibrary().Setup("potter_super").OrThrow();
        var head = new ValueList<HeadPoint>(new HeadPoint(tip, 0), new HeadPoint(radius, height));
        setup = setup with { Printer = setup.Printer with { HeadOutline = head } };
        var field = LayerField.Harmonic(MeshBoundaries.Find(tube).OrThrow());
        var job = PrintJob.Slice([new SliceModel(new NamedMesh("tube", tube), setup.Settings)], field, setup);
        if (!passes)
        {
            Assert.That(job.Diagnostics.Single(d => d.Severity == Severity.Error).Code, Is.EqualTo("curved.too_steep"));
            return;
        }
        var found = PrintCheck.Run(job.OrThrow().Toolpath, setup);
        Assert.That(found.Where(d => d.Severity == Severity.Error), Is.Empty);
        Assert.That(job.Value!.Toolpath.Moves().Count(m => m.Deposited > 0), Is.GreaterThan(500));
    }
}
