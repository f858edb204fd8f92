using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using static Caterpillar.Tests.Slicing.Infill.InfillSamples;

namespace Caterpillar.Tests.Slicing.Infill;

public class InfillPropertyTests
{
    private const double Pitch = 0.40708;

    // A region by its seed, with a spacing and a height.
    private static void ForRegions(int count, Action<Region, double, int> test) => Prop
        .ForAll(Gen.Choose(0, 1_000_000).ToArbitrary(), seed => test(Random(seed), 0.8 + seed % 7 * 0.6, seed % 50))
        .Check(Config.QuickThrowOnFailure.WithMaxTest(count).WithReplay(new Replay(new Rnd(7, 13), new Microsoft.FSharp.Core.FSharpOption<int>(1))));

    [TestCaseSource(typeof(InfillSamples), nameof(Patterns))]
    public void Lines_stay_in_the_area_and_cross_no_hole(InfillPattern pattern) => ForRegions(12, (area, spacing, layer) =>
    {
        // Areas are smoothed by 0.02 mm before they are filled; links run along that boundary and lines end on it.
        var around = area.Offset(0.0202, JoinStyle.Miter);
        foreach (var line in Fill(Request(area, pattern, spacing, layer)))
        {
            var n = line.Points.Length;
            for (var i = line.Closed ? 0 : 1; i < n; i++)
                Assert.That(around.ContainsLine(line.Points[i], line.Points[i == 0 ? n - 1 : i - 1]), $"{line.Points[i]}");
        }
    });

    [TestCaseSource(typeof(InfillSamples), nameof(Patterns))]
    public void Linking_loses_nothing_and_uses_no_stretch_of_the_boundary_twice(InfillPattern pattern) => ForRegions(12, (area, spacing, layer) =>
    {
        var request = Request(area, pattern, spacing, layer) with { Width = 1e-6 };
        var alone = Fill(request with { Linked = false });
        var linked = Fill(request);
        var extra = Length(linked) - Length(alone);
        // Where a link begins with a short segment its corner is cut.
        Assert.That(extra, Is.InRange(-0.1 * (alone.Count - linked.Count) - 1e-6, area.Perimeter + 1e-3));
        Assert.That(linked, Has.Count.LessThanOrEqualTo(alone.Count));
        // Each link is at most two distances of lines long, and saves one line.
        var longest = 2 * spacing * Math.Max(InfillFiller.Families(pattern), pattern == InfillPattern.Honeycomb ? 4.0 / 3 : 1.3);
        Assert.That(extra, Is.LessThanOrEqualTo((alone.Count - linked.Count) * longest + 1e-6));
        // Ends of lines, as places on the boundary, belong to one line only.
        var ends = linked.Where(l => !l.Closed).SelectMany(l => new[] { l.Points[0], l.Points[l.Points.Length - 1] }).ToList();
        var before = new HashSet<Vec3>(alone.Where(l => !l.Closed).SelectMany(l => new[] { l.Points[0], l.Points[l.Points.Length - 1] }));
        Assert.That(ends, Is.All.Matches<Vec3>(before.Contains));
    });

    [TestCaseSource(typeof(InfillSamples), nameof(Patterns))]
    public void The_same_request_gives_the_same_lines_whatever_was_filled_before(InfillPattern pattern) => ForRegions(6, (area, spacing, layer) =>
    {
        var filler = new InfillFiller(new RegionEngine());
        var request = Request(area, pattern, spacing, layer);
        var first = filler.Fill(request);
        filler.Fill(Request(Holed, pattern, 1.7, 3));
        var second = filler.Fill(request);
        Assert.That(second.Select(l => l.Points), Is.EqualTo(first.Select(l => l.Points)));
    });

    // Boxes that no period of a pattern divides; means over layers and places.
    [TestCase(InfillPattern.Lines)]
    [TestCase(InfillPattern.Monotonic)]
    [TestCase(InfillPattern.Grid)]
    [TestCase(InfillPattern.Triangles)]
    [TestCase(InfillPattern.Cubic)]
    [TestCase(InfillPattern.Gyroid)]
    [TestCase(InfillPattern.Honeycomb)]
    [TestCase(InfillPattern.Concentric)]
    [TestCase(InfillPattern.Hilbert)]
    public void A_percentage_is_the_same_length_with_every_pattern(InfillPattern pattern)
    {
        foreach (var percent in new[] { 5.0, 20, 50, 100 })
        {
            var spacing = Pitch * 100 / percent;
            var size = (pattern == InfillPattern.Gyroid ? 20 : 40) * spacing;
            var period = GyroidPattern.MeanLength * spacing;
            double length = 0, area = 0;
            // The gyroid has its longest lines within a short range of heights.
            var layers = pattern == InfillPattern.Gyroid ? 48 : 12;
            for (var layer = 0; layer < layers; layer++)
            {
                var x = layer * 0.37 * spacing;
                var box = Region.Rectangle(x - size / 2, 0.6 * x - size / 2, x + size / 2, 0.6 * x + size / 2);
                length += Length(Fill(Request(box, pattern, spacing, layer, linked: false) with { Z = (layer + 0.5) * period / layers }));
                area += box.Area;
            }
            Assert.That(length * spacing / area, Is.EqualTo(1).Within(0.02), $"{percent} %");
        }
    }

    [Test]
    public void A_sweep_prints_no_piece_before_its_neighbors_in_the_row_before() => ForRegions(40, (area, spacing, layer) =>
    {
        var request = Request(area, InfillPattern.Monotonic, spacing, layer) with { Solid = layer % 2 == 0, Linked = layer % 3 > 0 };
        foreach (var island in area.Islands)
        {
            var frame = new PatternFrame(island, request.Angle);
            var rows = new List<(double V, double From, double To)>();
            foreach (var line in Fill(request with { Area = island }))
            {
                for (var i = 1; i < line.Points.Length; i++)
                {
                    Vec3 a = line.Points[i - 1], b = line.Points[i];
                    // Pieces of rows go along the direction, links and extrusions in gaps hardly ever.
                    if (Math.Abs(frame.V(a) - frame.V(b)) > 1e-6 || (line.Flow is not null && line.Flow[i - 1] != line.Flow[0])) continue;
                    rows.Add((frame.V(a), Math.Min(frame.U(a), frame.U(b)), Math.Max(frame.U(a), frame.U(b))));
                }
            }
            if (request.Solid) continue;
            for (var i = 0; i < rows.Count; i++)
            {
                for (var j = i + 1; j < rows.Count; j++)
                {
                    var overlap = Math.Min(rows[i].To, rows[j].To) - Math.Max(rows[i].From, rows[j].From);
                    var step = rows[i].V - rows[j].V;
                    Assert.That(overlap > 1e-3 && step > 1e-3 && step < spacing * 1.5, Is.False, $"row at {rows[i].V} before {rows[j].V}");
                }
            }
        }
    });
}
