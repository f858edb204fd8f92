using System;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Cross-sections of extrusions.</summary>
public class BeadTests
{
    [TestCase(BeadShape.Rectangle, 0.4, 0.2, 0.08)]
    [TestCase(BeadShape.Stadium, 0.4, 0.2, 0.2 * 0.2 + Math.PI / 4 * 0.04)]
    [TestCase(BeadShape.Stadium, 0.2, 0.2, Math.PI / 4 * 0.04)]
    [TestCase(BeadShape.Circle, 0.4, 0.2, Math.PI / 4 * 0.16)]
    public void The_area_follows_from_width_and_height_and_back(BeadShape shape, double width, double height, double area)
    {
        var bead = Bead.FromWidth(width, height, 1, 30, shape);
        Assert.That(bead.Area, Is.EqualTo(area).Within(1e-12));
        Assert.That((bead.Height, bead.Speed), Is.EqualTo((height, 30.0)));
        Assert.That(bead.Width(shape), Is.EqualTo(width).Within(1e-12));
        Assert.That(Bead.FromWidth(width, height, 2, 30, shape).Area, Is.EqualTo(2 * area).Within(1e-12));
    }

    [Test]
    public void Without_a_height_or_enough_area_a_extrusion_is_round()
    {
        Assert.That(new Bead(Math.PI).Width(), Is.EqualTo(2).Within(1e-12));
        Assert.That(new Bead(Math.PI).Width(BeadShape.Stadium), Is.EqualTo(2).Within(1e-12));
        // A stadium narrower than high would be no stadium: 0.03 mm² at 0.2 mm are a circle of 0.195 mm.
        Assert.That(new Bead(0.03, 0.2).Width(BeadShape.Stadium), Is.EqualTo(2 * Math.Sqrt(0.03 / Math.PI)).Within(1e-12));
        Assert.That(new Bead(0.03, 0.2).Width(), Is.EqualTo(0.15).Within(1e-12));
        Assert.That(() => Bead.FromWidth(0.19, 0.2, shape: BeadShape.Stadium), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(-1.0)]
    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    public void Values_of_a_bead_are_finite_and_not_negative(double wrong)
    {
        Assert.That(() => new Bead(wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Bead(1, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Bead(1, 1, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => Bead.FromWidth(wrong, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => Bead.FromWidth(1, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => Bead.FromWidth(1, 1, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Bead(1) with { Speed = wrong }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(0.12345, 0, 0, "0.1235 mm²")]
    [TestCase(0.08, 0.2, 0, "0.08 mm², 0.2 mm high")]
    [TestCase(0.08, 0.20004, 30.0004, "0.08 mm², 0.2 mm high, 30 mm/s")]
    [TestCase(0, 0, 30, "0 mm², 30 mm/s")]
    public void A_bead_is_shown_with_what_is_known_of_it(double area, double height, double speed, string text)
    {
        Assert.That(new Bead(area, height, speed).ToString(), Is.EqualTo(text));
        Assert.That(new Bead(area, height, speed) with { Area = 0.5 }, Is.EqualTo(new Bead(0.5, height, speed)));
        Assert.That(new Bead(area, height, speed) with { Speed = 0.5 }, Is.EqualTo(new Bead(area, height, 0.5)));
    }
}
