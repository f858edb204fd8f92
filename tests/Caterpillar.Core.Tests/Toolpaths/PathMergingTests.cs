using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class PathMergingTests
{
    private static readonly Bead Thin = new(0.1);
    private static readonly Bead Thick = new(0.2);

    [Test]
    public void Touching_ends_are_joined_and_keep_their_beads()
    {
        var merged = PathMerging.Merge([Path(Thin, (0, 0), (1, 0)), Path(Thick, (1.005, 0), (2, 0), (2, 1)), Path(Thin, (5, 5), (6, 6))]);
        Assert.That(merged, Has.Count.EqualTo(2));
        Assert.That(merged[0].Points, Is.EqualTo(new Vec3[] { new(0, 0), new(1, 0), new(2, 0), new(2, 1) }));
        Assert.That(Enumerable.Range(0, 3).Select(merged[0].BeadOf), Is.EqualTo(new[] { Thin, Thick, Thick }));
    }

    [Test]
    public void A_chain_that_returns_becomes_closed()
    {
        var merged = PathMerging.Merge([Path(Thin, (0, 0), (1, 0)), Path(Thin, (1, 0), (1, 1)), Path(Thin, (1, 1), (0, 1)), Path(Thin, (0, 1), (0, 0))]);
        Assert.That(merged, Has.Count.EqualTo(1));
        Assert.That(merged[0].IsClosed, Is.True);
        Assert.That(merged[0].Length, Is.EqualTo(4));
    }

    [Test]
    public void Paths_are_reversed_only_on_request()
    {
        PrintPath[] paths = [Path(Thin, (1, 0), (0, 0)), Path(Thin, (2, 0), (1, 0)), Path(Thin, (2, 0), (3, 0))];
        Assert.That(PathMerging.Merge(paths), Has.Count.EqualTo(3));
        var merged = PathMerging.Merge(paths, reverse: true);
        Assert.That(merged, Has.Count.EqualTo(1));
        Assert.That(merged[0].Points, Is.EqualTo(new Vec3[] { new(0, 0), new(1, 0), new(2, 0), new(3, 0) }));
    }

    [Test]
    public void Different_settings_and_closed_paths_are_not_joined()
    {
        var a = Path(Thin, (0, 0), (1, 0));
        var b = Path(Thin, (1, 0), (2, 0));
        Assert.That(PathMerging.Merge([a, b with { Tool = 1 }]), Has.Count.EqualTo(2));
        Assert.That(PathMerging.Merge([a, b with { Role = Role.Infill }]), Has.Count.EqualTo(2));
        var loop = new PrintPath([new(1, 0), new(2, 0), new(2, 2)], Thin, closed: true);
        Assert.That(PathMerging.Merge([a, loop]), Has.Count.EqualTo(2));
        Assert.That(PathMerging.Merge([]), Is.Empty);
        Assert.That(() => PathMerging.Merge([a], double.NaN), Throws.ArgumentException);
    }

    private static PrintPath Path(Bead bead, params (double X, double Y)[] points) => new(points.Select(p => new Vec3(p.X, p.Y)), bead);
}
