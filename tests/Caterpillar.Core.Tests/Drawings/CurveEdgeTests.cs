using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

/// <summary>Files of curves and ramps at their limits.</summary>
public class CurveEdgeTests
{
    [TestCase(64, null)]
    [TestCase(65, "curves.csv")]
    public void A_row_has_at_most_64_cells(int cells, string? error)
    {
        var names = string.Join(",", Enumerable.Range(0, cells).Select(i => i switch { 0 => "x", 1 => "y", _ => "c" + i }));
        var read = Read(names + "\n" + string.Join(",", Enumerable.Repeat("0", cells)) + "\n" + string.Join(",", Enumerable.Repeat("1", cells)) + "\n");
        Assert.That(read.Diagnostics.FirstOrDefault(d => d.Code != "curves.ignored")?.Code, Is.EqualTo(error));
    }

    [TestCase("x,y,curve\n0,0,\"a,b\"\n1,0,\"a,b\"\n", "a,b")]
    [TestCase("x;y;curve\n0;0;  a b \n1;0;  a b \n", "a b")]
    [TestCase("x;y;curve\n0;0;\"open\n1;0;\"open\n", "open")]
    [TestCase("x y curve\n0 0 \"a b\"\n1 0 \"a b\"\n", "a b")]
    [TestCase("x y curve\n 0   0   'q'  \n1 0 'q'\n", "q")]
    public void Cells_are_quoted_or_trimmed(string text, string name) => Assert.That(Read(text).Value!.Single().Name, Is.EqualTo(name));

    [TestCase("tool", "1000", null)]
    [TestCase("tool", "1001", "curves.number")]
    [TestCase("layer", "1e8", null)]
    [TestCase("layer", "-1e8", null)]
    [TestCase("layer", "1.01e8", "curves.number")]
    [TestCase("layer", "-1.01e8", "curves.number")]
    [TestCase("dot", "-1", "curves.bead")]
    [TestCase("width", "0", null)]
    [TestCase("width", "-0.1", "curves.bead")]
    [TestCase("width", "-inf", "curves.not_finite")]
    [TestCase("width", "+INFINITY", "curves.not_finite")]
    [TestCase("width", "infinite", "curves.number")]
    [TestCase("width", "na", "curves.number")]
    [TestCase("z", "50%", "curves.percent")]
    [TestCase("flow", "50 %", null)]
    [TestCase("width", "1.5.5", "curves.number")]
    public void Settings_have_their_ranges(string column, string value, string? error)
    {
        var read = Read($"x,y,{column}\n0,0,{value}\n1,0,{value}\n");
        Assert.That(read.Diagnostics.FirstOrDefault()?.Code, Is.EqualTo(error));
    }

    [TestCase("0;0;1,5", 1.5)]
    [TestCase("0;0;1,525", 1.525)]
    [TestCase("0;0;1.5", 1.5)]
    [TestCase("0;0;1,5,5", null)]
    [TestCase("0;0;1.5,5", null)]
    public void A_decimal_comma_stands_alone(string row, double? z)
        => Assert.That(Read(row + "\n" + row.Replace("0;0", "1;0") + "\n").Value?[0].Curve.Start.Z, Is.EqualTo(z));

    [TestCase(30, false)]
    [TestCase(31, true)]
    public void Long_words_are_shortened_in_messages(int length, bool cut)
    {
        var word = new string('q', length);
        Assert.That(Read($"x,y,{word}\n0,0,1\n1,0,1\n").Diagnostics.Single().Message,
            Does.Contain(cut ? "\"" + word.Substring(0, 30) + "…\"" : "\"" + word + "\""));
    }

    [Test]
    public void Long_curves_keep_all_points_and_each_curve_its_line()
    {
        var rows = Enumerable.Range(0, 700).Select(i => i + ",1,2").ToArray();
        var read = Read(string.Join("\n", rows.Take(600)) + "\n\n" + string.Join("\n", rows.Skip(600)) + "\n", new CurveReadOptions { UnitLength = 10 }).Value!;
        Assert.That(read.Select(c => ((PolylineCurve)c.Curve).Polyline.Count), Is.EqualTo(new[] { 600, 100 }));
        Assert.That(((PolylineCurve)read[0].Curve).Polyline.Points, Is.EqualTo(Enumerable.Range(0, 600).Select(i => new Vec3(10 * i, 10, 20))));
        Assert.That(read.Select(c => c.Source!.Line), Is.EqualTo(new int?[] { 1, 602 }));
    }

    [TestCase("1,2,3\n1,2,1e999\n", "2:5: error curves.not_finite")]
    [TestCase("1,2,3\n1,1e999,2\n", "2:3: error curves.not_finite")]
    [TestCase("1,2,3\n1,2,3,4\n", "2:1: error curves.csv")]
    [TestCase("1,2,3\n1,2\n", "2:1: error curves.csv")]
    [TestCase("1,2,3\n1,,3\n", "2:3: error curves.number")]
    [TestCase("x,y,z\n1,2,3x\n", "2:5: error curves.number")]
    public void Rows_of_plain_numbers_are_as_strict_as_others(string text, string expected)
        => Assert.That(Read(text).Diagnostics[0].ToString(), Does.StartWith("a.csv:" + expected));

    [TestCase("width_mm")]
    [TestCase("Width (mm)")]
    [TestCase("width [mm]")]
    [TestCase("\"line_width\"")]
    [TestCase("W")]
    public void Names_of_columns_may_carry_a_unit(string name)
        => Assert.That(Read($"x,y,{name}\n0,0,0.7\n1,0,0.7\n").Value!.Single().Width, Is.EqualTo(0.7));

    [TestCase("layer_height_mm", 0.7, 0, 0, 0)]
    [TestCase("print_speed_mm_s", 0, 0.7, 0, 0)]
    [TestCase("area_mm2", 0, 0, 0.7, 0)]
    [TestCase("flow", 0, 0, 0, 0.7)]
    public void Columns_go_where_they_are_named(string name, double height, double speed, double area, double flow)
    {
        var curve = Read($"x,y,{name}\n0,0,0.7\n1,0,0.7\n").Value!.Single();
        Assert.That((curve.Height ?? 0, curve.Speed ?? 0, curve.Area ?? 0, curve.Flow ?? 0), Is.EqualTo((height, speed, area, flow)));
    }

    // The area of 0.1 mm² grows to 0.2: by half of the larger, in steps of a tenth of it.
    [TestCase(0.1, 0.2, 5)]
    [TestCase(0.2, 0.1, 5)]
    [TestCase(0.1, 0.21, 6)]
    [TestCase(0.0, 1.0, 10)]
    [TestCase(0.1, 0.1, 1)]
    public void A_ramp_changes_in_steps_of_the_larger_area(double from, double to, int parts)
    {
        var curve = new UserCurve(new PolylineCurve([Vec3.Zero, new Vec3(10, 0)], false)) { Along = new PointValues([from, to], null, null, null) };
        var path = CurvePaths.ToPaths([curve]).Value!.Single();
        Assert.That(path.SegmentCount, Is.EqualTo(parts));
        Assert.That(path.Volume, Is.EqualTo(10 * (from + to) / 2).Within(1e-9));
        Assert.That(path.BeadOf(0).Area, Is.EqualTo(from + (to - from) * 0.5 / parts).Within(1e-12));
        Assert.That(path.BeadOf(parts - 1).Area, Is.EqualTo(to - (to - from) * 0.5 / parts).Within(1e-12));
    }

    [Test]
    public void Extrusions_get_their_cross_section_from_the_curve_or_the_options()
    {
        Bead Of(Func<UserCurve, UserCurve> change, CurveOptions? options = null)
            => CurvePaths.ToPaths([change(new UserCurve(new PolylineCurve([Vec3.Zero, Vec3.UnitX], false)))],
                options ?? new CurveOptions { Width = 0.5, Height = 0.2, Speed = 9 }).Value!.Single().BeadOf(0);
        Assert.That(Of(c => c), Is.EqualTo(new Bead(0.1, 0.2, 9)));
        Assert.That(Of(c => c with { Width = 1 }), Is.EqualTo(new Bead(0.2, 0.2, 9)));
        Assert.That(Of(c => c with { Area = 0.7, Width = 1, Flow = 5 }), Is.EqualTo(new Bead(0.7, 0.2, 9)), "a given area is the whole");
        Assert.That(Of(c => c with { Flow = 2, Height = 0.4, Speed = 3 }).Area, Is.EqualTo(0.4).Within(1e-12));
        Assert.That(Of(c => c with { Area = 0.7 }, new CurveOptions { Strokes = true, Height = 0.3 }), Is.EqualTo(new Bead(0, 0.3)));
        var stadium = new CurveOptions { Width = 0.2, Height = 0.2, Shape = BeadShape.Stadium };
        Assert.That(Of(c => c, stadium).Area, Is.EqualTo(Math.PI / 4 * 0.04).Within(1e-12));
        Assert.That(Of(c => c with { Width = 0.1 }, stadium).Area, Is.EqualTo(Math.PI / 4 * 0.01).Within(1e-12), "too narrow for the shape: round");
    }

    [TestCase(0.0, false)]
    [TestCase(-0.001, true)]
    public void Curves_below_the_bed_are_reported(double z, bool below)
    {
        var result = CurvePaths.ToPaths([new UserCurve(new PolylineCurve([Vec3.Zero, new Vec3(5, 0, z)], false))]);
        Assert.That(result.Diagnostics.Any(d => d.Code == "curves.below_bed"), Is.EqualTo(below));
    }

    private static Result<System.Collections.Generic.IReadOnlyList<UserCurve>> Read(string text, CurveReadOptions? options = null)
        => CurveReaderTests.Read(text, "a.csv", options);
}
