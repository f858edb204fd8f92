using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;
using static Caterpillar.Tests.Slicing.Infill.InfillSamples;

namespace Caterpillar.Tests.Slicing.Infill;

public class SolidInfillTests
{
    private const double Pitch = 0.4;

    private static readonly (string Name, Region Area)[] Areas =
    [
        ("rectangle", Region.Rectangle(0, 0, 12, 7.3)),
        ("thin", Region.Rectangle(0, 0, 12, 0.75)),
        ("as thin as an extrusion", Region.Rectangle(0, 0, 12, 0.03)),
        ("steps", Region.Rectangle(0, 0, 12, 5).Union(Region.Rectangle(0, 0, 8, 6.77)).Union(Region.Rectangle(0, 0, 4, 7.9))),
        ("holes", Region.Rectangle(0, 0, 12, 12).Subtract(Region.Rectangle(2.1, 2.3, 5.2, 4.87)).Subtract(Region.Rectangle(8, 4.55, 9, 9.15))),
        ("thin arm between two rows", Region.Rectangle(0, 0, 4, 8).Union(Region.Rectangle(4, 3.45, 9, 3.6)).Union(Region.Rectangle(9, 0, 12, 8))),
        ("slope", Region.From(new Polyline([Vec3.Zero, new Vec3(12, 0), new Vec3(12, 2.9), new Vec3(0, 4)], closed: true))),
    ];

    private static InfillRequest Solid(Region area, InfillPattern pattern = InfillPattern.Lines) => new(area, pattern, Pitch, Width) { Solid = true };

    [Test]
    public void Rows_fit_between_the_sides()
    {
        var lines = Fill(Solid(Region.Rectangle(0, 0, 10, 1.5)) with { Linked = false });
        Assert.That(lines.Select(l => l.Points[0].Y), Is.EqualTo(new[] { 0, 0.375, 0.75, 1.125, 1.5 }).Within(1e-4));
        // Inner rows own what lies between them, outer ones half of it and half a pitch up to the wall.
        Assert.That(lines.Select(l => l.Flow![0]), Is.EqualTo(new[] { 0.96875, 0.9375, 0.9375, 0.9375, 0.96875 }).Within(1e-3));
    }

    // 3.25, 3.5, 10.65 and 10.75 pitches: where nothing is seen, each row lies at most a tenth farther from the next, and all of them at most 0.7 of a pitch.
    [TestCase(1.3, 4)]
    [TestCase(1.4, 5)]
    [TestCase(4.26, 11)]
    [TestCase(4.3, 12)]
    public void There_are_no_more_rows_than_needed(double height, int rows)
    {
        var area = Region.Rectangle(0, 0, 10, height);
        var lines = Fill(Solid(area) with { Linked = false, Hidden = true });
        Assert.That(lines, Has.Count.EqualTo(rows));
        Assert.That(lines.Sum(l => l.Length) * Pitch, Is.EqualTo(10 * (height + Pitch)).Within(1e-2));
    }

    [Test]
    public void Where_nothing_is_seen_links_close_what_a_slanting_edge_leaves_open()
    {
        // The upper edge rises by 15°, so the ends of rows lie 1.5 mm apart on it.
        var area = Region.From(new Polyline([Vec3.Zero, new Vec3(20, 0), new Vec3(20, 9.359), new Vec3(0, 4)], closed: true));
        var seen = Fill(Solid(area));
        Assert.That(seen.Count(l => l.Length < 1), Is.GreaterThan(5));
        Assert.That(Fill(Solid(area) with { Hidden = true }), Has.Count.EqualTo(1));
    }

    [Test]
    public void Ends_of_rows_overlap_with_walls_and_rows_along_them_do_not()
    {
        var lines = Fill(Solid(Region.Rectangle(0, 0, 10, 1.5)) with { Linked = false, Overlap = 0.05 });
        Assert.That(lines.Select(l => l.Points[0].Y), Is.EqualTo(new[] { 0.05, 0.4, 0.75, 1.1, 1.45 }).Within(1e-3));
        Assert.That(lines.Select(l => Math.Abs(l.Points[1].X - l.Points[0].X)), Is.All.EqualTo(10).Within(1e-3));
        Assert.That(lines.Select(l => l.Flow![0]), Is.EqualTo(new[] { 0.9375, 0.875, 0.875, 0.875, 0.9375 }).Within(1e-3));
    }

    [Test]
    public void An_area_thinner_than_a_extrusion_gets_one_row_in_its_middle()
    {
        var line = Fill(Solid(Region.Rectangle(0, 0, 10, 0.03))).Single();
        Assert.That(line.Points.Select(p => p.Y), Is.All.EqualTo(0.015).Within(1e-4));
        Assert.That(line.Flow![0], Is.EqualTo(0.43 / 0.4).Within(1e-3));
    }

    [TestCase(InfillPattern.Lines)]
    [TestCase(InfillPattern.Monotonic)]
    public void Solid_areas_are_covered_once(InfillPattern pattern)
    {
        foreach (var (name, area) in Areas)
        {
            foreach (var angle in new[] { 0.0, 45 })
            {
                var lines = Fill(Solid(area, pattern) with { Angle = angle });
                var target = area.Offset(Pitch / 2, JoinStyle.Miter);
                var extrusions = Beads(lines);
                var covered = Region.Union(extrusions).Intersect(target).Area / target.Area;
                var volume = lines.Sum(l => l.Length) * Pitch / target.Area;
                Assert.That(volume, Is.InRange(0.96, 1.03), $"{name} at {angle}°");
                Assert.That(covered, Is.GreaterThan(name.Contains("thin") ? angle == 0 ? 0.93 : 0.86 : angle == 0 ? 0.985 : 0.965), $"{name} at {angle}°");
            }
        }
    }

    [Test]
    public void Edges_along_the_rows_get_extrusions_as_wide_as_the_gap()
    {
        // Rows at 0, 0.4 … 4; the step at 2.6 leaves 0.2 above the row at 2.4: half an extrusion.
        var area = Region.Rectangle(0, 0, 4, 4).Union(Region.Rectangle(4, 0, 10, 2.6));
        var extrusion = Fill(Solid(area)).Last();
        Assert.That(extrusion.Flow, Is.All.EqualTo(0.5).Within(1e-3));
        Assert.That(extrusion.Points.Select(p => p.Y), Is.All.EqualTo(2.7).Within(1e-3), "from 2.6, where the row's extrusion ends, to the wall's at 2.8");
        Assert.That(extrusion.Points.Max(p => p.X) - extrusion.Points.Min(p => p.X), Is.EqualTo(6).Within(1e-6));
    }

    [Test]
    public void Islands_are_filled_on_their_own_however_small()
    {
        var islands = Region.Rectangle(0, 0, 3, 3).Union(Region.Rectangle(10, 10, 10.2, 10.05)).Union(Region.Rectangle(20, 0, 20.05, 5));
        var lines = Fill(Solid(islands) with { Angle = 45 });
        foreach (var island in islands.Islands) Assert.That(lines.Any(l => island.Offset(0.01).Contains(l.Points[0].X, l.Points[0].Y)), $"{island.Bounds}");
    }

    private static IEnumerable<Region> Beads(IReadOnlyList<InfillLine> lines)
    {
        foreach (var line in lines)
        {
            for (var i = 1; i < line.Points.Length; i++)
                yield return RegionTools.Around([new Polyline([line.Points[i - 1], line.Points[i]])], Pitch / 2 * (line.Flow?[i - 1] ?? 1), arcTolerance: 0.01);
        }
    }
}
