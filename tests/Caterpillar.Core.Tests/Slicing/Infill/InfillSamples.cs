using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Expressions;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry;

namespace Caterpillar.Tests.Slicing.Infill;

/// <summary>Areas to fill, and what is asked of their fillings.</summary>
internal static class InfillSamples
{
    public const double Width = 0.45;

    /// <summary>All patterns that need no lines from outside.</summary>
    public static readonly InfillPattern[] Patterns =
    [
        InfillPattern.Lines, InfillPattern.Monotonic, InfillPattern.Grid, InfillPattern.Triangles, InfillPattern.Cubic, InfillPattern.Gyroid,
        InfillPattern.Honeycomb, InfillPattern.Concentric, InfillPattern.Hilbert, InfillPattern.Formula,
    ];

    /// <summary>Circles of 3 spacings' distance.</summary>
    public static Formula Waves { get; } = Compile("sin(120 * sqrt(x^2 + y^2) / spacing) + sin(z)");

    public static Formula Compile(string text) => Formula.Compile(text, LevelSet.Variables).Value!;

    public static IReadOnlyList<InfillLine> Fill(InfillRequest request) => new InfillFiller(new RegionEngine()).Fill(request);

    public static InfillRequest Request(Region area, InfillPattern pattern, double spacing, int layer = 0, bool linked = true)
        => new(area, pattern, spacing, Width)
    {
        Angle = pattern is InfillPattern.Lines or InfillPattern.Monotonic ? 45 + 90 * layer : 10,
        Z = 0.2 * (layer + 1),
        Layer = layer,
        Linked = linked,
        Formula = Waves,
    };

    public static double Length(IEnumerable<InfillLine> lines) => lines.Sum(line => new Polyline(line.Points, line.Closed).Length);

    /// <summary>A star with up to three holes.</summary>
    public static Region Random(int seed)
    {
        var random = new Random(seed);
        var area = Region.From(RegionReference.Star(random, random.Next(5, 40), 0, 0, 4 + 8 * random.NextDouble(), 15));
        for (var i = random.Next(4); i > 0; i--)
        {
            double x = random.NextDouble() * 16 - 8, y = random.NextDouble() * 16 - 8;
            area = area.Subtract(Region.From(RegionReference.Star(random, random.Next(3, 20), x, y, 0.5, 4)));
        }
        return area;
    }

    /// <summary>A square with a side of 20 mm and a hole of 6 mm in it.</summary>
    public static Region Holed { get; } = Region.Rectangle(0, 0, 20, 20).Subtract(Region.Rectangle(7, 7, 13, 13));
}
