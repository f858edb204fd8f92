using System;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Footprints, clearances, slopes and reports on models, worked out by hand.</summary>
public class ModelPartTests
{
    [TestCase(5, 0, 3)]
    [TestCase(5, 6, 4)]
    [TestCase(2, 0, 0)]
    [TestCase(1.5, 0, -0.5)]
    [TestCase(0, -7, 5)]
    [TestCase(-1.25, 1.5, -0.5)]
    public void Footprints_are_apart_along_the_side_that_separates_them_best(double x, double y, double distance)
    {
        var (a, b) = (Footprint.Of(new Bounds(Vec3.Zero, new Vec3(2, 2, 5))), Footprint.Of(MeshMaker.Box(x, y, 1, x + 2, y + 2, 4)));
        Assert.That((a.Separation(b), b.Separation(a)), Is.EqualTo((distance, distance)).Within(1e-12));
        Assert.That((a.Height, b.Height), Is.EqualTo((5.0, 3.0)));
        Assert.That(b.Moved(-x, -y).Box, Is.EqualTo(new Bounds(Vec3.Zero, new Vec3(2, 2, 0))));
    }

    [Test]
    public void A_footprint_is_the_hull_of_the_model_from_above()
    {
        // A prism over a diamond with a corner inside and one on a side.
        Vec3[] polygon = [new(0, -5), new(5, 0), new(0, 5), new(-2.5, 2.5), new(-5, 0), new(-1, 0)];
        var hull = Footprint.Of(MeshMaker.Prism(polygon, 0, 3, Vec3.Zero));
        Assert.That(hull.Corners.OrderBy(p => p.X).ThenBy(p => p.Y), Is.EqualTo(new Vec3[] { new(-5, 0), new(0, -5), new(0, 5), new(5, 0) }));
        // The corner of a square is 2 √2 beside the diamond's side.
        var beside = Footprint.Of(new Bounds(new Vec3(4.5, 4.5, 0), new Vec3(6, 6, 1)));
        Assert.That(hull.Separation(beside), Is.EqualTo(2 * Math.Sqrt(2)).Within(1e-12));
    }

    // Outline: 0.5 mm at the tip, 4 mm at 6 mm, 20 mm at 12 mm; a box that reaches 50 mm from 20 mm on.
    [TestCase(-1, 0)]
    [TestCase(0, 0)]
    [TestCase(3, 2.25)]
    [TestCase(6, 4)]
    [TestCase(9, 12)]
    [TestCase(12, 20)]
    [TestCase(20, 20)]
    [TestCase(20.01, 50)]
    public void The_head_needs_what_is_lower_than_the_print_beside_it(double height, double distance)
    {
        var printer = new Printer { HeadBoxes = new ValueList<Bounds>(new Bounds(new Vec3(-30, -10, 20), new Vec3(20, 40, 60))) };
        Assert.That(HeadClearance.Beside(printer, height), Is.EqualTo(distance).Within(1e-12));
    }

    [TestCase("0", "1 layer (z 0.1 mm)")]
    [TestCase("0 1 2", "3 layers (z 0.1 to 0.3 mm)")]
    [TestCase("0 2 4", "3 layers (z 0.1, 0.3 and 0.5 mm)")]
    [TestCase("0 1 3", "3 layers (z 0.1 to 0.2 and 0.4 mm)")]
    [TestCase("0 2 4 6 8 10", "6 layers (z 0.1, 0.3, 0.5, 0.7, 0.9 and 1.1 mm)")]
    [TestCase("0 2 4 6 8 10 12", "7 layers (z 0.1, 0.3, 0.5, 0.7, 0.9 and 2 more ranges mm)")]
    public void Heights_that_follow_each_other_are_ranges(string chosen, string text)
    {
        var sections = Enumerable.Range(0, 20).Select(i => new Section(0.1 * (i + 1), [], [])).ToArray();
        Assert.That(HeightRanges.Of(sections, chosen.Split(' ').Select(int.Parse).ToArray()), Is.EqualTo(text));
    }

    // The side of what is left of a square of 10 mm, the length of what does not close, and the greatest loss in percent.
    [TestCase(5, 30, 5, true)]
    [TestCase(5, 5, 5, false)]
    [TestCase(5, 6, 5, true)]
    [TestCase(9.8, 30, 5, false)]
    [TestCase(9.8, 30, 3, true)]
    [TestCase(5, 30, 74, true)]
    [TestCase(5, 300, 76, false)]
    [TestCase(0.1, 300, 100, false)]
    public void Layers_that_lose_their_area_are_told(double side, double open, double most, bool lost)
    {
        static Section At(double z, double side, double open) => new(z, [Square(side)], open > 0 ? [new Polyline([Vec3.Zero, new Vec3(open, 0)])] : []);
        Section[] sections = [At(0.1, 10, 0), At(0.3, side, open), At(0.5, 12, 0)];
        var text = LostLayers.Find(sections, most, CancellationToken.None);
        Assert.That(text is not null, Is.EqualTo(lost));
        const string Left = "on 1 layer (z 0.3 mm) because contours do not close. At z 0.3 mm, 25 % of the area of the next intact layer is left.";
        if (side == 5 && lost) Assert.That(text, Does.Contain(Left));
        Assert.That(LostLayers.Find([At(0.3, side, open), At(0.5, 10, 0)], most, CancellationToken.None) is not null, Is.EqualTo(lost),
            "the layer above tells");
        Assert.That(LostLayers.Find([At(0.3, side, open), At(0.5, side, open)], most, CancellationToken.None), Is.Null, "nothing to compare with");
    }

    // A square of 1 mm of which a quarter is left.
    [TestCase(0.9, true)]
    [TestCase(0.5, false)]
    public void A_gap_that_was_closed_may_have_lost_a_small_layer(double gap, bool lost)
    {
        Section[] sections = [new(0.1, [Square(1)], []), new(0.3, [Square(0.5)], [], new ClosedGaps(1, gap, gap)), new(0.5, [Square(1)], [])];
        Assert.That(LostLayers.Find(sections, 5, CancellationToken.None) is not null, Is.EqualTo(lost));
    }

    [Test]
    public void Repairs_are_reported_in_sentences()
    {
        var mesh = MeshMaker.Box(0, 0, 0, 1, 1, 1);
        Assert.That(BrokenMeshReport.Describe(RepairedMesh.Unchanged(mesh), []), Is.Null);
        FilledHole[] holes = [new(new Bounds(new Vec3(0, 0, 1), new Vec3(3, 4, 1)), 1), new(new Bounds(new Vec3(0, 0, 2), new Vec3(0, 0, 2.5)), 1)];
        Assert.That(BrokenMeshReport.Describe(new RepairedMesh(mesh, 1, 0.05, 1, 1, holes, 1, 1), []),
            Is.EqualTo("The mesh is broken. Repaired: 1 vertex moved by up "
            + "to 0.05 mm to join naked edges, 1 duplicate face removed, 1 inward-facing face flipped, 1 inside-out body flipped, 2 holes filled "
            + "(z 1 to 2.5 mm, up to 5 mm wide), 1 loose face removed at filled holes."));
        Assert.That(BrokenMeshReport.Describe(new RepairedMesh(mesh, 2, 0.1, 2, 2, [], 2, 2), []),
            Is.EqualTo("The mesh is broken. Repaired: 2 vertices moved by up "
            + "to 0.1 mm to join naked edges, 2 duplicate faces removed, 2 inward-facing faces flipped, 2 inside-out bodies flipped, "
            + "2 loose faces removed at filled holes."));
        Polyline[] open = [new([Vec3.Zero, new Vec3(3, 0)]), new([Vec3.Zero, new Vec3(0, 4.5)])];
        Section[] sections = [new(0.1, [], [], new ClosedGaps(1, 0.5, 0.5)), new(0.3, [], open, new ClosedGaps(2, 0.5, 0.3)), new(0.5, [], [])];
        const string Gaps = "The mesh is broken. 3 gaps in contours closed on 2 layers (z 0.1 to 0.3 mm): 1 mm in total, the widest 0.5 mm.";
        Assert.That(BrokenMeshReport.Describe(RepairedMesh.Unchanged(mesh), [sections[0], new(0.3, [], [], sections[1].Gaps)]), Is.EqualTo(Gaps));
        Assert.That(BrokenMeshReport.Describe(RepairedMesh.Unchanged(mesh), sections),
            Is.EqualTo(Gaps + " 2 open contours left out on 1 layer (z 0.3 mm): 7.5 mm in total."));
    }

    // A frustum of four sides: each leans by √12.5 over a height of 5, so the cosine of its normal is √(1/3), and a cusp of 0.1 allows 0.173 mm.
    [TestCase(1, 0.1, 0.173)]
    [TestCase(1, 0.01, 0.05)]
    [TestCase(1, 0.5, 0.3)]
    [TestCase(4.9, 0.1, 0.1)]
    [TestCase(4.7, 0.1, 0.15)]
    [TestCase(4.6, 0.1, 0.173)]
    [TestCase(4.97, 0.1, 0.173)]
    [TestCase(9, 0.1, 0.3)]
    public void Layers_are_as_thick_as_slopes_and_level_facets_allow(double z, double cusp, double thickness)
    {
        var slopes = new SurfaceSlopes(Solids.Cone(0, 10, 5, 5, 4));
        Assert.That(slopes.Thickness(z, 0.05, 0.3, cusp, 0.2), Is.EqualTo(thickness).Within(1e-9));
    }

    // A cone that rises by 1 over a run: 1.44 · 0.2 mm · √(1 / run), from 0.07 to 0.28 mm.
    [TestCase(0.5, 0.28)]
    [TestCase(1, 0.28)]
    [TestCase(4, 0.144)]
    [TestCase(9, 0.096)]
    [TestCase(25, 0.07)]
    public void Without_a_cusp_layers_are_thin_only_where_the_surface_is_shallow(double run, double thickness)
    {
        // Corners of a square cone are √2 times farther out than the middles of its sides.
        var slopes = new SurfaceSlopes(Solids.Cone(0, (10 * run + 1) * Math.Sqrt(2), 10, Math.Sqrt(2), 4));
        Assert.That(slopes.Thickness(5, 0.07, 0.28, 0, 0.2), Is.EqualTo(thickness).Within(1e-9));
    }

    [Test]
    public void A_layer_ends_before_a_slope_that_would_be_too_steep_for_it()
    {
        // Upright up to 3 mm, then the frustum: from 2.85 mm the layer reaches to the bin in which the slope begins.
        var mesh = TriMesh.Merge([Solids.Cone(0, 10, 3, 10, 4), Solids.Cone(3, 10, 8, 5, 4)]);
        var slopes = new SurfaceSlopes(mesh);
        Assert.That(slopes.Thickness(1, 0.05, 0.3, 0.1, 0.2), Is.EqualTo(0.3).Within(1e-9));
        Assert.That(slopes.Thickness(2.85, 0.05, 0.3, 0.1, 0.2), Is.EqualTo(0.15).Within(0.011));
        Assert.That(slopes.Thickness(3.5, 0.05, 0.3, 0.1, 0.2), Is.EqualTo(0.173).Within(1e-9));
    }

    private static Polyline Square(double side) => new([new(0, 0), new(side, 0), new(side, side), new(0, side)], true);
}
