using System.Linq;
using System.Text;
using Caterpillar.Geometry;
using Caterpillar.GH.Bake;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Preview;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>Names of layers, polylines, arcs, stored text and thinned previews, one by one.</summary>
public sealed class SmallPartTests
{
    // Rhino divides a path at two colons, also at two of three.
    [TestCase("Part", "Caterpillar::Part::Wall")]
    [TestCase("Part: 2", "Caterpillar::Part: 2::Wall")]
    [TestCase("a::b", "Caterpillar::a:b::Wall")]
    [TestCase("a:::b", "Caterpillar::a:b::Wall")]
    [TestCase("a::::b", "Caterpillar::a:b::Wall")]
    [TestCase(":a:", "Caterpillar::a::Wall")]
    public void A_name_is_one_layer(string name, string path) => Assert.That(BakeLayers.PathOf(name, "Wall"), Is.EqualTo(path));

    [TestCase(0, 0, 0, false)]
    [TestCase(1_000_000, 9, 1, true)]
    [TestCase(1_000_001, 4, 2, true)]
    [TestCase(1_000_001, 3, 2, false)]
    [TestCase(2_000_000, 0, 2, false)]
    [TestCase(2_000_001, 6, 3, true)]
    public void Of_more_than_a_million_lines_one_layer_in_several_is_shown_or_one_line(int lines, int layers, int every, bool byLayer)
    {
        var thinning = Thinning.Of(lines, layers);
        Assert.That(thinning.Every, Is.EqualTo(every));
        if (every > 1) Assert.That(thinning.ByLayer, Is.EqualTo(byLayer));
        Assert.That(thinning.Note, Is.EqualTo(every <= 1 ? null
            : $"The preview shows one {(byLayer ? "layer" : "line")} in {every}, because there are too many lines."));
        var shown = Enumerable.Range(0, 12).Where(i => thinning.Has(byLayer ? i : 1, byLayer ? 1 : i));
        Assert.That(shown, Is.EqualTo(Enumerable.Range(0, 12).Where(i => every == 0 || i % every == 0)));
    }

    [TestCase(new double[] { }, null)]
    [TestCase(new[] { 1.0 }, null)]
    [TestCase(new[] { 1.0, 1, 1 + 2e-10 }, null)]
    [TestCase(new[] { 1.0, 2 }, new[] { 1.0, 2 })]
    [TestCase(new[] { 1.0, 1, 2, 2, 3, 3 }, new[] { 1.0, 2, 3 })]
    [TestCase(new[] { 1.0, 2, 1 }, new[] { 1.0, 2, 1.5, 1 })]
    [TestCase(new[] { 1.0, 2, 3, 1 }, new[] { 1.0, 2, 3, 1 })]
    public void A_polyline_has_no_duplicate_neighbors_and_does_not_fold_onto_itself(double[] places, double[]? kept)
    {
        var curve = PolylineMaker.Of(places.Select(x => new Rg.Point3d(x, 2 * x, 3 * x)));
        Assert.That(curve is null, Is.EqualTo(kept is null));
        if (kept is null) return;
        var points = Enumerable.Range(0, curve!.PointCount).Select(curve.Point).ToArray();
        Assert.That(points.Select(p => p.X), Is.EqualTo(kept));
        foreach (var p in points) Assert.That((p.Y, p.Z), Is.EqualTo((2 * p.X, 3 * p.X)).Within(1e-12));
    }

    [TestCase(360, 0, true)]
    [TestCase(-360, 0, true)]
    [TestCase(361, 0, false)]
    [TestCase(90, 0.1, false)]
    public void Level_arcs_of_one_turn_at_most_are_arcs_in_Rhino(double sweep, double rise, bool isPlain)
        => Assert.That(CurveJoiner.IsPlain(new Vec3(5, 0, 1), new Vec3(5, 0, 1 + rise), new Arc(Vec3.Zero, sweep)), Is.EqualTo(isPlain));

    [TestCase("")]
    [TestCase("plain")]
    [TestCase("\"quoted\" \\ text\n\t")]
    [TestCase("äöü ✓ \u0001\u001f")]
    public void Stored_text_is_ASCII_and_comes_back(string text)
    {
        var packed = StoredText.Pack(text);
        Assert.That(packed.All(c => c is >= ' ' and <= '~'), Is.True, packed);
        Assert.That(StoredText.Unpack(packed), Is.EqualTo(text));
        var bytes = Encoding.UTF8.GetBytes(text);
        Assert.That(StoredText.Inflate(StoredText.Deflate(bytes)), Is.EqualTo(bytes));
    }

    [TestCase("not packed")]
    [TestCase(" \"quoted\"")]
    [TestCase("\"")]
    [TestCase("\"open")]
    [TestCase("")]
    public void Text_that_was_not_packed_stays_as_it_is(string text) => Assert.That(StoredText.Unpack(text), Is.EqualTo(text));

    // The runtimes say it differently.
    [Test]
    [Category("Host")]
    public void Damaged_bytes_are_none() => Assert.That(StoredText.Inflate([7, 1, 2, 3, 4]), Is.Null);
}
