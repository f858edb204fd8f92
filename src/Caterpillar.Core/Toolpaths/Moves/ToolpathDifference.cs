namespace Caterpillar.Toolpaths;

/// <summary>Counts the moves that an edit changed.</summary>
/// <param name="Shifted">Moves that end elsewhere.</param>
/// <param name="Speeds">Moves with another speed.</param>
/// <param name="Amounts">Moves that deposit another amount.</param>
/// <param name="Before">Number of all moves before. If it changed, no others are counted.</param>
/// <param name="After">Number of all moves afterwards.</param>
internal sealed record ToolpathDifference(int Shifted, int Speeds, int Amounts, int Before, int After)
{
    /// <summary>The changes in two parts.</summary>
    public static ToolpathDifference operator +(ToolpathDifference a, ToolpathDifference b)
        => new(a.Shifted + b.Shifted, a.Speeds + b.Speeds, a.Amounts + b.Amounts, a.Before + b.Before, a.After + b.After);

    public static ToolpathDifference Of(Toolpath before, Toolpath after)
    {
        if (before.Count != after.Count) return new ToolpathDifference(0, 0, 0, before.Count, after.Count);
        int shifted = 0, speeds = 0, amounts = 0;
        int block = 0, other = 0, i = 0, k = 0;
        while (block < before.Blocks.Count)
        {
            var (c, d) = (before.Blocks[block].Columns, after.Blocks[other].Columns);
            var run = Math.Min(c.Count - i, d.Count - k);
            var same = ReferenceEquals(c, d) && i == k;
            for (var end = i + run; i < end && !same; i++, k++)
            {
                var shift = new Vec3(c.X[i] - d.X[k], c.Y[i] - d.Y[k], c.Z[i] - d.Z[k]);
                if (Vec3.Dot(shift, shift) > 1e-18) shifted++;
                if (Math.Abs(c.Speed[i] - d.Speed[k]) > 1e-9) speeds++;
                if (Math.Abs(c.Deposited[i] - d.Deposited[k]) > 1e-12) amounts++;
            }
            if (same) (i, k) = (i + run, k + run);
            if (i == c.Count) (block, i) = (block + 1, 0);
            if (k == d.Count) (other, k) = (other + 1, 0);
        }
        return new ToolpathDifference(shifted, speeds, amounts, before.Count, after.Count);
    }
}
