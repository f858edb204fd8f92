using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

/// <summary>Elements that refer to others, and text.</summary>
public class SvgUseTests
{
    // A page of 100 mm with 1 mm for a unit: y' = 100 − y.
    private static Result<System.Collections.Generic.IReadOnlyList<UserCurve>> Read(string content, CurveReadOptions? options = null)
        => CurveReaderTests.Read("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"100mm\" height=\"100mm\" "
            + "viewBox=\"0 0 100 100\">\n" + content + "\n</svg>", "a.svg", options);

    private static Bounds Box(string content)
        => Read(content).Value!.Aggregate(Bounds.Empty, (box, curve) => box.Include(curve.Curve.Bounds));

    private static void Near(Bounds box, double x0, double y0, double x1, double y1)
    {
        Assert.That(new[] { box.Min.X, box.Min.Y, box.Max.X, box.Max.Y }, Is.EqualTo(new[] { x0, 100 - y1, x1, 100 - y0 }).Within(1e-9));
    }

    private const string Line = "<defs><g id=\"a\"><path d=\"M0 0h5v2\"/></g></defs>";

    [TestCase("<use href=\"#a\" x=\"10\" y=\"20\"/>", 10, 20, 15, 22)]
    [TestCase("<use xlink:href=\"#a\" transform=\"scale(2)\" x=\"10\" y=\"20\"/>", 20, 40, 30, 44)]
    [TestCase("<g transform=\"translate(1,2)\"><use href=\"#a\"/></g>", 1, 2, 6, 4)]
    [TestCase("<g id=\"b\"><use href=\"#a\" x=\"10\"/></g><use href=\"#b\" y=\"50\"/>", 10, 0, 15, 52)]
    [TestCase("<use href=\"#later\" x=\"3\"/><defs><path id=\"later\" d=\"M0 0h5v2\"/></defs>", 3, 0, 8, 2)]
    public void A_use_draws_what_it_refers_to_where_it_stands(string content, double x0, double y0, double x1, double y1)
        => Near(Box(Line + content), x0, y0, x1, y1);

    [Test]
    public void A_symbol_fills_the_box_of_its_use()
    {
        const string Symbol = "<symbol id=\"s\" viewBox=\"0 0 10 10\"><path d=\"M0 0 L10 10\"/></symbol>";
        Assert.That(Read(Symbol).Diagnostics.Single().Code, Is.EqualTo("curves.empty"));
        Near(Box(Symbol + "<use href=\"#s\" x=\"5\" y=\"6\" width=\"20\" height=\"20\"/>"), 5, 6, 25, 26);
        Near(Box(Symbol + "<use href=\"#s\" x=\"5\" y=\"6\" width=\"40\" height=\"20\"/>"), 15, 6, 35, 26);
        Near(Box(Symbol + "<use href=\"#s\"/>"), 0, 0, 100, 100);
    }

    [Test]
    public void Settings_of_a_use_are_those_of_what_it_draws()
    {
        var curve = Read(Line + "<use href=\"#a\" data-width=\"0.8\" data-tool=\"2\"/>").Value!.Single();
        Assert.That((curve.Width, curve.Tool), Is.EqualTo((0.8, 2)));
    }

    [Test]
    public void Uses_of_nothing_and_of_themselves_are_reported()
    {
        var read = Read("<use href=\"#none\"/><path d=\"M0 0h1\"/>");
        Assert.That(read.Diagnostics.Single().Code, Is.EqualTo("curves.svg_use"));
        Assert.That(read.Value, Has.Count.EqualTo(1));
        Assert.That(Read("<g id=\"a\"><use href=\"#a\"/></g>").Diagnostics.Single().ToString(), Does.StartWith("a.svg:2:").And.Contain("refer to each other"));
    }

    [Test]
    public void Uses_that_multiply_stop_at_their_limit()
    {
        var levels = string.Concat(Enumerable.Range(1, 12).Select(i
            => $"<g id=\"g{i}\">" + string.Concat(Enumerable.Repeat($"<use href=\"#g{i - 1}\"/>", 10)) + "</g>"));
        var content = "<defs><path id=\"g0\" d=\"M0 0h1\"/>" + levels + "</defs><use href=\"#g12\"/>";
        Assert.That(Read(content).HasErrors, Is.True);
        Assert.That(Read(content, new CurveReadOptions { Memory = new MemoryLimit(100_000) }).Diagnostics.Single().Code, Is.EqualTo(MemoryLimit.Code));
    }

    [Test]
    public void Text_is_reported_and_left_out()
    {
        var read = Read("<text y=\"50\">A<tspan>B</tspan></text><path d=\"M0 0h1\"/><text>C</text>");
        Assert.That(read.Diagnostics.Single().ToString(), Does.StartWith("a.svg:2:").And.Contain("curves.svg_text"));
        Assert.That(read.Value, Has.Count.EqualTo(1));
    }
}
