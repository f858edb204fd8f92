using System;
using System.Globalization;
using System.IO;
using System.Text;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Display;

/// <summary>Small images compared point by point; the golden files are portable pixmaps.</summary>
public class GoldenImageTests
{
    // Two layers with an arc, a travel between them, a purged line, and an extrusion that rises.
    private const string Print = """
        ;FLAVOR:Marlin
        M82
        G90
        G1 Z0.4 F600
        ;TYPE:Custom
        G1 X0 Y-4 F6000
        G1 X20 E2 F900
        ;LAYER_CHANGE
        ;TYPE:External perimeter
        G1 X0 Y0 F6000
        G1 X20 E3.2 F1200
        G3 X20 Y12 I0 J6 E5.1 F2400
        G1 X0 E6.3
        ;TYPE:Internal infill
        G1 Y0 E7 F600
        ;LAYER_CHANGE
        G1 Z2 F600
        ;TYPE:Bridge infill
        G1 X4 Y3 F6000
        G1 X16 Y9 E8.2 F1800
        ;LAYER_CHANGE
        G1 Z4
        ;TYPE:Top solid infill
        G1 X16 Y3 F6000
        G1 X4 Y9 Z7 E9.4 F3000
        """;

    private const string Pen = """
        G21
        G90
        G0 X0 Y0 Z5
        G0 Z0
        G0 X20
        G0 X20 Y10
        G0 Z5
        G0 X5 Y5
        G0 Z0
        G0 X15
        G0 Z5
        """;

    [TestCase(ColorBy.Role)]
    [TestCase(ColorBy.Height)]
    [TestCase(ColorBy.Speed)]
    [TestCase(ColorBy.Layer)]
    [TestCase(ColorBy.Progress)]
    public void Colors_show_what_is_asked_for(ColorBy by) => Check(Print, "color_" + by, Small with { ColorBy = by });

    [Test]
    public void From_above_with_travel() => Check(Print, "top", Small with { View = View.Top, Travel = true });

    [Test]
    public void From_the_front() => Check(Print, "front", Small with { View = View.Front });

    [Test]
    public void From_the_left_and_above() => Check(Print, "left", Small with { View = new View(200, 40) });

    [Test]
    public void Strokes_of_a_pen() => Check(Pen, "pen", Small with { View = View.Top, Strokes = true });

    private static ToolpathImageOptions Small { get; } = new() { Width = 64, Height = 48 };

    private static void Check(string gcode, string name, ToolpathImageOptions options)
    {
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(gcode)).Value!.Toolpath;
        Golden.Check("Images/" + name.ToLower(CultureInfo.InvariantCulture) + ".ppm", Pixmap(ToolpathImage.Draw(toolpath, options)));
    }

    private static byte[] Pixmap(RasterImage image)
    {
        using var bytes = new MemoryStream();
        var head = Encoding.ASCII.GetBytes(FormattableString.Invariant($"P6\n{image.Width} {image.Height}\n255\n"));
        bytes.Write(head, 0, head.Length);
        for (var y = 0; y < image.Height; y++)
        {
            for (var x = 0; x < image.Width; x++)
            {
                var color = image[x, y];
                bytes.WriteByte(color.R);
                bytes.WriteByte(color.G);
                bytes.WriteByte(color.B);
            }
        }
        return bytes.ToArray();
    }
}
