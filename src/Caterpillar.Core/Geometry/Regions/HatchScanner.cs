using System;
using System.Collections.Generic;
using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>Crossings of parallel lines with contours: edges are put into the rows they cross by a counting sort; each row is sorted and paired.</summary>
internal static class HatchScanner
{
    private const double MaxRows = 10_000_000;

    // Distances across the hatch are rounded to 1e-7 mm, so that both ends of an edge along a row fall on the same side.
    private const double PerStep = 1e7;

    public static HatchLine[] Scan(GridPoint[][] paths, double angle, double spacing, double phase)
    {
        if (double.IsNaN(angle) || double.IsInfinity(angle)) throw new ArgumentException("The angle must be a number.", nameof(angle));
        if (!(spacing > 0) || double.IsInfinity(spacing)) throw new ArgumentException("The spacing must be positive.", nameof(spacing));
        if (double.IsNaN(phase) || double.IsInfinity(phase)) throw new ArgumentException("The phase must be a number.", nameof(phase));
        var count = 0;
        foreach (var path in paths) count += path.Length;
        if (count == 0) return Array.Empty<HatchLine>();
        var (sin, cos) = Angle.SinCos(angle);
        var along = new double[count];
        var across = new double[count];
        var row = new int[count];
        var (low, high) = Project(paths, sin, cos, spacing, phase, along, across, row);
        if (high <= low) return Array.Empty<HatchLine>();
        var start = new int[high - low + 1];
        Walk(paths, row, (a, b, k) => start[k - low + 1]++);
        for (var k = 1; k < start.Length; k++) start[k] += start[k - 1];
        var crossings = new double[start[start.Length - 1]];
        var fill = new int[high - low];
        Array.Copy(start, fill, fill.Length);
        Walk(paths, row, (a, b, k) =>
        {
            // From the lower end, so that an edge gives the same bits in both directions.
            if (across[b] < across[a]) (a, b) = (b, a);
            var t = (phase + k * spacing - across[a]) / (across[b] - across[a]);
            crossings[fill[k - low]++] = along[a] + Math.Min(Math.Max(t, 0), 1) * (along[b] - along[a]);
        });
        return Pair(crossings, start, low, sin, cos, spacing, phase);
    }

    private static (int Low, int High) Project(
        GridPoint[][] paths, double sin, double cos, double spacing, double phase, double[] along, double[] across, int[] row)
    {
        int low = int.MaxValue, high = int.MinValue;
        var n = 0;
        foreach (var path in paths)
        {
            foreach (var p in path)
            {
                double x = p.X / Grid.PerMm, y = p.Y / Grid.PerMm;
                along[n] = x * cos + y * sin;
                across[n] = Math.Floor((y * cos - x * sin) * PerStep + 0.5) / PerStep;
                var k = Math.Ceiling((across[n] - phase) / spacing);
                if (!(Math.Abs(k) < MaxRows)) throw new ArgumentException("More than 10 million rows.", nameof(spacing));
                row[n] = (int)k;
                low = Math.Min(low, row[n]);
                high = Math.Max(high, row[n]);
                n++;
            }
        }
        return (low, high);
    }

    // Row k crosses an edge when one end lies below the row and the other on or above it.
    private static void Walk(GridPoint[][] paths, int[] row, Action<int, int, int> visit)
    {
        var first = 0;
        foreach (var path in paths)
        {
            var a = first + path.Length - 1;
            for (var b = first; b < first + path.Length; a = b++)
            {
                int from = Math.Min(row[a], row[b]), to = Math.Max(row[a], row[b]);
                for (var k = from; k < to; k++) visit(a, b, k);
            }
            first += path.Length;
        }
    }

    private static HatchLine[] Pair(double[] crossings, int[] start, int low, double sin, double cos, double spacing, double phase)
    {
        var lines = new List<HatchLine>(crossings.Length / 2);
        for (var r = 0; r + 1 < start.Length; r++)
        {
            Array.Sort(crossings, start[r], start[r + 1] - start[r]);
            var v = phase + (low + r) * spacing;
            for (var i = start[r]; i + 1 < start[r + 1]; i += 2)
            {
                double from = crossings[i], to = crossings[i + 1];
                if (to <= from) continue;
                lines.Add(new HatchLine(low + r, new Vec3(from * cos - v * sin, from * sin + v * cos), new Vec3(to * cos - v * sin, to * sin + v * cos)));
            }
        }
        return lines.ToArray();
    }
}
