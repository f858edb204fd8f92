using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Slicing;

/// <summary>Shapes with thin places.</summary>
internal static class WallShapes
{
    public static Region Frame(double thickness, double size = 20)
        => Region.Rectangle(-size / 2, -size / 2, size / 2, size / 2)
            .Subtract(Region.Rectangle(-size / 2 + thickness, -size / 2 + thickness, size / 2 - thickness, size / 2 - thickness));

    public static Region Wedge(double from, double to, double length)
        => Region.From(new Polyline([new Vec3(0, -from / 2), new Vec3(length, -to / 2), new Vec3(length, to / 2), new Vec3(0, from / 2)], closed: true));

    public static Region Star(int tips, double outer, double inner)
        => Region.From(new Polyline(Enumerable.Range(0, 2 * tips).Select(i => Polar(i % 2 == 0 ? outer : inner, 180.0 * i / tips)), closed: true));

    public static Region Ring(double radius, double thickness) => Disc(radius).Subtract(Disc(radius - thickness));

    public static Region Disc(double radius) => Region.From(new Polyline(Enumerable.Range(0, 120).Select(i => Polar(radius, 3 * i)), closed: true));

    /// <summary>Letters 4 mm high with strokes of 0.6 mm.</summary>
    public static IEnumerable<(char Letter, Region Region)> Letters()
    {
        var strokes = new Dictionary<char, string>
        {
            ['I'] = "0,0 0,4", ['L'] = "0,4 0,0 2,0",
            ['T'] = "-1.2,4 1.2,4|0,0 0,4", ['E'] = "2,4 0,4 0,0 2,0|0,2 1.6,2", ['H'] = "0,0 0,4|2,0 2,4|0,2 2,2",
            ['X'] = "0,0 2.2,4|0,4 2.2,0", ['V'] = "0,4 1.2,0 2.4,4", ['N'] = "0,0 0,4 2,0 2,4",
            ['O'] = "0.6,0 1.6,0 2.2,0.6 2.2,3.4 1.6,4 0.6,4 0,3.4 0,0.6 0.6,0",
            ['P'] = "0,0 0,4 1.4,4 2,3.5 2,2.5 1.4,2 0,2", ['S'] = "2,3.4 1.5,4 0.5,4 0,3.4 0,2.6 0.5,2 1.5,2 2,1.4 2,0.6 1.5,0 0.5,0 0,0.6",
            ['A'] = "0,0 1.2,4 2.4,0|0.7,1.4 1.7,1.4", ['K'] = "0,0 0,4|2,4 0,1.8|0.6,2.5 2,0",
            ['B'] = "0,0 0,4 1.3,4 1.9,3.5 1.9,2.5 1.3,2 0,2|1.3,2 2,1.5 2,0.5 1.3,0 0,0",
        };
        foreach (var pair in strokes.OrderBy(p => p.Key)) yield return (pair.Key, Strokes(pair.Value, 0.6));
    }

    public static Region Strokes(string text, double width)
    {
        var region = Region.Empty;
        foreach (var stroke in text.Split('|'))
        {
            // Lines inset by half a width, so that the letter has the height of its strokes.
            var points = stroke.Split(' ').Select(p => p.Split(',')).Select(p => new Vec3(Number(p[0]), Number(p[1]))).ToArray();
            region = region.Union(RegionTools.Around([new Polyline(points)], width / 2, JoinStyle.Miter));
        }
        return region;
    }

    private static double Number(string text) => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture);

    private static Vec3 Polar(double radius, double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return new Vec3(radius * cos, radius * sin);
    }
}
