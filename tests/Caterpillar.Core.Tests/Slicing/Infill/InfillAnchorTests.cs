using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Infill;

/// <summary>Ends of sparse lines along the walls.</summary>
[TestFixture]
public class InfillAnchorTests
{
    private const double Never = 0.01;

    // Five rows of 24 mm, 5 mm apart.
    private static InfillRequest Rows(double longest, double anchor) => new(Region.Rectangle(0, 2, 24, 23), InfillPattern.Lines, 5, InfillSamples.Width)
    {
        LongestLink = longest, Anchor = anchor,
    };

    private static double[] Lengths(double longest, double anchor)
        => [.. InfillSamples.Fill(Rows(longest, anchor)).Select(l => new Polyline(l.Points, l.Closed).Length)];

    [Test]
    public void Lines_are_joined_by_up_to_twice_their_distance_or_the_given_length()
    {
        var whole = new[] { 4 * 24 + 3 * 5.0 };
        Assert.That(Lengths(0, 0), Is.EqualTo(whole).Within(1e-6), "at 5, 10, 15 and 20 mm");
        Assert.That(Lengths(5.1, 0), Is.EqualTo(whole).Within(1e-6));
        Assert.That(Lengths(4.9, 0), Is.EqualTo(new[] { 24, 24, 24, 24.0 }).Within(1e-6));
    }

    [Test]
    public void Free_ends_are_led_along_the_wall_on_the_side_with_more_room()
    {
        // The outer rows have 3 + 24 + 3 mm around the corners to each other's end, the inner ones 5 mm to both sides.
        Assert.That(Lengths(Never, 1.5), Is.EqualTo(new[] { 27, 27, 27, 27.0 }).Within(1e-6));
        Assert.That(Lengths(Never, 4).OrderBy(l => l), Is.EqualTo(new[] { 24 + 5, 24 + 5, 24 + 8, 24 + 8.0 }).Within(1e-6), "at most to the middle");
        foreach (var line in InfillSamples.Fill(Rows(Never, 1.5))) Assert.That(line.Points, Has.Length.EqualTo(4));
    }

    [Test]
    public void Anchors_follow_the_wall_around_corners()
    {
        // Each corner is 3 mm away from the outer rows.
        var outer = InfillSamples.Fill(Rows(Never, 10)).OrderByDescending(l => l.Points.Length).First();
        Assert.That(outer.Points, Has.Length.EqualTo(6));
        Assert.That(outer.Points.Select(p => (p.X, p.Y)), Is.SupersetOf(new[] { (0.0, 2.0), (24.0, 2.0) }).Or.SupersetOf(new[] { (0.0, 23.0), (24.0, 23.0) }));
        Assert.That(Lengths(Never, 10).Max(), Is.EqualTo(24 + 20).Within(1e-6));
    }

    [Test]
    public void Whatever_the_pattern_and_the_area_anchored_lines_stay_in_it_and_meet_nobody_elses_anchor(
        [Values(InfillPattern.Lines, InfillPattern.Grid, InfillPattern.Gyroid, InfillPattern.Honeycomb, InfillPattern.Formula)] InfillPattern pattern,
        [Range(1, 6)] int seed)
    {
        var area = InfillSamples.Random(seed);
        var request = InfillSamples.Request(area, pattern, 3);
        var grown = area.Offset(0.03);
        double Length(double longest, double anchor) => InfillSamples.Length(InfillSamples.Fill(request with { LongestLink = longest, Anchor = anchor }));

        foreach (var line in InfillSamples.Fill(request with { Anchor = 2, LongestLink = Never }))
        {
            for (var i = 1; i < line.Points.Length; i++)
                Assert.That(grown.ContainsLine(line.Points[i - 1].WithZ(0), line.Points[i].WithZ(0)), $"{line.Points[i]}");
        }
        // No stretch of the boundary is printed twice.
        Assert.That(Length(Never, 1000) - Length(Never, 0), Is.GreaterThan(0).And.LessThanOrEqualTo(area.Perimeter + 1e-6));
    }

    [Test]
    public void Only_sparse_infill_is_anchored()
    {
        var settings = new PrintSettings { InfillAnchor = 2, InfillAnchorMax = Never, InfillDensityPercent = 10 };
        var block = Solids.Block(0, 0, 0, 20, 20, 4);
        var (with, without) = (Solids.Slice(settings, block), Solids.Slice(settings with { InfillAnchor = 0 }, block));
        double Volume(IReadOnlyList<SlicedLayer> layers, bool sparse)
            => layers.SelectMany(l => Solids.Paths(l)).Where(p => p.Role == Role.Infill == sparse).Sum(p => p.Volume);

        Assert.That(Volume(with, sparse: true), Is.GreaterThan(1.05 * Volume(without, sparse: true)));
        Assert.That(Volume(with, sparse: false), Is.EqualTo(Volume(without, sparse: false)).Within(1e-9));
    }

    [Test]
    public void A_length_below_0_is_refused()
    {
        Assert.That(() => new PrintSettings { InfillAnchor = -1 }, Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("infill_anchor_mm"));
        Assert.That(() => new PrintSettings { InfillAnchorMax = 0.001 }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }
}
