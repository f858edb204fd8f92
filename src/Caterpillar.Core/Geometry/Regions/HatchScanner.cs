namespace Caterpillar.Geometry;

/// <summary>Crossings of parallel lines with contours: edges are assigned to the rows they cross by a counting sort; each row is sorted and paired.</summary>
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
        var count = paths.Sum(path => path.Length);
        if (count == 0) return Array.Empty<HatchLine>();
        var (sin, cos) = Angle.SinCos(angle);
        var along = new double[count];
        var across = new double[count];
        var row = new int[count];
        var (low, high) = Project(paths, sin, cos, spacing, phase, along, across, row);
        if (high <= low) return Array.Empty<HatchLine>();
        var start = new int[high - low + 1];
        var first = 0;
        foreach (var path in paths)
        {
            for (int b = first, a = first + path.Length - 1; b < first + path.Length; a = b++) Count(start, row[a] - low, row[b] - low);
            first += path.Length;
        }
        for (var k = 1; k < start.Length; k++) start[k] += start[k - 1];
        var crossings = new double[start[start.Length - 1]];
        var fill = new int[high - low];
        Array.Copy(start, fill, fill.Length);
        first = 0;
        foreach (var path in paths)
        {
            for (int b = first, a = first + path.Length - 1; b < first + path.Length; a = b++)
            {
                if (row[a] == row[b]) continue;
                // From the lower end, so that an edge gives the same bits in both directions.
                var (from, to) = row[a] < row[b] ? (a, b) : (b, a);
                var slope = (along[to] - along[from]) / (across[to] - across[from]);
                double least = Math.Min(along[from], along[to]), most = Math.Max(along[from], along[to]);
                for (var k = row[from]; k < row[to]; k++)
                {
                    var u = along[from] + (phase + k * spacing - across[from]) * slope;
                    crossings[fill[k - low]++] = Math.Min(Math.Max(u, least), most);
                }
            }
            first += path.Length;
        }
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
                if (!(Math.Abs(k) < MaxRows)) throw new ArgumentException("The spacing would give more than 10 million rows.", nameof(spacing));
                row[n] = (int)k;
                low = Math.Min(low, row[n]);
                high = Math.Max(high, row[n]);
                n++;
            }
        }
        return (low, high);
    }

    // Row k crosses an edge when one end lies below the row and the other on or above it. Counts one place up, for the sums that follow.
    private static void Count(int[] start, int a, int b)
    {
        for (var k = Math.Min(a, b); k < Math.Max(a, b); k++) start[k + 1]++;
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
