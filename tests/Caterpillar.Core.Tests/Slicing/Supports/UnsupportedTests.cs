using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>What hangs over and needs no supports: bridges that hold, and small overhangs.</summary>
[TestFixture]
public class UnsupportedTests
{
    private static readonly PrintSettings Settings = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, InfillDensityPercent = 0, MinLayerTime = 0, Support = SupportKind.Grid,
    };

    // Two piers of 10 × 20 mm and a deck over both that is as wide.
    private static TriMesh[] Bridge(double gap)
        => [Solids.Block(0, 0, 0, 10, 20, 10.05), Solids.Block(10 + gap, 0, 0, 20 + gap, 20, 10.05), Solids.Block(0, 0, 10, 20 + gap, 20, 12)];

    private static double Supported(PrintSettings settings, params TriMesh[] meshes)
        => Solids.Slice(settings, meshes).Max(l => l.Support.Area);

    [TestCase(SupportKind.Grid)]
    [TestCase(SupportKind.Tree)]
    public void A_bridge_has_no_supports_up_to_a_length(SupportKind kind)
    {
        var settings = Settings with { Support = kind };
        Assert.That(Supported(settings, Bridge(30)), Is.Zero);
        Assert.That(Supported(settings with { MaxBridgeLength = 0 }, Bridge(30)), Is.Positive);
        Assert.That(Supported(settings with { MaxBridgeLength = 29.9 }, Bridge(30)), Is.Positive);
        Assert.That(Supported(settings with { MaxBridgeLength = 30.1 }, Bridge(30)), Is.Zero);
    }

    [Test]
    public void Without_bridges_they_are_supported()
    {
        // 30 × 20 mm, less the gaps of 0.6 mm to both piers, and a little at the corners.
        Assert.That(Supported(Settings with { Bridges = false }, Bridge(30)), Is.EqualTo(28.8 * 20).Within(10));
    }

    [Test]
    public void What_is_not_held_at_both_ends_is_supported()
    {
        // One pier; piers narrower than the deck; a deck with a hole in the middle.
        Assert.That(Supported(Settings, Solids.Block(0, 0, 0, 10, 20, 10.05), Solids.Block(0, 0, 10, 30, 20, 12)), Is.Positive);
        TriMesh[] piers = [Solids.Block(0, 5, 0, 10, 15, 10.05), Solids.Block(30, 5, 0, 40, 15, 10.05)];
        Assert.That(Supported(Settings, [.. piers, Solids.Block(0, 0, 10, 40, 20, 12)]), Is.Positive);
        TriMesh[] frame =
        [
            Solids.Block(0, 0, 10, 20, 20, 12), Solids.Block(30, 0, 10, 50, 20, 12), Solids.Block(19, 0, 10, 31, 5, 12), Solids.Block(19, 15, 10, 31, 20, 12),
        ];
        Assert.That(Supported(Settings, [.. Bridge(30).Take(2), .. frame]), Is.Positive);
        // Along the free walls of both bars alone it holds.
        Assert.That(Supported(Settings, [.. Bridge(10).Take(2), Solids.Block(0, 0, 10, 30, 4, 12), Solids.Block(0, 16, 10, 30, 20, 12)]), Is.Zero);
    }

    [Test]
    public void A_small_overhang_has_no_supports()
    {
        var post = Solids.Block(0, 0, 0, 10, 10, 12);
        double Ledge(double y, double length, bool remove = true)
            => Supported(Settings with { SupportRemoveSmallOverhang = remove }, post, Solids.Block(9, 0, 10, 10 + length, y, 12));
        Assert.That(Ledge(4.9, 1.5), Is.Zero);
        Assert.That(Ledge(4.9, 1.5, remove: false), Is.Positive);
        Assert.That(Ledge(5.1, 1.5), Is.Positive, "longer than 5 mm");
        Assert.That(Ledge(1.5, 2.9), Is.Zero);
        Assert.That(Ledge(1.5, 3.1), Is.Positive, "farther than 3 mm from the part");
        Assert.That(Ledge(2, 1.5), Is.Zero);
        Assert.That(Ledge(2, 2), Is.Positive, "wider than four lines");
        // A spot of the same size that begins in the air, and joins the post above.
        var hook = Supported(Settings, post, Solids.Block(10.5, 0, 8, 11.5, 1.5, 11), Solids.Block(9, 0, 10, 11.5, 1.5, 11));
        Assert.That(hook, Is.Positive, "begins in the air");
    }

    [Test]
    public void An_enforcer_holds_bridges_and_small_overhangs()
    {
        var enforcer = new SliceModel(new NamedMesh("enforcer", Solids.Block(15, -1, -1, 35, 21, 11)), Settings with { ModelType = ModelType.SupportEnforcer });
        var models = Bridge(30).Select((m, i) => new SliceModel(new NamedMesh($"part {i}", m), Settings)).Append(enforcer).ToArray();
        var layers = PlanarSlicer.SliceEach(models, Settings).Value!.Layers;
        Assert.That(layers.Max(l => l.Support.Area), Is.EqualTo(20 * 20).Within(20));
    }
}
