namespace Caterpillar.Curved;

/// <summary>How steep the layers of a part are: along two axes at right angles, at positions along each of them, and at levels of the field.</summary>
internal sealed class SlopeSamples(int nodes, int levels)
{
    // Columns that are looked at on each level.
    private const int Columns = 3000;

    private readonly List<(double U, double V, double ByU, double ByV)>[] _levels
        = Array.ConvertAll(new int[levels], _ => new List<(double U, double V, double ByU, double ByV)>());

    private Vec3 _min;
    private Vec3 _max;

    /// <summary>Direction of the first axis.</summary>
    public double Cos { get; private set; } = 1;

    public double Sin { get; private set; }

    /// <summary>The lowest level, and the distance of levels.</summary>
    public double Low { get; private set; }

    public double Step { get; private set; }

    /// <summary>The largest growth of lengths that was found.</summary>
    public double Most { get; private set; } = 1;

    /// <summary>Samples of a part, or null if it has nothing to measure.</summary>
    public static SlopeSamples? Of(LayerField field, PartColumns part, int nodes, int levels)
    {
        var every = Math.Max(1, part.Columns.Count / Columns);
        var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
        var spans = new List<(Column Column, double From, double To)>();
        for (var i = 0; i < part.Columns.Count; i += every)
        {
            var column = part.Columns[i];
            double from = field.Value(new Vec3(column.X, column.Y, column.Low)), to = field.Value(new Vec3(column.X, column.Y, column.High));
            if (double.IsNaN(to - from)) continue;
            (low, high) = (Math.Min(low, from), Math.Max(high, to));
            spans.Add((column, from, to));
        }
        if (!(high > low)) return null;
        var result = new SlopeSamples(nodes, levels) { Low = low, Step = (high - low) / (levels - 1) };
        foreach (var (column, from, to) in spans)
        {
            for (var k = 0; k < levels; k++)
            {
                var value = low + k * result.Step;
                if (value < from - result.Step || value > to + result.Step) continue;
                var normal = field.Normal(new Vec3(column.X, column.Y, field.Height(column.X, column.Y, value)));
                if (normal.IsFinite && normal.Z > 0.05) result._levels[k].Add((column.X, column.Y, -normal.X / normal.Z, -normal.Y / normal.Z));
            }
        }
        result.Turn();
        return result;
    }

    /// <summary>The stretch along both axes on a level.</summary>
    public (AxisStretch U, AxisStretch V) Axes(int level) => (Axis(Nearest(level), true), Axis(Nearest(level), false));

    private List<(double U, double V, double ByU, double ByV)> Nearest(int level)
    {
        for (var off = 0; off < _levels.Length; off++)
        {
            if (level - off >= 0 && _levels[level - off].Count > 0) return _levels[level - off];
            if (level + off < _levels.Length && _levels[level + off].Count > 0) return _levels[level + off];
        }
        return [];
    }

    // The main direction of the slopes becomes the first axis.
    private void Turn()
    {
        double xx = 0, xy = 0, yy = 0;
        foreach (var level in _levels)
        {
            foreach (var s in level) (xx, xy, yy) = (xx + s.ByU * s.ByU, xy + s.ByU * s.ByV, yy + s.ByV * s.ByV);
        }
        if (Math.Abs(xx - yy) + Math.Abs(xy) > 0.05 * (xx + yy)) (Sin, Cos) = Angle.SinCos(Angle.Atan2(2 * xy, xx - yy) / 2);
        (_min, _max) = (new Vec3(double.PositiveInfinity, double.PositiveInfinity), new Vec3(double.NegativeInfinity, double.NegativeInfinity));
        foreach (var level in _levels)
        {
            for (var i = 0; i < level.Count; i++)
            {
                var s = level[i];
                level[i] = (s.U * Cos + s.V * Sin, s.V * Cos - s.U * Sin, s.ByU * Cos + s.ByV * Sin, s.ByV * Cos - s.ByU * Sin);
                _min = new Vec3(Math.Min(_min.X, level[i].U), Math.Min(_min.Y, level[i].V));
                _max = new Vec3(Math.Max(_max.X, level[i].U), Math.Max(_max.Y, level[i].V));
                Most = Math.Max(Most, Math.Sqrt(1 + level[i].ByU * level[i].ByU + level[i].ByV * level[i].ByV));
            }
        }
    }

    private AxisStretch Axis(List<(double U, double V, double ByU, double ByV)> samples, bool first)
    {
        double from = first ? _min.X : _min.Y, to = first ? _max.X : _max.Y, step = Math.Max((to - from) / (nodes - 1), 1e-6);
        var sums = new double[nodes];
        var counts = new double[nodes];
        foreach (var s in samples)
        {
            // Shared by the nodes on both sides.
            var t = ((first ? s.U : s.V) - from) / step;
            var i = (int)Math.Min(Math.Max(t, 0), nodes - 2);
            var share = Math.Min(1, Math.Max(0, t - i));
            var square = first ? s.ByU * s.ByU : s.ByV * s.ByV;
            sums[i] += (1 - share) * square;
            counts[i] += 1 - share;
            sums[i + 1] += share * square;
            counts[i + 1] += share;
        }
        var stretch = new double[nodes];
        for (var i = 0; i < nodes; i++) stretch[i] = Math.Sqrt(1 + Around(sums, counts, i));
        return new AxisStretch(from, step, stretch, (from + to) / 2);
    }

    // The mean at a node; where there are no samples, of those nearest to it.
    private static double Around(double[] sums, double[] counts, int node)
    {
        for (var off = 0; off < sums.Length; off++)
        {
            double sum = 0, count = 0;
            foreach (var i in off == 0 ? [node] : new[] { node - off, node + off })
            {
                if (i >= 0 && i < sums.Length) (sum, count) = (sum + sums[i], count + counts[i]);
            }
            if (count > 0.5) return sum / count;
        }
        return 0;
    }
}
