using System;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Display;

public class HeadMeshTests
{
    // Cones from 0.5 to 4 and to 20 mm, each 6 mm high, with 24 corners: a circle of radius r has 12 sin 15° of r².
    [Test]
    public void The_head_is_closed_and_has_the_volume_of_its_cones()
    {
        var mesh = HeadMesh.Of(new Printer { HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6), new(20, 12)) });
        Assert.That(mesh.Topology.IsWatertight, Is.True);
        Assert.That(mesh.Volume, Is.EqualTo(12 * Angle.Sin(15) * 2 * (0.25 + 2 + 16 + 16 + 80 + 400)).Within(1e-9), "outward");
        Assert.That(mesh.Bounds, Is.EqualTo(new Bounds(new Vec3(-20, -20, 0), new Vec3(20, 20, 12))));
    }

    [Test]
    public void A_sharp_tip_and_boxes_are_closed_too()
    {
        var printer = new Printer
        {
            HeadOutline = new(new HeadPoint(0, 0), new(4, 6)), HeadBoxes = new(new Bounds(new Vec3(30, -5, 8), new Vec3(50, 5, 60))),
        };
        var mesh = HeadMesh.Of(printer);
        Assert.That(mesh.Topology.IsWatertight, Is.True);
        Assert.That(mesh.Volume, Is.EqualTo(12 * Angle.Sin(15) * 2 * 16 + 20 * 10 * 52).Within(1e-6));
    }

    [Test]
    public void A_head_without_height_has_its_boxes_alone()
    {
        var flat = new Printer { HeadOutline = new(new HeadPoint(0.5, 0)) };
        Assert.That(HeadMesh.Of(flat).TriangleCount, Is.Zero);
        var boxed = flat with { HeadBoxes = new(new Bounds(new Vec3(0, -5, 8), new Vec3(50, 5, 60))) };
        Assert.That((HeadMesh.Of(boxed).TriangleCount, HeadMesh.Of(boxed).Volume), Is.EqualTo((12, 50 * 10 * 52)).Within(1e-9));
        Assert.That(() => HeadMesh.Of(null!), Throws.InstanceOf<ArgumentNullException>());
    }
}
