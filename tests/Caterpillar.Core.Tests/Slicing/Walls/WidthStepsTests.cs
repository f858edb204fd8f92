using Caterpillar.Geometry;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Walls;

public class WidthStepsTests
{
    [Test]
    public void Segments_are_divided_so_that_the_width_changes_little_in_each()
    {
        // 0.12 wider over 3 mm: three pieces; as wide at the end as in the middle: one.
        var (points, widths) = WidthSteps.Split([Vec3.Zero, new Vec3(3, 0), new Vec3(5, 0)], [0.4, 0.52, 0.52], false, 0.05, 0.1);
        Assert.That(points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(1, 0), new Vec3(2, 0), new Vec3(3, 0), new Vec3(5, 0) }));
        Assert.That(widths, Is.EqualTo(new[] { 0.4, 0.44, 0.48, 0.52, 0.52 }).Within(1e-12));
    }

    [Test]
    public void The_segment_that_closes_a_path_is_divided_too()
    {
        var (points, widths) = WidthSteps.Split([Vec3.Zero, new Vec3(4, 0), new Vec3(4, 3)], [0.5, 0.5, 0.4], true, 0.05, 0.1);
        Assert.That(points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(4, 0), new Vec3(4, 1.5), new Vec3(4, 3), new Vec3(2, 1.5) }));
        Assert.That(widths, Is.EqualTo(new[] { 0.5, 0.5, 0.45, 0.4, 0.45 }).Within(1e-12));
    }

    [Test]
    public void Pieces_are_not_shorter_than_asked()
    {
        // Six steps of width would fit; two pieces of 0.1 mm do.
        var (points, _) = WidthSteps.Split([Vec3.Zero, new Vec3(0.25, 0)], [0.3, 0.6], false, 0.05, 0.1);
        Assert.That(points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(0.125, 0), new Vec3(0.25, 0) }));
        (points, _) = WidthSteps.Split([Vec3.Zero, new Vec3(0.05, 0)], [0.3, 0.6], false, 0.05, 0.1);
        Assert.That(points, Has.Length.EqualTo(2));
    }

    [Test]
    public void Paths_of_nearly_one_width_stay_as_they_are()
    {
        Vec3[] points = [Vec3.Zero, new Vec3(3, 0)];
        var result = WidthSteps.Split(points, [0.40, 0.45], false, 0.05, 0.1);
        Assert.That(result.Points, Is.SameAs(points));
    }
}
