using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class NarrowAreaTests
{
    private static readonly PrintSettings Full = new() { InfillDensityPercent = 100, BeadShape = BeadShape.Rectangle, MinLayerTime = 0 };

    // Two walls of 0.4 mm on each side are 1.6 mm. Without every other of its 192 corners an outline is up to 11 µm off.
    [TestCase(1.5, true)]
    [TestCase(1.7, false)]
    public void Outlines_of_parts_that_are_all_walls_keep_half_the_tolerance(double wall, bool all)
    {
        var settings = Full with { WallCount = 2, LineWidth = 0.4, Resolution = 0.0125, InfillDensityPercent = 20, LayerHeight = 0.2, FirstLayerHeight = 0.2 };
        var (outer, inner) = (Solids.Circle(20, 192), Solids.Circle(20 - wall, 192));
        // Around the section of the tube: up outside, inward, down inside, outward.
        Vec3[][] rings = [outer, outer.Select(p => p.WithZ(1)).ToArray(), inner.Select(p => p.WithZ(1)).ToArray(), inner];
        var faces = from k in Enumerable.Range(0, 4)
                    from i in Enumerable.Range(0, 192)
                    let a = 192 * k + i
                    let b = 192 * k + (i + 1) % 192
                    from corner in new[] { a, b, (b + 192) % 768, a, (b + 192) % 768, (a + 192) % 768 }
                    select corner;
        var outline = Solids.Slice(settings, TriMesh.Create(rings.SelectMany(r => r).ToArray(), faces.ToArray()))[2].Region.Contours[0];
        Assert.That(outline.Raw.Count(p => p.Length > 19.999), all ? Is.EqualTo(192) : Is.LessThan(100));
    }

    // A square tube of 20 mm.
    private static TriMesh[] Tube(double wall) =>
    [
        Solids.Block(0, 0, 0, 20, wall, 2), Solids.Block(0, 20 - wall, 0, 20, 20, 2), Solids.Block(0, 0, 0, wall, 20, 2),
        Solids.Block(20 - wall, 0, 0, 20, 20, 2),
    ];

    [TestCase(2.5)]
    [TestCase(3.2)]
    [TestCase(4.1)]
    public void A_narrow_closed_area_is_filled_along_its_sides(double wall)
    {
        var layers = Solids.Slice(Full, Tube(wall));
        var filling = Solids.Paths(layers[4]).Where(p => p.Role == Role.SolidInfill).ToArray();
        Assert.That(filling, Is.Not.Empty);
        Assert.That(filling.Select(p => p.IsClosed), Is.All.True);
        Assert.That(filling.Length, Is.LessThanOrEqualTo(6), "rather than a hundred short lines");
        Assert.That(Solids.Volume(layers), Is.EqualTo((400 - (20 - 2 * wall) * (20 - 2 * wall)) * 2).Within(1.5).Percent);
    }

    [Test]
    public void A_wide_closed_area_keeps_its_lines_and_walls_of_one_width_theirs()
    {
        var wide = Solids.Paths(Solids.Slice(Full, Solids.Block(0, 0, 0, 20, 20, 2))[4]).Where(p => p.Role == Role.SolidInfill);
        Assert.That(wide.Select(p => p.IsClosed), Is.All.False);
        var even = Solids.Paths(Solids.Slice(Full with { VariableWallWidth = false }, Tube(3.2))[4]).Where(p => p.Role == Role.SolidInfill);
        Assert.That(even.Select(p => p.IsClosed), Is.All.False);
    }

    [Test]
    public void What_is_too_thin_is_one_finding_with_layers_place_and_area()
    {
        // Fins of 0.06 mm, 5 mm long, on the upper half of a block.
        var models = new[] { Solids.Block(0, 0, 0, 10, 10, 4), Solids.Block(10, 2, 2, 15, 2.06, 4), Solids.Block(10, 7, 2, 15, 7.06, 4) };
        var finding = Solids.Try(new PrintSettings { MinLayerTime = 0 }, models).Diagnostics.Single(d => d.Code == "slice.too_thin");
        Assert.That(finding.Severity, Is.EqualTo(Severity.Warning));
        Assert.That(finding.Count, Is.EqualTo(2 * 10));
        Assert.That(finding.Message, Does.Contain("6 mm² on 10 layers (z 2.2 to 4 mm)").And.Contain("the largest 0.3 mm² at X 12.5 Y 2.03 Z 2.2"));
        Assert.That(finding.Source!.ToString(), Does.Contain("test"));
    }

    [TestCase(true, 0)]
    [TestCase(false, 1)]
    public void Walls_of_one_width_report_what_they_leave_open(bool variable, int findings)
    {
        // 0.35 mm is too thin for a wall of 0.45 mm alone.
        var settings = new PrintSettings { VariableWallWidth = variable, MinLayerTime = 0 };
        var result = Solids.Try(settings, Solids.Block(0, 0, 0, 10, 10, 2), Solids.Block(20, 0, 0, 20.35, 10, 2));
        Assert.That(result.Diagnostics.Count(d => d.Code == "slice.too_thin"), Is.EqualTo(findings));
    }

    [Test]
    public void The_narrowest_wall_is_a_setting()
    {
        Region Covered(PrintSettings settings) => Region.Union(Solids.Paths(Sliced(settings)[3])
            .Where(p => p.Role == Role.OuterWall).Select(p => RegionTools.Around([new Polyline(p.RawPoints.ToArray(), p.IsClosed)], 0.05)));
        System.Collections.Generic.IReadOnlyList<SlicedLayer> Sliced(PrintSettings settings)
            => Solids.Slice(settings, Solids.Block(0, 0, 0, 10, 10, 2), Solids.Block(12, 0, 0, 12.2, 10, 2));
        var usual = new PrintSettings { MinLayerTime = 0 };
        Assert.That(Covered(usual).Contains(12.1, 5), Is.True);
        Assert.That(Covered(usual with { MinWallWidth = 0.44 }).Contains(12.1, 5), Is.False);
    }

    [Test]
    public void Trees_support_the_top_surface_and_leave_the_area_far_below_it_empty()
    {
        var usual = new PrintSettings { MinLayerTime = 0, LayerHeight = 0.4 };
        var lines = Solids.Slice(usual, Solids.Block(0, 0, 0, 30, 30, 32));
        var trees = Solids.Slice(usual with { InfillPattern = InfillPattern.Lightning }, Solids.Block(0, 0, 0, 30, 30, 32));
        double Infill(SlicedLayer layer) => Solids.Paths(layer).Where(p => p.Role == Role.Infill).Sum(p => p.Length);
        Assert.That(trees, Has.Count.EqualTo(lines.Count));
        Assert.That(trees.Sum(Infill), Is.GreaterThan(0).And.LessThan(0.4 * lines.Sum(Infill)));
        // The layer under the four closed ones at the top, and one that is farther below them than half the width.
        var top = Infill(trees[trees.Count - 6]);
        Assert.That(top, Is.GreaterThan(0.3 * Infill(lines[lines.Count - 6])));
        Assert.That(Infill(trees[10]), Is.LessThan(0.1 * top));
    }
}
