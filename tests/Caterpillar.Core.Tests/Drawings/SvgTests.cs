using System;
using System.Linq;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Curves;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

public class SvgTests
{
    // A page of 100 mm with 1 mm for a unit: y' = 100 − y.
    private static string Page(string content)
        => "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">\n" + content + "\n</svg>";

    private static UserCurve One(string content) => CurveReaderTests.Read(Page(content), "a.svg").Value!.Single();

    private static Vec3 Up(double x, double y) => new(x, 100 - y);

    private static void Near(Vec3 actual, Vec3 expected) => Assert.That(actual.DistanceTo(expected), Is.LessThan(1e-9), actual + " is not " + expected);

    [TestCase("M10 20 L30 20 H50 V60 h-10 v5 l-5,5", 10, 20, 35, 70)]
    [TestCase("m10 20 20 0 l20,0 0 40-10 0 0 5-5 5", 10, 20, 35, 70)]
    public void Lines_are_polylines(string data, double x0, double y0, double x1, double y1)
    {
        var curve = (PolylineCurve)One($"<path d=\"{data}\"/>").Curve;
        Near(curve.Start, Up(x0, y0));
        Near(curve.End, Up(x1, y1));
        Assert.That(curve.Length, Is.EqualTo(20 + 20 + 40 + 10 + 5 + Math.Sqrt(50)).Within(1e-9));
    }

    [Test]
    public void Cubic_curves_and_their_short_forms_go_through_the_same_points()
    {
        var absolute = One("<path d=\"M10 10 C20 10 30 20 30 30 S40 50 50 50\"/>").Curve;
        var relative = One("<path d=\"m10 10 c10 0 20 10 20 20 s10 20 20 20\"/>").Curve;
        var full = One("<path d=\"M10 10 C20 10 30 20 30 30 C30 40 40 50 50 50\"/>").Curve;
        for (var i = 0; i <= 20; i++)
        {
            Near(absolute.PointAt(i / 10.0), full.PointAt(i / 10.0));
            Near(relative.PointAt(i / 10.0), full.PointAt(i / 10.0));
        }
        // The middle of a cubic: (p0 + 3 p1 + 3 p2 + p3)/8.
        Near(full.PointAt(0.5), Up((10 + 60 + 90 + 30) / 8.0, (10 + 30 + 60 + 30) / 8.0));
        Assert.That(CurveMaker.Kinks(full), Is.Empty);
    }

    [Test]
    public void Quadratic_curves_and_their_short_forms_go_through_the_same_points()
    {
        var shorter = One("<path d=\"M0 0Q5 10 10 0T20 0t10 0\"/>").Curve;
        var full = One("<path d=\"M0 0q5 10 10 0q5-10 10 0q5 10 10 0\"/>").Curve;
        for (var i = 0; i <= 30; i++) Near(shorter.PointAt(i / 10.0), full.PointAt(i / 10.0));
        Near(full.PointAt(0.5), Up(5, 5));
        // After another command the control point is the point itself.
        Near(One("<path d=\"M0 0 L10 0 T20 0\"/>").Curve.PointAt(1.5), Up(12.5, 0));
    }

    [TestCase(0, 1, 20, 10, 5, 180.0)]
    [TestCase(0, 0, 20, 10, 5, 180.0)]
    [TestCase(0, 1, 15, 5, 5, 90.0)]
    [TestCase(1, 0, 15, 5, 5, 270.0)]
    [TestCase(0, 0, 15, 5, 5, 90.0)]
    public void Circular_arcs_are_arcs(int large, int sweep, double x, double y, double r, double degrees)
    {
        var arc = (ArcCurve)One($"<path d=\"M10 10 A{r} {r} 0 {large} {sweep} {x} {y}\"/>").Curve;
        Near(arc.Start, Up(10, 10));
        Near(arc.End, Up(x, y));
        Assert.That(Math.Abs(arc.Sweep), Is.EqualTo(degrees).Within(1e-9));
        Assert.That(arc.Radius, Is.EqualTo(r).Within(1e-9));
        // In the file's direction of Y, sweep 1 turns clockwise as seen on screen, and so it does on the bed.
        var turn = arc.Frame.Z.Z * arc.Sweep;
        Assert.That(turn < 0, Is.EqualTo(sweep == 1));
    }

    [Test]
    public void Elliptical_arcs_follow_the_ellipse_and_are_scaled_up_if_too_small()
    {
        var curve = One("<path d=\"M10 50 a30 15 0 0 1 60 0\"/>").Curve;
        Near(CurveMaker.Middle(curve), Up(40, 35));
        var tilted = One("<path d=\"M10 50 a30 15 90 0 1 30 0\"/>").Curve;
        Near(CurveMaker.Middle(tilted), Up(25, 20));
        var grown = (ArcCurve)One("<path d=\"M10 50 a1 1 0 0 1 20 0\"/>").Curve;
        Assert.That(grown.Radius, Is.EqualTo(10).Within(1e-9));
        // Flags need no separators; a radius of 0 is a line.
        Near(One("<path d=\"M10 50a5 5 0 0110 0\"/>").Curve.End, Up(20, 50));
        Assert.That(One("<path d=\"M10 50a0 5 0 0 1 10 0\"/>").Curve, Is.InstanceOf<PolylineCurve>());
    }

    [TestCase(-5, 5)]
    [TestCase(5, -5)]
    [TestCase(-5, -5)]
    [TestCase(-30, 15)]
    [TestCase(30, -15)]
    public void Radii_of_arcs_have_no_sign(double rx, double ry)
    {
        var curve = One($"<path d=\"M10 50 a{rx} {ry} 0 0 1 {2 * Math.Abs(rx)} 0\"/>").Curve;
        Near(CurveMaker.Middle(curve), Up(10 + Math.Abs(rx), 50 - Math.Abs(ry)));
        Near(curve.End, Up(10 + 2 * Math.Abs(rx), 50));
        Assert.That(curve is ArcCurve { Radius: > 0 }, Is.EqualTo(Math.Abs(rx) == Math.Abs(ry)));
    }

    [Test]
    public void A_command_after_closing_starts_at_the_first_point()
    {
        var curves = CurveReaderTests.Read(Page("<path d=\"M10 10h10v10z l-5 5 M50 50 q5 5 10 0 z m10 10 l1 1\"/>"), "a.svg").Value!;
        Assert.That(curves, Has.Count.EqualTo(4));
        Assert.That(curves[0].Curve.IsClosed, Is.True);
        Near(curves[1].Curve.Start, Up(10, 10));
        Near(curves[1].Curve.End, Up(5, 15));
        Assert.That(curves[2].Curve.IsClosed, Is.True);
        Near(curves[3].Curve.Start, Up(60, 60));
    }

    [Test]
    public void Basic_shapes_are_curves()
    {
        var rect = One("<rect x=\"10\" y=\"20\" width=\"30\" height=\"10\"/>").Curve;
        Assert.That(rect.Length, Is.EqualTo(80).Within(1e-9));
        Assert.That(rect.IsClosed, Is.True);
        var round = One("<rect x=\"10\" y=\"20\" width=\"30\" height=\"10\" rx=\"2\"/>").Curve;
        Assert.That(round.Length, Is.EqualTo(80 - 16 + 4 * Math.PI).Within(1e-9));
        Assert.That(round.IsClosed, Is.True);
        Assert.That(CurveMaker.Kinks(round), Is.Empty);
        Assert.That(One("<circle cx=\"50\" cy=\"50\" r=\"7\"/>").Curve.Length, Is.EqualTo(14 * Math.PI).Within(1e-9));
        Assert.That(One("<ellipse cx=\"50\" cy=\"50\" rx=\"7\" ry=\"3\"/>").Curve.Bounds.Size.X, Is.EqualTo(14).Within(1e-9));
        Near(One("<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/>").Curve.End, Up(3, 4));
        Assert.That(One("<polygon points=\"0,0 10,0 10,10\"/>").Curve.IsClosed, Is.True);
        Assert.That(One("<polyline points=\"0,0 10,0 10,10\"/>").Curve.IsClosed, Is.False);
        Near(One("<line x1=\"10%\" y1=\"50%\" x2=\"3\" y2=\"4\"/>").Curve.Start, Up(10, 50));
        Near(One("<svg x=\"30\" y=\"20\" width=\"10\" height=\"10\"><line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4\"/></svg>").Curve.Start, Up(31, 22));
    }

    [TestCase("<ellipse rx=\"7\" ry=\"0\"/>")]
    [TestCase("<ellipse rx=\"0\" ry=\"7\"/>")]
    [TestCase("<circle r=\"0\"/>")]
    public void Shapes_without_a_size_are_not_drawn(string shape)
    {
        var read = CurveReaderTests.Read(Page(shape + "<line x2=\"9\"/>"), "a.svg");
        Assert.That(read.Value!.Single().Curve.Length, Is.EqualTo(9).Within(1e-9));
        Assert.That(read.Diagnostics.Single().Count, Is.EqualTo(1), "Of the one that is not drawn.");
    }

    [TestCase("translate(5,7)", 6, 7)]
    [TestCase("translate(5)", 6, 0)]
    [TestCase("scale(3)", 3, 0)]
    [TestCase("scale(3 2)", 3, 0)]
    [TestCase("rotate(90)", 0, 1)]
    [TestCase("rotate(90 10 10)", 20, 1)]
    [TestCase("matrix(1 2 3 4 5 6)", 6, 8)]
    [TestCase("skewY(45)", 1, 1)]
    [TestCase("skewX(45)", 1, 0)]
    [TestCase("skewY(60)", 1, 1.7320508075688772)]
    [TestCase("skewX(30) translate(0 1)", 1.5773502691896257, 1)]
    [TestCase("translate(5,7) rotate(90), scale(2)", 5, 9)]
    public void Transforms_act_from_the_right(string transform, double x, double y)
    {
        Near(One($"<line transform=\"{transform}\" x1=\"1\" y1=\"0\" x2=\"50\" y2=\"50\"/>").Curve.Start, Up(x, y));
        Near(One($"<g transform=\"translate(1 1)\"><g transform=\"{transform}\"><line x1=\"1\" y1=\"0\" x2=\"50\" y2=\"50\"/></g></g>").Curve.Start,
            Up(x + 1, y + 1));
    }

    [TestCase("width=\"96\" height=\"48\"", 25.4, 12.7)]
    [TestCase("width=\"1in\" height=\"36pt\"", 96 / 96.0 * 25.4, 12.7)]
    [TestCase("width=\"10cm\" height=\"50mm\" viewBox=\"0 0 96 48\"", 100, 50)]
    [TestCase("width=\"100mm\" height=\"100mm\" viewBox=\"0 0 96 48\"", 100, 75)]
    [TestCase("width=\"100mm\" height=\"100mm\" viewBox=\"0 0 96 48\" preserveAspectRatio=\"xMinYMin\"", 100, 100)]
    [TestCase("width=\"100mm\" height=\"100mm\" viewBox=\"0 0 96 48\" preserveAspectRatio=\"none\"", 100, 100)]
    [TestCase("viewBox=\"0 0 96 48\"", 25.4, 12.7)]
    [TestCase("width=\"100%\" height=\"100%\" viewBox=\"0 0 96 48\"", 25.4, 12.7)]
    public void Units_and_viewBox_give_mm(string attributes, double x, double y)
    {
        // From the upper left corner to the middle of the right side.
        var curve = CurveReaderTests.Read($"<svg xmlns=\"http://www.w3.org/2000/svg\" {attributes}><line x1=\"0\" y1=\"0\" x2=\"96\" y2=\"0\"/></svg>", "a.svg")
            .Value!.Single().Curve;
        Near(curve.End, new Vec3(x, y));
    }

    [Test]
    public void Attributes_give_settings_to_shapes_and_groups()
    {
        var curves = CurveReaderTests.Read(Page(
            "<g data-width=\"0.8\" data-z=\"0.4\" data-speed=\"50%\" id=\"outer\"><path id=\"a\" d=\"M0 0h5\"/><path d=\"M0 0h5\" data-width=\"200%\" "
                + "data-tool=\"1\" data-layer=\"3\"/></g><path d=\"M0 0h5\" data-area=\"0\"/>"),
            "a.svg", new CurveReadOptions { SpeedReference = 80, WidthReference = 0.5 }).Value!;
        Assert.That((curves[0].Name, curves[0].Width, curves[0].Speed, curves[0].Curve.Start.Z), Is.EqualTo(("a", 0.8, 40.0, 0.4)));
        Assert.That((curves[1].Width, curves[1].Tool, curves[1].Layer!.Index), Is.EqualTo((1.0, 1, 3)));
        Assert.That((curves[2].Area, curves[2].Width, curves[2].Curve.Start.Z), Is.EqualTo((0.0, (double?)null, 0.0)));
    }

    [Test]
    public void Hidden_elements_and_definitions_are_ignored()
    {
        var read = CurveReaderTests.Read(Page(
            "<defs><path d=\"M0 0h1\"/></defs><g display=\"none\"><path d=\"M0 0h2\"/></g><path style=\"fill:none; display : none\" d=\"M0 "
                + "0h3\"/><image href=\"a.png\"/><use href=\"#a\"/><path d=\"M0 0h4\"/>"), "a.svg");
        Assert.That(read.Value!.Single().Curve.Length, Is.EqualTo(4).Within(1e-9));
        Assert.That(read.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "curves.hidden", "curves.svg_image", "curves.svg_use" }));
        Assert.That(read.Diagnostics[0].Count, Is.EqualTo(2));
    }

    [TestCase("<path d=\"M10 10 L20 x\"/>", "2:21: error curves.svg_path")]
    [TestCase("<path\n d='M10 10\n\tL20 20 K'/>", "4:9: error curves.svg_path")]
    [TestCase("<path d=\"L10 10\"/>", "2:10: error curves.svg_path")]
    [TestCase("<path d=\"M10 10 A5 5 0 2 0 1 1\"/>", "2:24: error curves.svg_path")]
    [TestCase("<g transform=\"turn(5)\"/>", "2:15: error curves.svg")]
    [TestCase("<circle r=\"big\"/>", "2:2: error curves.svg")]
    [TestCase("<path d=\"M0 0h1\" data-width=\"-1\"/>", "2:30: error curves.svg")]
    [TestCase("<g><path d=\"M0 0h1\"/>", "3:3: error curves.svg")]
    public void Bad_svg_is_reported_with_its_place(string content, string expected)
    {
        var read = CurveReaderTests.Read(Page(content), "bad.svg");
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics[0].ToString(), Does.StartWith("bad.svg:" + expected));
    }

    [Test]
    public void Entities_are_not_expanded_and_depth_is_limited()
    {
        var bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;\">]><svg><path d=\"M0 0h5\"/><desc>&b;</desc></svg>";
        Assert.That(() => CurveReaderTests.Read(bomb, "a.svg"), Throws.Nothing);
        var deep = string.Concat(Enumerable.Repeat("<g>", 5000));
        Assert.That(CurveReaderTests.Read("<svg>" + deep, "a.svg").HasErrors, Is.True);
    }

    [TestCase("M0 0 L10 0 L10 10 L0 0 Z", 3)]
    [TestCase("M0 0 L10 0 L10 10 Z", 3)]
    [TestCase("M0 0 L10 0 L10 10 L0 10 L0 0 Z", 4)]
    public void A_path_that_returns_to_its_start_and_closes_has_its_corners_once(string data, int corners)
    {
        var curve = (PolylineCurve)One($"<path d=\"{data}\"/>").Curve;
        Assert.That(curve.IsClosed, Is.True);
        Assert.That(curve.Polyline.Points, Has.Count.EqualTo(corners));
        Assert.That(curve.Polyline.Points, Is.Unique);
    }

    [TestCase("<path d=\"M0 0 L10 0 L0 0 Z\"/>", 20)]
    [TestCase("<polygon points=\"0,0 10,0\"/>", 10)]
    [TestCase("<polygon points=\"0,0 10,0 10,0\"/>", 10)]
    public void Two_corners_are_a_line_there_and_back_at_most(string content, double length)
    {
        var curve = One(content).Curve;
        Assert.That(curve.Length, Is.EqualTo(length).Within(1e-9));
    }

    [TestCase("skewX(0)", 10, 90)]
    [TestCase("skewX(45)", 20, 90)]
    [TestCase("skewY(45)", 10, 80)]
    public void A_skew_moves_points_by_the_tangent_of_its_angle(string transform, double x, double y)
        => Near(One($"<g transform=\"{transform}\"><path d=\"M0 0 L10 10\"/></g>").Curve.End, new Vec3(x, y));

    [TestCase("<path transform=\"skewX(90)\" d=\"M0 0 L10 10\"/>")]
    [TestCase("<path d=\"M0 0 L1e10 10\"/>")]
    public void What_has_no_finite_place_is_an_error(string content)
        => Assert.That(CurveReaderTests.Read(Page(content), "a.svg").Value, Is.Null);

    [TestCase("0 0 0 10")]
    [TestCase("0 0 10 0")]
    [TestCase("0 0 -5 10")]
    public void A_viewBox_without_an_area_is_an_error(string box)
        => Assert.That(CurveReaderTests.Read($"<svg width=\"10mm\" height=\"10mm\" viewBox=\"{box}\"><path d=\"M0 0L1 1\"/></svg>", "a.svg").Value, Is.Null);

    [TestCase("display:none")]
    [TestCase("visibility: hidden")]
    [TestCase("fill: red; display: none")]
    [TestCase("fill: red; visibility:hidden")]
    public void What_a_style_hides_is_not_drawn(string style)
        => Assert.That(One($"<path d=\"M0 0 L5 5\" style=\"{style}\"/><path d=\"M1 1 L2 1\"/>").Curve.Length, Is.EqualTo(1).Within(1e-9));

    [TestCase(".off{display:none}", true)]
    [TestCase("<![CDATA[.off{fill:red;display:none;}]]>", true)]
    [TestCase(".st0{fill:none} .st1, .off{visibility:hidden}", true)]
    [TestCase("/* layers */.off{display:none !important}", true)]
    [TestCase(".off{display:none} .off{display:inline}", false)]
    [TestCase(".on{display:none}", false)]
    [TestCase(".a .off{display:none}", false)]
    [TestCase(".off", false)]
    public void What_a_class_of_a_style_sheet_hides_is_not_drawn(string sheet, bool isHidden)
    {
        var page = Page($"<defs><style>{sheet}</style></defs><path d=\"M0 0 L5 5\" class=\"st0 off\"/><path d=\"M1 1 L2 1\"/>");
        var curves = CurveReaderTests.Read(page, "a.svg");
        Assert.That(curves.Value, Has.Count.EqualTo(isHidden ? 1 : 2));
        Assert.That(curves.Diagnostics.Select(d => d.Code), isHidden ? Does.Contain("curves.hidden") : Has.None.EqualTo("curves.hidden"));
    }

    [Test]
    public void The_attribute_style_counts_more_than_a_class_and_that_more_than_an_attribute()
    {
        const string Sheet = "<style>.off{display:none} .on{display:inline}</style>";
        int Drawn(string attributes) => CurveReaderTests.Read(Page($"{Sheet}<path d=\"M0 0 L5 5\" {attributes}/>"), "a.svg").Value?.Count ?? 0;
        Assert.That(Drawn("class=\"off\" style=\"display:inline\""), Is.EqualTo(1));
        Assert.That(Drawn("class=\"on\" display=\"none\""), Is.EqualTo(1));
        Assert.That(Drawn("class=\"off\" display=\"inline\""), Is.EqualTo(0));
    }

    [Test]
    public void Percentages_are_of_the_width_the_height_or_the_diagonal()
    {
        string In(string content) => $"<svg width=\"60mm\" height=\"80mm\" viewBox=\"0 0 60 80\">{content}</svg>";
        double LengthOf(string content) => CurveReaderTests.Read(In(content), "a.svg").Value!.Single().Curve.Length;
        // The diagonal by the standard: √((60² + 80²)/2) = 70.71.
        Assert.That(LengthOf("<circle cx=\"50%\" cy=\"50%\" r=\"10%\"/>"), Is.EqualTo(2 * Math.PI * 0.1 * Math.Sqrt(5000)).Within(1e-9));
        Assert.That(LengthOf("<line x1=\"0\" y1=\"50%\" x2=\"50%\" y2=\"50%\"/>"), Is.EqualTo(30).Within(1e-9));
        Assert.That(LengthOf("<line x1=\"10\" y1=\"0%\" x2=\"10\" y2=\"50%\"/>"), Is.EqualTo(40).Within(1e-9));
    }

    [TestCase("rx=\"5\"")]
    [TestCase("ry=\"5\"")]
    [TestCase("rx=\"5\" ry=\"auto\"")]
    [TestCase("rx=\"auto\" ry=\"5\"")]
    [TestCase("rx=\"5\" ry=\"5\"")]
    public void A_radius_that_a_rectangle_does_not_state_is_the_other_one(string radii)
        => Assert.That(One($"<rect x=\"9\" y=\"9\" width=\"40\" height=\"20\" {radii}/>").Curve.Length, Is.EqualTo(2 * (30 + 10) + 10 * Math.PI).Within(1e-6));
}
