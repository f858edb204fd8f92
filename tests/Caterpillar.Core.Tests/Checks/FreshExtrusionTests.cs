using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>
/// A head that comes back to what it has just printed: an extrusion is fresh for 1.4 mm of motion and stops to be so in two pieces. The flat of the tip has a
/// radius of 0.5 mm.
/// </summary>
public class FreshExtrusionTests
{
    private static readonly PrintSetup Plain = SmallPrint.Setup();

    // An extrusion of 1 mm, and a travel back along it that sinks by 2 mm: after 0.7 mm the head is beside the older piece, and below it.
    [TestCase(-9)]
    [TestCase(-0.2)]
    public void A_head_that_sinks_into_the_extrusion_it_has_just_printed_is_found(double x)
    {
        var print = new SmallPrint(50, 50, 5).Print(51, 50, 5).Go(50 + x, 50, 3);
        var found = SmallPrint.Find(print.Build(), Plain, "collision.").Single();
        Assert.That((found.Code, found.Source!.Move, found.Count), Is.EqualTo((CheckCodes.TravelHits, (int?)1, 1)));
    }

    // The extrusion that stops to be fresh lies before the start of the travel or beyond its end: it is not touched, however long the travel is.
    [TestCase(9, 4.5)]
    [TestCase(9, 3)]
    [TestCase(0.5, 4.7)]
    [TestCase(1.2, 4.4)]
    public void A_head_that_sinks_away_from_its_extrusion_is_not(double x, double z)
    {
        var ahead = new SmallPrint(50, 50, 5).Print(50.4, 50, 5).Go(51.5, 50, 5).Go(51.5 + x, 50, z);
        Assert.That(SmallPrint.Find(ahead.Build(), Plain, "collision."), Is.Empty);
    }

    // Boxes of the head reach to both sides at 0.5 mm above the tip: what the nozzle misses they hit as soon as it is no longer fresh.
    [Test]
    public void A_box_of_the_head_hits_what_is_no_longer_fresh()
    {
        var setup = SmallPrint.Setup(p => p with
        {
            HeadBoxes = new(new Bounds(new Vec3(-30, -30, 0.5), new Vec3(30, 30, 9))), HeadOutline = new(new HeadPoint(0.01, 0), new(0.02, 6)),
        });
        var print = new SmallPrint(50, 50, 5).Print(51, 50, 5).Go(51, 54, 3);
        var found = SmallPrint.Find(print.Build(), setup, "collision.").Single();
        Assert.That((found.Code, found.Source!.Move, found.Count), Is.EqualTo((CheckCodes.HeadHits, (int?)1, 1)));
        Assert.That(found.Message, Does.EndWith("to (51, 54, 3). Keep more distance, or print the higher part later."));
    }

    // An arc of 100 mm radius in five chords of 3.5 mm; what crosses only its first or only its last chord hits it.
    [TestCase(0.5)]
    [TestCase(5)]
    [TestCase(9.5)]
    public void Every_chord_of_an_arc_is_printed(double degrees)
    {
        var (sin, cos) = Angle.SinCos(10.0);
        var print = new SmallPrint(150, 50, 5).Arc(50 + 100 * cos, 50 + 100 * sin, 5, new Vec3(50, 50, 5), 10, SmallPrint.Area);
        (sin, cos) = Angle.SinCos(degrees);
        print.Go(print.At.X, print.At.Y, 50).Go(50 + 90 * cos, 50 + 90 * sin, 50).Go(50 + 90 * cos, 50 + 90 * sin, 4.8).Go(50 + 110 * cos, 50 + 110 * sin, 4.8);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision.").Select(d => (d.Code, d.Source!.Move)),
            Is.EqualTo(new[] { (CheckCodes.TravelHits, (int?)4) }));
        var without = new SmallPrint(150, 50, 5).Go(140, 50, 50);
        Assert.That(SmallPrint.Find(without.Build(), Plain, "collision."), Is.Empty);
    }
}
