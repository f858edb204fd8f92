using System;
using System.Collections.Generic;
using System.Text;
using Caterpillar.Basics;

namespace Caterpillar.Examples;

/// <summary>The generated curve files in examples/curves, after the printed examples of Caterpillar (Zheng et al. 2019, section 6).</summary>
internal static class ExampleCurves
{
    /// <summary>File names and generators.</summary>
    public static IReadOnlyList<(string Name, Func<byte[]> Make)> All { get; } =
    [
        ("pimples.json", () => Encoding.ASCII.GetBytes(Pimples())),
        ("thick_cup.csv", () => Encoding.ASCII.GetBytes(ThickCup())),
    ];

    // Rings with small circles on the outside. The path goes around each circle once, which makes bumps in the wall.
    private static string Pimples()
    {
        const int Layers = 60, PathSamples = 12;
        const double Radius = 20, Small = 0.9;
        var text = new StringBuilder("{\n  \"units\": \"mm\",\n  \"curves\": [\n");
        for (var layer = 0; layer < Layers; layer++)
        {
            var z = 0.2 * (layer + 1);
            // Three layers with pimples, three without. Every other row is turned by half a pimple.
            var row = layer / 6;
            var pimpled = layer % 6 >= 3;
            var turn = row % 2 == 0 ? 0 : 180.0 / PathSamples;
            text.Append("    {\"name\": \"ring ").Append(NumberFormatter.Format(layer)).Append("\", \"layer\": ").Append(NumberFormatter.Format(layer))
                .Append(", ");
            if (!pimpled)
            {
                text.Append(Arc(0, 0, z, Radius, turn, 360)).Append(layer + 1 < Layers ? "},\n" : "}\n");
                continue;
            }
            text.Append("\"pieces\": [\n");
            for (var i = 0; i < PathSamples; i++)
            {
                var at = turn + 360.0 * i / PathSamples;
                var (sin, cos) = Angle.SinCos(at);
                text.Append("      {").Append(Arc((Radius + Small) * cos, (Radius + Small) * sin, z, Small, at + 180, -360)).Append("}, {");
                text.Append(Arc(0, 0, z, Radius, at, 360.0 / PathSamples)).Append(i + 1 < PathSamples ? "},\n" : "}\n");
            }
            text.Append("    ]}").Append(layer + 1 < Layers ? ",\n" : "\n");
        }
        return text.Append("  ]\n}\n").ToString();
    }

    private static string Arc(double x, double y, double z, double radius, double start, double sweep)
        => $"\"center\": [{Exact(x)}, {Exact(y)}, {Text(z)}], \"radius\": {Text(radius)}, \"start\": {Text(start)}, \"sweep\": {Text(sweep)}";

    // A spiral of a thick extrusion with large layer height and flow. The first turn grows with the gap below it.
    private static string ThickCup()
    {
        const int Around = 60, Turns = 40;
        const double Height = 1.2;
        var text = new StringBuilder("# A cup of one thick extrusion for a large nozzle: a spiral that widens upward.\nx,y,z,width,height,flow,speed\n");
        for (var i = 0; i <= Around * Turns; i++)
        {
            var turns = (double)i / Around;
            var (sin, cos) = Angle.SinCos(360.0 * (i % Around) / Around);
            var radius = 22 + 9 * Math.Sqrt(turns / Turns) + 0.8 * Angle.Sin(360.0 * 6 * i / Around / 1.02);
            var gap = Math.Min(Height, 0.4 + (Height - 0.4) * turns);
            text.Append(Text(radius * cos)).Append(',').Append(Text(radius * sin)).Append(',').Append(Text(0.4 + Height * turns)).Append(",2.4,")
                .Append(Text(gap)).Append(",1.3,2.5\n");
        }
        return text.ToString();
    }

    // Exact enough that the ends of pieces coincide.
    private static string Exact(double value) => NumberFormatter.Format(value, 9);

    private static string Text(double value) => NumberFormatter.Format(value, 4);
}
