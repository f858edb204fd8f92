using System.Linq;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>The greatest change of the gap between layers.</summary>
public class GapRatioTests
{
    // A wedge from 4 to 16 mm height in 40 layers: 0.1 to 0.4 mm thick.
    private static readonly PrintSettings Forty = CurvedSolids.Massive with { LayerHeight = 0.4, FirstLayerHeight = 0.4, CurvedMinGap = 0.05 };

    [TestCase(0, 4)]
    [TestCase(2, 2)]
    [TestCase(3, 3)]
    public void Thin_layers_are_printed_several_at_once_until_no_extrusion_is_too_thick_for_the_thinnest(double ratio, double expected)
    {
        static double Roof(double x, double y) => 4 + 0.3 * x;
        var wedge = CurvedSolids.Between(new Bounds(Vec3.Zero, new Vec3(40, 12)), 8, (_, _) => 0, Roof);
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of(Roof));
        var sliced = CurvedSlicer.Slice([new NamedMesh("wedge", wedge)], field, new PrintSetup { Settings = Forty with { CurvedMaxGapRatio = ratio } }).Value!;
        var extrusions = sliced.ToSteps().OfType<PathStep>().SelectMany(s => Enumerable.Range(0, s.Path.SegmentCount)
            .Select(i => (s.Path.BeadOf(i).Height, Volume: s.Path.BeadOf(i).Area * s.Path.LengthOf(i)))).ToArray();
        var (least, most) = (extrusions.Min(s => s.Height), extrusions.Max(s => s.Height));
        Assert.That(most / least, Is.InRange(0.93 * expected, 1.02 * expected));
        Assert.That(most, Is.LessThan(0.41), "merged extrusions are no thicker than the thickest layer");
        Assert.That(extrusions.Sum(s => s.Volume), Is.EqualTo(wedge.Volume).Within(2).Percent);
    }

    [Test]
    public void A_ratio_below_two_cannot_be_kept()
        => Assert.That(() => new PrintSettings { CurvedMaxGapRatio = 1.5 }, Throws.InstanceOf<System.ArgumentException>());
}
