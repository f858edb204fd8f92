using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

/// <summary>Numbers, places and shapes of SVG at their limits, and letters on their grid.</summary>
public class SvgEdgeTests
{
    [TestCase("<path d=\"M0 0 L1e9 0\"/>", null)]
    [TestCase("<path d=\"M0 0 L1.001e9 0\"/>", "2:16: error curves.svg_path")]
    [TestCase("<polyline points=\"0,0 -1e9,0\"/>", null)]
    [TestCase("<polyline points=\"0,0 -1.001e9,0\"/>", "2:2: error curves.svg")]
    [TestCase("<line x2=\"1e9\"/>", null)]
    [TestCase("<line x2=\"1.001e9\"/>", "2:2: error curves.svg")]
    [TestCase("<path d=\"M0 0h1\" data-z=\"1e9\"/>", null)]
    [TestCase("<path d=\"M0 0h1\" data-z=\"1.001e9\"/>", "2:26: error curves.svg")]
    [TestCase("<path d=\"M0 0h1\" data-tool=\"1000\"/>", null)]
    [TestCase("<path d=\"M0 0h1\" data-tool=\"1001\"/>", "2:29: error curves.svg")]
    [TestCase("<path d=\"M0 0h1\" data-width=\"0\"/>", null)]
    [TestCase("<path d=\"M0 0h1\" data-width=\"-1\"/>", "2:30: error curves.svg")]
    [TestCase("<path d=\"M0 0h1\" data-layer=\"x\"/>", "2:30: error curves.svg")]
    [TestCase("<rect width=\"5\" height=\"5\" rx=\"-1\"/>", "2:2: error curves.svg")]
    [TestCase("<rect width=\"-5\" height=\"5\"/>", "2:2: error curves.svg")]
    [TestCase("<ellipse rx=\"-5\" ry=\"5\"/>", "2:2: error curves.svg")]
    [TestCase("<rect width=\"0.5\" height=\"0.5\"/>", null)]
    [TestCase("<path d=\"M0 0h1\"/><text font-size=\"0\">H</text>", null)]
    // Entities and line ends count as they stand in the file.
    [TestCase("<path d=\"M0 0 &#76;5 x\"/>", "2:22: error curves.svg_path")]
    [TestCase("<path d='M0 0\r\nL5 x'/>", "3:4: error curves.svg_path")]
    [TestCase("<path d='M0 0\nL5 x'/>", "3:4: error curves.svg_path")]
    [TestCase("<path d='L5 5'/>", "2:10: error curves.svg_path")]
    [TestCase("<path d='M5 5 B'/>", "2:15: error curves.svg_path")]
    [TestCase("<path d='M0 0 A5 5 0 2 1 9 9'/>", "2:22: error curves.svg_path")]
    public void Wrong_values_are_reported_where_they_stand(string content, string? error)
    {
        var read = Read(content);
        var first = read.Diagnostics.FirstOrDefault(d => d.Severity == Severity.Error);
        if (error is null) Assert.That(first, Is.Null);
        else Assert.That(first!.ToString(), Does.StartWith("a.svg:" + error));
    }

    [TestCase("M0 0L5 0L5 5L0 0Z", 3, true)]
    [TestCase("M0 0L5 0L5 5Z", 3, true)]
    [TestCase("M0 0L5 0Z", 3, false)]
    [TestCase("M0 0L5 0L5 5L0 0", 4, false)]
    [TestCase("M0 0L5 0L5 0L5 5", 3, false)]
    public void Polylines_of_paths_close_with_three_corners(string data, int points, bool closed)
    {
        var line = (PolylineCurve)Read($"<path d=\"{data}\"/>").Value!.Single().Curve;
        Assert.That((line.Polyline.Count, line.Polyline.IsClosed), Is.EqualTo((points, closed)));
    }

    [TestCase("polyline", "0,0 5,0 5,5 0,0", 3, true)]
    [TestCase("polyline", "0,0 5,0 0,0", 3, false)]
    [TestCase("polyline", "0,0 5,0 5,0 5,5", 3, false)]
    [TestCase("polygon", "0,0 5,0 5,5", 3, true)]
    [TestCase("polygon", "0,0 5,0", 2, false)]
    public void Corners_that_repeat_are_one(string element, string list, int points, bool closed)
    {
        var line = (PolylineCurve)Read($"<{element} points=\"{list}\"/>").Value!.Single().Curve;
        Assert.That((line.Polyline.Count, line.Polyline.IsClosed), Is.EqualTo((points, closed)));
    }

    [TestCase("rx=\"2\"", 16 + 4 * Math.PI, 8)]
    [TestCase("rx=\"3\"", 8 + 6 * Math.PI, 6)]
    public void A_rounded_rectangle_has_quarter_circles_and_what_is_left_of_its_sides(string radii, double length, int pieces)
    {
        var curve = Read($"<rect x=\"1\" y=\"2\" width=\"10\" height=\"6\" {radii}/>").Value!.Single().Curve;
        Assert.That(curve.Length, Is.EqualTo(length).Within(1e-6));
        Assert.That(((PolyCurve)curve).Pieces, Has.Count.EqualTo(pieces));
        Assert.That(curve.Bounds.Min.DistanceTo(new Vec3(1, 92)) + curve.Bounds.Max.DistanceTo(new Vec3(11, 98)), Is.LessThan(1e-9));
        Assert.That(curve.IsClosed, Is.True);
    }

    // From (0, 0) to (10, 0) with a radius of 10: small arcs bulge by 10 (1 - cos 30°), large ones by 10 (1 + cos 30°).
    [TestCase(0, 0, 1.3397459621556, 30)]
    [TestCase(0, 1, -1.3397459621556, 30)]
    [TestCase(1, 0, 18.660254037844, 150)]
    [TestCase(1, 1, -18.660254037844, 150)]
    public void Flags_choose_one_of_four_arcs(int large, int positive, double bulge, double halfSweep)
    {
        var arc = Read($"<path d=\"M0 50A10 10 0 {large}{positive} 10 50\"/>").Value!.Single().Curve;
        Assert.That(arc.Length, Is.EqualTo(10 * 2 * halfSweep * Math.PI / 180).Within(1e-6));
        var box = arc.Bounds;
        // Y points down in the file.
        Assert.That(bulge > 0 ? 50 - box.Min.Y : box.Max.Y - 50, Is.EqualTo(Math.Abs(bulge)).Within(1e-6));
        Assert.That((arc.Start.DistanceTo(new Vec3(0, 50)), arc.End.DistanceTo(new Vec3(10, 50))), Is.EqualTo((0.0, 0.0)).Within(1e-9));
    }

    [Test]
    public void Places_and_progress_are_those_of_the_whole_file()
    {
        const string Bad = "\n<svg xmlns=\"http://www.w3.org/2000/svg\">\n<path d=\"x\"/></svg>";
        Assert.That(CurveReaderTests.Read(Bad, "a.svg").Diagnostics.Last().ToString(), Does.StartWith("a.svg:3:10: error curves.svg_path"));
        var shares = new System.Collections.Generic.List<double>();
        var text = "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + string.Concat(Enumerable.Repeat("<path d=\"M0 0h1\"/>\n", 50)) + "</svg>";
        CurveReader.Read(System.Text.Encoding.ASCII.GetBytes(text), "a.svg", null, new Shares(shares));
        Assert.That(shares, Is.Ordered.And.All.InRange(0.0, 1.0));
        Assert.That(shares.Count(s => s > 0 && s < 1), Is.GreaterThan(40));
    }

    [Test]
    public void Elements_without_curves_are_reported_once_with_the_name_of_the_first()
    {
        var read = Read("<path d=\"M0 0h1\"/><qwertyuiopasdfghjklzxcvbnmqwertyuiop/><other/><z:x xmlns:z=\"urn:z\"/>");
        Assert.That(read.Diagnostics.Single().ToString(), Does.Contain("curves.ignored").And.Contain("\"qwertyuiopasdfghjklzxcvbnmqwer\""));
        Assert.That(Read("<path d=\"M0 0h1\"/><z:x xmlns:z=\"urn:z\"/>").Diagnostics, Is.Empty, "what editors note for themselves");
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Files_of_two_bytes_a_character_are_read(bool bigEndian)
    {
        var encoding = new System.Text.UnicodeEncoding(bigEndian, true);
        var text = "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0h96\"/></svg>";
        var curves = CurveReader.Read([.. encoding.GetPreamble(), .. encoding.GetBytes(text)], "a.svg").Value!;
        Assert.That(curves.Single().Curve.Length, Is.EqualTo(25.4).Within(1e-9));
    }

    // A loop that comes back to where it began, and curves that stay there.
    [TestCase("M0 0Q9 9 0 0", 1)]
    [TestCase("M0 0Q0 0 9 0", 1)]
    [TestCase("M0 0h1Q1 0 1 0", 1)]
    [TestCase("M0 0C9 0 0 9 0 0", 1)]
    [TestCase("M0 0h1C1 0 1 0 1 0", 1)]
    public void Curves_without_extent_are_left_out(string data, int curves)
        => Assert.That(Read($"<path d=\"{data}\"/>").Value, Has.Count.EqualTo(curves));

    private sealed class Shares(System.Collections.Generic.List<double> shares) : IProgress<double>
    {
        public void Report(double value) => shares.Add(value);
    }

    [TestCase("A B", "  A \n\t B  ")]
    [TestCase("AB", "AB ")]
    public void Spaces_in_text_are_one_space(string plain, string spaced)
        => Assert.That(Box($"<text x=\"10\" y=\"50\">{spaced}</text>"), Is.EqualTo(Box($"<text x=\"10\" y=\"50\">{plain}</text>")));

    [TestCase("1e6", 1e6)]
    [TestCase("1000001", 16)]
    [TestCase("wide", 16)]
    public void Sizes_of_fonts_are_lengths_within_reason(string text, double size)
        => Assert.That(Box($"<text font-size=\"{text}\">H</text>").Size.Y, Is.EqualTo(0.7 * size).Within(1e-6 * size));

    [TestCase('e', '\u00EA', 3.0)]
    [TestCase('E', '\u00CA', 3.5)]
    [TestCase('i', '\u00EE', 0.5)]
    public void An_accent_stands_over_the_middle_of_its_letter(char letter, char accented, double middle)
    {
        // On the grid capitals are 12 high, small letters 8.
        var (plain, whole) = (StrokeFont.Strokes(letter.ToString(), 12), StrokeFont.Strokes(accented.ToString(), 12));
        var dots = letter == 'i' ? 1 : 0;
        Assert.That(whole.Take(plain.Count - dots), Is.EqualTo(plain.Take(plain.Count - dots)), "an accent takes the place of the dot");
        var mark = Bounds.Of(whole.Skip(plain.Count - dots).SelectMany(s => s));
        Assert.That(mark.Center.X, Is.EqualTo(middle).Within(1e-12));
        Assert.That(mark.Min.Y, Is.GreaterThanOrEqualTo(char.IsUpper(letter) ? 12 : 8));
        Assert.That(StrokeFont.Advance(accented.ToString(), 12), Is.EqualTo(StrokeFont.Advance(letter.ToString(), 12)));
    }

    [Test]
    public void Letters_stand_on_their_grid()
    {
        Assert.That(StrokeFont.Strokes("L", 12).Single(), Is.EqualTo(new[] { new Vec3(0, 12), new Vec3(0, 0), new Vec3(6, 0) }));
        Assert.That(StrokeFont.Strokes("LL", 24)[1], Is.EqualTo(new[] { new Vec3(18, 24), new Vec3(18, 0), new Vec3(30, 0) }));
        Assert.That(StrokeFont.Advance("LL", 24), Is.EqualTo(36));
        // A cedilla hangs from the line; what is unknown is a box.
        Assert.That(StrokeFont.Strokes("\u00E7", 12).Skip(1).SelectMany(s => s).Max(p => p.Y), Is.LessThanOrEqualTo(0));
        Assert.That(StrokeFont.Strokes("\u4E00", 12).Single(),
            Is.EqualTo(new[] { new Vec3(0, 0), new Vec3(6, 0), new Vec3(6, 12), new Vec3(0, 12), new Vec3(0, 0) }));
        Assert.That(("\u4E00"[0], StrokeFont.Has('\u4E00'), StrokeFont.Has('\u00E7'), StrokeFont.Has('~'), StrokeFont.Has('\u007F')),
            Is.EqualTo(('\u4E00', false, true, true, false)));
        foreach (var wrong in new[] { 0, -1, double.NaN, double.PositiveInfinity })
            Assert.That(() => StrokeFont.Strokes("a", wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase("xMidYMid", 25, 50, 0, 50)]
    [TestCase("xMinYMin", 0, 50, 0, 50)]
    [TestCase("xMaxYMax", 50, 50, 0, 50)]
    [TestCase("xMidYMid slice", 0, 100, -25, 100)]
    [TestCase("xMinYMin slice", 0, 100, 0, 100)]
    [TestCase("xMaxYMax slice", 0, 100, -50, 100)]
    [TestCase("none", 0, 100, 0, 50)]
    public void A_view_box_is_fitted_into_its_window(string aspect, double x, double width, double y, double height)
    {
        // A square of 10 units in a window of 100 by 50.
        var map = SvgValues.ViewBox([5, 6, 10, 10], 0, 0, 100, 50, aspect);
        var (low, high) = (map.Apply(new Vec3(5, 6)), map.Apply(new Vec3(15, 16)));
        Assert.That((low.X, low.Y), Is.EqualTo((x, y)).Within(1e-12));
        Assert.That((high.X - low.X, high.Y - low.Y), Is.EqualTo((width, height)).Within(1e-12));
    }

    [TestCase("2mm", 2 * 96 / 25.4)]
    [TestCase("2cm", 20 * 96 / 25.4)]
    [TestCase("2in", 192)]
    [TestCase("2pt", 192 / 72.0)]
    [TestCase("2pc", 32)]
    [TestCase("2Q", 0.5 * 96 / 25.4)]
    [TestCase("2px", 2)]
    [TestCase("2", 2)]
    [TestCase("2%", 6)]
    [TestCase("2em", null)]
    [TestCase("mm", null)]
    public void Lengths_are_in_pixels(string text, double? pixels)
        => Assert.That(SvgValues.Length(text, 300), pixels is null ? Is.Null : Is.EqualTo(pixels).Within(1e-12));

    [TestCase("matrix(1 2 3 4 5 6)", 1 + 6 + 5, 2 + 8 + 6)]
    [TestCase("translate(3)", 4, 2)]
    [TestCase("translate(3,4)", 4, 6)]
    [TestCase("scale(3)", 3, 6)]
    [TestCase("scale(3,4)", 3, 8)]
    [TestCase("rotate(90)", -2, 1)]
    [TestCase("rotate(90 1 1)", 0, 1)]
    [TestCase("skewX(45)", 3, 2)]
    [TestCase("skewY(45)", 1, 3)]
    [TestCase("translate(3) scale(2)", 5, 4)]
    public void Transforms_move_the_point_1_2(string text, double x, double y)
    {
        var at = SvgValues.Transform(text)!.Value.Apply(new Vec3(1, 2));
        Assert.That((at.X, at.Y), Is.EqualTo((x, y)).Within(1e-12));
    }

    [TestCase("rotate(1,2)")]
    [TestCase("matrix(1 2 3 4 5)")]
    [TestCase("scale()")]
    [TestCase("translate(1 2 3)")]
    [TestCase("skewX(90)")]
    [TestCase("skewY(90)")]
    [TestCase("turn(4)")]
    [TestCase("scale(2")]
    [TestCase("scale 2)")]
    public void What_is_no_transform_is_refused(string text) => Assert.That(SvgValues.Transform(text), Is.Null);

    private static Result<System.Collections.Generic.IReadOnlyList<UserCurve>> Read(string content)
        => CurveReaderTests.Read("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">\n" + content + "\n</svg>",
            "a.svg");

    private static Bounds Box(string content) => Read(content).Value!.Aggregate(Bounds.Empty, (box, curve) => box.Include(curve.Curve.Bounds));
}
