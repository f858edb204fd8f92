using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

/// <summary>Elements that refer to others, and text in letters of single strokes.</summary>
public class SvgTextTests
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
    public void After_a_text_the_drawing_goes_on()
    {
        var curves = Read("<text x=\"10\" y=\"20\">I<tspan>I</tspan></text><path d=\"M50 60h5v2\"/>").Value!;
        Near(curves[curves.Count - 1].Curve.Bounds, 50, 60, 55, 62);
    }

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

    [Category("Arithmetic")]
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
    public void Capitals_are_seven_tenths_of_the_size_of_the_font()
    {
        Near(Box("<text x=\"10\" y=\"50\" font-size=\"20\">H</text>"), 10, 36, 10 + 14 * 8 / 12.0, 50);
        Near(Box("<text x=\"10\" y=\"50\" style=\"font-size: 20px\">x</text>"), 10, 50 - 14 * 8 / 12.0, 17, 50);
        Assert.That(Read("<text font-size=\"20\" y=\"50\">H</text>").Value, Has.Count.EqualTo(3));
    }

    [TestCase("start", 10)]
    [TestCase("middle", 5)]
    [TestCase("end", 0)]
    public void Text_is_anchored(string anchor, double left)
    {
        var advance = StrokeFont.Advance("HI", 14);
        var box = Box($"<text x=\"10\" y=\"50\" font-size=\"20\" text-anchor=\"{anchor}\">HI</text>");
        Assert.That(box.Min.X, Is.EqualTo(10 - advance * (10 - left) / 10).Within(1e-9));
    }

    [Test]
    public void Pieces_of_text_follow_each_other_or_begin_where_they_say()
    {
        string Text(string content) => string.Join("\n", Read($"<text x=\"10\" y=\"50\">{content}</text>").Value!.Select(c => c.Curve.Bounds.ToString()));
        Assert.That(Text("A<tspan>B</tspan>C"), Is.EqualTo(Text("ABC")));
        Assert.That(Text("A\n   B"), Is.EqualTo(Text("A B")));
        Assert.That(Text("<tspan x=\"10\" dy=\"20\">A</tspan>"), Is.EqualTo(string.Join("\n", Read("<text x=\"10\" y=\"70\">A</text>").Value!
            .Select(c => c.Curve.Bounds.ToString()))));
    }

    [Test]
    public void Every_printable_character_of_ascii_has_a_shape_within_its_box()
    {
        for (var c = ' '; c <= '~'; c++)
        {
            Assert.That(StrokeFont.Has(c), Is.True, c.ToString());
            var strokes = StrokeFont.Strokes(c.ToString(), 12);
            Assert.That(strokes.Count, c == ' ' ? Is.Zero : Is.Positive, c.ToString());
            var width = StrokeFont.Advance(c.ToString(), 12) - 3;
            foreach (var point in strokes.SelectMany(s => s))
            {
                Assert.That(point.X, Is.InRange(0, width), c.ToString());
                Assert.That(point.Y, Is.InRange(-4, 14), c.ToString());
            }
            Assert.That(strokes.All(s => s.Length > 1), Is.True, c.ToString());
        }
        var shapes = Enumerable.Range('!', '~' - ' ').Select(c => string.Join(";", StrokeFont.Strokes(((char)c).ToString(), 12).SelectMany(s => s))).ToArray();
        Assert.That(shapes.Distinct().Count(), Is.EqualTo(shapes.Length));
    }

    [Test]
    public void Letters_with_accents_are_the_letter_and_the_accent()
    {
        foreach (var (composed, letter) in new[] { ('\u00E9', 'e'), ('\u00C4', 'A'), ('\u00F1', 'n'), ('\u010D', 'c'), ('\u00E7', 'c'), ('\u0151', 'o') })
        {
            var (with, plain) = (StrokeFont.Strokes(composed.ToString(), 12), StrokeFont.Strokes(letter.ToString(), 12));
            Assert.That(with.Take(plain.Count), Is.EqualTo(plain), composed.ToString());
            Assert.That(with.Count, Is.GreaterThan(plain.Count));
            Assert.That(StrokeFont.Advance(composed.ToString(), 12), Is.EqualTo(StrokeFont.Advance(letter.ToString(), 12)));
        }
        // The accent takes the place of the dot.
        Assert.That(StrokeFont.Strokes("\u00ED", 12), Has.Count.EqualTo(2));
        Assert.That(StrokeFont.Strokes("\u00C9", 12).Last().Min(p => p.Y), Is.GreaterThan(12));
        Assert.That(StrokeFont.Strokes("\u00E7", 12).Last().Max(p => p.Y), Is.Zero);
    }

    [Test]
    public void Unknown_characters_are_boxes_and_reported()
    {
        Assert.That(StrokeFont.Has('\u4E16'), Is.False);
        var read = Read("<text y=\"50\">\u4E16</text>");
        Assert.That(read.Diagnostics.Single().Code, Is.EqualTo("curves.svg_letters"));
        Assert.That(read.Value, Has.Count.EqualTo(1));
        Assert.That(() => StrokeFont.Strokes("a", 0), Throws.TypeOf<ArgumentOutOfRangeException>());
    }
}
