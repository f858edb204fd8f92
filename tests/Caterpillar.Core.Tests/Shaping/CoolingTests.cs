using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

public class CoolingTests
{
    [Test]
    public void By_length_the_speed_is_the_length_plus_one()
    {
        // The skewed pyramid of Kanada 2015: speed(linelen + 1).
        var path = new PrintPath([Vec3.Zero, new Vec3(30, 0), new Vec3(30, 9), new Vec3(29, 9)], new Bead(0.2, 0, 25));
        var cooled = new Cooling { SpeedByLength = true, MinPrintSpeed = 3 }.Apply([path]).Value!.Single();
        Assert.That(Enumerable.Range(0, 3).Select(i => cooled.BeadOf(i).Speed), Is.EqualTo(new double[] { 25, 10, 3 }));
        Assert.That(cooled.Volume, Is.EqualTo(path.Volume));
    }

    [Test]
    public void A_small_layer_takes_its_minimum_time()
    {
        // 40 mm at 40 mm/s and 20 mm at 10 mm/s take 3 s; 6 s are half the speeds.
        PrintPath[] layer = [Line(0, 40, 0.2, 40), Line(0, 20, 0.2, 10)];
        var cooled = new Cooling { MinLayerTime = 6, MinPrintSpeed = 1 }.Apply(layer).Value!;
        Assert.That(cooled.Select(p => p.BeadOf(0).Speed), Is.EqualTo(new double[] { 20, 5 }).Within(1e-9));
        // With at least 8 mm/s the second takes 2.5 s, so 3.5 s are left for the first.
        var limited = new Cooling { MinLayerTime = 6, MinPrintSpeed = 8 }.Apply(layer).Value!;
        Assert.That(limited.Select(p => p.BeadOf(0).Speed), Is.EqualTo(new[] { 40 / 3.5, 8 }).Within(1e-9));
    }

    [Test]
    public void Large_layers_and_other_heights_stay_as_they_are()
    {
        PrintPath[] paths = [Line(0, 40, 0.2, 40), Line(0, 400, 0.4, 40)];
        var cooled = new Cooling { MinLayerTime = 5, MinPrintSpeed = 1 }.Apply(paths).Value!;
        Assert.That(cooled.Select(p => p.BeadOf(0).Speed), Is.EqualTo(new double[] { 8, 40 }).Within(1e-9));
    }

    [Test]
    public void A_time_that_cannot_be_reached_is_reported()
    {
        var result = new Cooling { MinLayerTime = 60, MinPrintSpeed = 10 }.Apply([Line(0, 40, 0.2, 40)]);
        Assert.That(result.Value!.Single().BeadOf(0).Speed, Is.EqualTo(10));
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo("shape.layer_time"));
    }

    [TestCase(1)]
    [TestCase(0.5)]
    public void Paths_of_a_very_low_speed_of_their_own_keep_it_as_the_start(double speed)
    {
        // 10 mm at their own speed, not at the 60 mm/s of the settings.
        var line = Line(0, 10, 0.2, speed);
        double Cooled(Cooling cooling) => cooling.Apply([line]).Value!.Single().BeadOf(0).Speed;
        Assert.That(Cooled(new Cooling { MinLayerTime = 10 / speed, MinPrintSpeed = 0.1 }), Is.EqualTo(speed));
        Assert.That(Cooled(new Cooling { MinLayerTime = 20 / speed, MinPrintSpeed = 0.1 }), Is.EqualTo(speed / 2).Within(1e-9));
        Assert.That(Cooled(new Cooling { MinLayerTime = 20 / speed, MinPrintSpeed = 5 }), Is.EqualTo(speed), "never faster");
    }

    [Test]
    public void The_minimum_speed_holds_where_the_time_asks_for_less()
    {
        // 40 mm in 40 s would be 1 mm/s.
        foreach (var least in new[] { 1, 1.5, 5 })
        {
            var result = new Cooling { MinLayerTime = 40, MinPrintSpeed = least }.Apply([Line(0, 40, 0.2, 40)]);
            Assert.That(result.Value!.Single().BeadOf(0).Speed, Is.EqualTo(least).Within(1e-9));
            Assert.That(result.Diagnostics.Select(d => d.Code), Is.EqualTo(least > 1 ? new[] { "shape.layer_time" } : []));
        }
    }

    [Test]
    public void Too_many_short_segments_per_second_are_a_warning()
    {
        PrintPath Fine(double step) => new(Enumerable.Range(0, 50).Select(i => new Vec3(i * step, 0)), new Bead(0.2, 0, 20));
        Assert.That(new Cooling().Apply([Fine(0.1)]).Diagnostics.Single().Code, Is.EqualTo("shape.short_segments"));
        Assert.That(new Cooling().Apply([Fine(0.2)]).Diagnostics, Is.Empty);
    }

    private static PrintPath Line(double from, double to, double z, double speed) => new([new Vec3(from, 0, z), new Vec3(to, 0, z)], new Bead(0.2, 0, speed));
}
