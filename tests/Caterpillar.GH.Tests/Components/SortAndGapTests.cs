using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class SortAndGapTests
{
    private static readonly Bead Bead = new(0.08, 0.2, 30);

    private static PrintPath Line(double from, double to, double z = 0.2) => new([new Vec3(from, 0, z), new Vec3(to, 0, z)], Bead);

    [Test]
    public void Sort_takes_the_nearest_start_and_reverses_paths()
    {
        var canvas = new Canvas<SortPathsComponent>().Feed("Print Paths", Line(0, 10), Line(30, 20), Line(11, 18)).Solve();
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        Assert.That(canvas.All("Indices"), Is.EqualTo(new object[] { 0, 2, 1 }));
        Assert.That(canvas.All("Print Paths").Cast<PrintPath>().Select(p => p.Start.X), Is.EqualTo(new[] { 0.0, 11, 20 }));
        Assert.That(canvas.One<double>("Travel"), Is.EqualTo(3).Within(1e-12));
        var kept = canvas.Feed("Reverse", false).Solve();
        Assert.That(kept.All("Print Paths").Cast<PrintPath>().Select(p => p.Start.X), Is.EqualTo(new[] { 0.0, 11, 30 }));
    }

    [Test]
    public void Sort_knows_its_rules_by_number_and_name_and_where_the_head_comes_from()
    {
        var canvas = new Canvas<SortPathsComponent>().Feed("Print Paths", Line(0, 10), Line(30, 20), Line(11, 18));
        Assert.That(canvas.Feed("Rule", nameof(SortRule.None)).Solve().All("Indices"), Is.EqualTo(new object[] { 0, 1, 2 }));
        Assert.That(canvas.Feed("Rule", (int)SortRule.Orient).Solve().All("Indices"), Is.EqualTo(new object[] { 0, 1, 2 }));
        Assert.That(canvas.Feed("Rule", "Tour").Feed("Start", new Rg.Point3d(31, 0, 0)).Solve().All("Indices"), Is.EqualTo(new object[] { 1, 2, 0 }));
        Assert.That(canvas.Feed("Rule", 77).Solve().Errors, Has.One.Contains("Rule has no choice 77"));
    }

    [Test]
    public void Sort_solves_each_branch_and_ignores_nulls()
    {
        var canvas = new Canvas<SortPathsComponent>().FeedTree("Print Paths", [Line(0, 10), Line(12, 20)], [Line(5, 6), null, Line(9, 7)]).Solve();
        Assert.That(canvas.Paths("Print Paths"), Is.EqualTo(new[] { "{0;0}", "{1;0}" }));
        Assert.That(canvas.All("Indices"), Is.EqualTo(new object[] { 0, 1, 0, 1 }));
        Assert.That(canvas.Warnings, Has.One.Contains("1 null item"));
        Assert.That(new Canvas<SortPathsComponent>().Solve().Warnings, Has.One.Contains("failed to collect data"));
    }

    [Test]
    public void Sorted_paths_leave_the_groups_of_a_slicer_and_keep_their_order_when_planned()
    {
        var grouped = new PrintPathGoo(new PathStep(Line(0, 10), new StepGroup(0)));
        var canvas = new Canvas<SortPathsComponent>().Feed("Print Paths", grouped).Solve();
        var goo = (PrintPathGoo)canvas.Output("Print Paths").VolatileData.get_Branch(0)[0]!;
        Assert.That(goo.ToStep().Group, Is.Null);
    }

    [Test]
    public void A_sliced_path_keeps_its_region_on_the_wire_until_it_is_moved()
    {
        var region = Region.Rectangle(0, 0, 10, 10);
        var goo = new PrintPathGoo(new PathStep(Line(0, 10), new StepGroup(0)) { Region = region, KeepStart = true });
        Assert.That(((PrintPathGoo)goo.DuplicateGeometry()).ToStep(), Has.Property("Region").SameAs(region).And.Property("KeepStart").True);
        var moved = (PrintPathGoo)goo.Transform(Rg.Transform.Translation(1, 0, 0))!;
        Assert.That(moved.ToStep().Region, Is.Null);
    }

    [Test]
    public void Gap_beads_fill_down_to_the_bed_and_to_earlier_paths()
    {
        var canvas = new Canvas<GapBeadComponent>().Feed("Print Paths", Line(0, 10, 0.3), Line(0, 10, 0.5)).Solve();
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        Assert.That(canvas.All("Print Paths").Cast<PrintPath>().Select(p => p.BeadOf(0).Area), Is.EqualTo(new[] { 0.12, 0.08 }).Within(1e-9));
    }

    [Test]
    public void Gap_beads_find_geometry_underneath()
    {
        // Boxes 2 mm high from 100 to 110 and from 130 to 140.
        var path = new PrintPath([new Vec3(102, 105, 2.3), new Vec3(108, 105, 2.3)], Bead);
        var other = new PrintPath([new Vec3(132, 105, 2.3), new Vec3(138, 105, 2.3)], Bead);
        var canvas = new Canvas<GapBeadComponent>().Feed("Print Paths", path, other).Feed("Geometry", Shapes.Box(), Shapes.Box(130)).Feed("Bed", false).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.All("Print Paths").Cast<PrintPath>().Select(p => p.BeadOf(0).Height), Is.EqualTo(new[] { 0.3, 0.3 }).Within(1e-9));
        using var _ = new InDocument(UnitSystem.Meters);
        var small = new Canvas<GapBeadComponent>().Feed("Print Paths", path).Feed("Geometry", Shapes.Box(0.1, 0.1, 0.01, 0.002)).Feed("Bed", false).Solve();
        Assert.That(small.One<PrintPath>("Print Paths").BeadOf(0).Height, Is.EqualTo(0.3).Within(1e-4));
        Assert.That(small.Notes, Has.One.Contains("meters"));
    }

    [Test]
    public void Gap_beads_keep_the_limits_and_the_group_and_report_what_was_limited()
    {
        var step = new PrintPathGoo(new PathStep(Line(0, 10, 0.7), new StepGroup(3, 1)));
        var canvas = new Canvas<GapBeadComponent>().Feed("Print Paths", step).Feed("Maximum Gap", 0.5).Solve();
        Assert.That(canvas.One<PrintPath>("Print Paths").BeadOf(0).Height, Is.EqualTo(0.5).Within(1e-9));
        Assert.That(((PrintPathGoo)canvas.Output("Print Paths").VolatileData.get_Branch(0)[0]!).ToStep().Group, Is.EqualTo(new StepGroup(3, 1)));
        Assert.That(canvas.All("Diagnostics"), Has.One.Contains("gap.wide"));
        Assert.That(canvas.Feed("Minimum Gap", 0.6).Solve().Errors, Has.One.Contains("Minimum Gap must not be greater than Maximum Gap"));
        Assert.That(canvas.Feed("Minimum Gap", -1).Solve().Errors, Has.One.Contains("Minimum Gap must be greater than zero"));
    }

    [Test]
    public void Gap_beads_reject_what_has_no_surface_and_beads_without_a_width()
    {
        var curve = new Canvas<GapBeadComponent>().Feed("Print Paths", Line(0, 10)).Feed("Geometry", new Rg.Point3d(0, 0, 0)).Solve();
        Assert.That(curve.Errors, Has.One.Contains("cannot be sliced"));
        var bare = new PrintPath([new Vec3(0, 0, 0.2), new Vec3(9, 0, 0.2)], new Bead(0.1));
        Assert.That(new Canvas<GapBeadComponent>().Feed("Print Paths", bare).Solve().Errors, Has.One.Contains("gap.no_width"));
        Assert.That(new Canvas<GapBeadComponent>().Feed("Print Paths", bare).Feed("Width", 0.5).Solve().One<PrintPath>("Print Paths").BeadOf(0).Area,
            Is.EqualTo(0.1).Within(1e-12));
    }
}
