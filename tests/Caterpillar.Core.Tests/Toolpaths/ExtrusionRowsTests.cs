using System;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>The cells that an extrusion covers, compared with distances.</summary>
public class ExtrusionRowsTests
{
    private const double Cell = 0.25;

    [TestCase(8, TestName = "{m}(longer than its ends)")]
    [TestCase(1, TestName = "{m}(short)")]
    [TestCase(0, TestName = "{m}(a disc)")]
    public void Cells_that_a_extrusion_touches_are_covered_and_none_farther_away(double longest)
    {
        var random = new Random(1);
        var rows = new ExtrusionRows(Cell);
        for (var round = 0; round < 300; round++)
        {
            double Somewhere(double size) => (random.NextDouble() - 0.5) * 2 * size;
            double dx = Somewhere(longest), dy = Somewhere(longest), x = Somewhere(5), y = Somewhere(5);
            // Some run straight along the cells.
            if (round % 7 == 1) dx = 0;
            if (round % 7 == 2) dy = 0;
            var extrusion = new Extrusion { Ax = x, Ay = y, Bx = x + dx, By = y + dy, Half = 0.05 + random.NextDouble() * 0.6 };
            rows.Aim(extrusion);
            for (var row = (int)Math.Floor(Math.Min(y, extrusion.By) / Cell) - 6; row <= Math.Max(y, extrusion.By) / Cell + 6; row++)
            {
                int first = 0, last = -1;
                if (row >= rows.First && row <= rows.Last) rows.Span(row, out first, out last);
                for (var column = (int)Math.Floor(Math.Min(x, extrusion.Bx) / Cell) - 6; column <= Math.Max(x, extrusion.Bx) / Cell + 6; column++)
                {
                    var isCovered = column >= first && column <= last;
                    if (!isCovered && IsTouched(extrusion, column, row)) Assert.Fail($"round {round}: {column}, {row} is touched");
                    if (isCovered && !(DistanceOf(extrusion, column + 0.5, row + 0.5) <= extrusion.Half + Cell * 0.7072 + 1e-9))
                        Assert.Fail($"round {round}: {column}, {row} is too far away");
                }
            }
        }
    }

    [Test]
    public void Long_extrusions_cover_the_same_in_all_rows_between_their_ends()
    {
        var rows = new ExtrusionRows(Cell);
        // 45°: each row is one cell farther to the right than the one below.
        rows.Aim(new Extrusion { Ax = -3.1, Ay = -7.2, Bx = 16.9, By = 12.8, Half = 0.2 });
        rows.Span(-20, out var first, out var last);
        Assert.That(last - first, Is.InRange(2, 4));
        for (var row = -25; row < 48; row++)
        {
            rows.Span(row, out var left, out var right);
            Assert.That((left, right), Is.EqualTo((first + row + 20, last + row + 20)));
        }
    }

    private static bool IsTouched(in Extrusion extrusion, int column, int row)
    {
        for (var i = 0; i < 16; i++)
        {
            if (DistanceOf(extrusion, column + i % 4 / 3.0, row + i / 4 % 4 / 3.0) < extrusion.Half - 1e-9) return true;
        }
        return false;
    }

    private static double DistanceOf(in Extrusion extrusion, double column, double row)
        => Math.Sqrt(FlatSegment.SquareDistance(new Vec3(column * Cell, row * Cell), new Vec3(extrusion.Ax, extrusion.Ay),
            new Vec3(extrusion.Bx, extrusion.By)));
}
