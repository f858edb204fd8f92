using Caterpillar.Geometry;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class DeconstructPrintPathTests
{
    private static PrintPath Path(double x = 0)
        => new([new Vec3(x, 0, 0.2), new Vec3(x + 10, 0, 0.2), new Vec3(x + 10, 5, 0.2)], [new Bead(0.08, 0.2, 40), new Bead(0.1, 0.2)])
    {
        Role = Role.OuterWall,
        Layer = new Layer(3, 0.8, 0.2),
    };

    [Test]
    public void An_item_gives_its_parts()
    {
        var canvas = new Canvas<DeconstructPrintPathComponent>().Feed("Print Path", Path()).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.All("Points"), Is.EqualTo(new object[] { new Rg.Point3d(0, 0, 0.2), new Rg.Point3d(10, 0, 0.2), new Rg.Point3d(10, 5, 0.2) }));
        Assert.That(canvas.All("Areas"), Is.EqualTo(new object[] { 0.08, 0.1 }));
        Assert.That(canvas.All("Speeds"), Is.EqualTo(new object[] { 40.0, 0.0 }));
        Assert.That((canvas.One<string>("Role"), canvas.One<int>("Layer")), Is.EqualTo(("OuterWall", 3)));
    }

    [Test]
    public void A_list_gives_a_branch_each_and_a_tree_keeps_its_branches()
    {
        Assert.That(new Canvas<DeconstructPrintPathComponent>().Feed("Print Path", Path(), Path(1)).Solve().Paths("Points"),
            Is.EqualTo(new[] { "{0;0}", "{0;1}" }));
        var tree = new Canvas<DeconstructPrintPathComponent>().FeedTree("Print Path", [Path()], [Path(), Path()]).Solve();
        Assert.That(tree.Paths("Points"), Is.EqualTo(new[] { "{0;0}", "{1;0}", "{1;1}" }));
        Assert.That(tree.Paths("Role"), Is.EqualTo(new[] { "{0}", "{1}" }));
    }

    [Test]
    public void Null_and_wrong_items_give_null_and_name_their_place_and_the_rest_continues()
    {
        var canvas = new Canvas<DeconstructPrintPathComponent>().FeedTree("Print Path", [Path()], [null, Path(), "a wall"]).Solve();
        Assert.That(canvas.All("Role"), Is.EqualTo(new object?[] { "OuterWall", null, "OuterWall", null }));
        Assert.That(canvas.Warnings, Has.Member("{1}[0]: Print Path is missing.").And.Member("{1}[2]: Print Path is missing."));
        Assert.That(canvas.Errors, Is.EqualTo(new[] { "Data conversion failed from Text to Print Path" }));
    }

    [Test]
    public void A_missing_input_is_a_warning()
        => Assert.That(new Canvas<DeconstructPrintPathComponent>().Solve().Warnings, Is.EqualTo(new[] { "Input parameter P failed to collect data" }));

    [Test]
    public void Points_are_in_document_units_and_a_note_says_so()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var canvas = new Canvas<DeconstructPrintPathComponent>().Feed("Print Path", Path()).Solve();
        Assert.That(((Rg.Point3d)canvas.All("Points")[1]!).DistanceTo(new Rg.Point3d(1, 0, 0.02)), Is.LessThan(1e-12));
        Assert.That(canvas.Notes, Is.EqualTo(new[] { "The document is in centimeters. Geometry is scaled to mm." }));
    }
}
