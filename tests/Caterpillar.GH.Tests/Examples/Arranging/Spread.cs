using System.Collections.Generic;

namespace Caterpillar.GH.Tests.Examples.Arranging;

/// <summary>Keeps things apart on a line, in their order, as near to where they want to be as least squares allow.</summary>
internal static class Spread
{
    public static double[] Out(IReadOnlyList<double> wanted, IReadOnlyList<double> sizes, IReadOnlyList<double> before)
    {
        var offsets = new double[wanted.Count];
        for (var i = 1; i < offsets.Length; i++) offsets[i] = offsets[i - 1] + sizes[i - 1] + before[i];
        var pools = new List<(double Mean, int Count)>();
        for (var i = 0; i < offsets.Length; i++)
        {
            var pool = (Mean: wanted[i] - offsets[i], Count: 1);
            while (pools.Count > 0 && pools[pools.Count - 1].Mean > pool.Mean)
            {
                var (mean, count) = pools[pools.Count - 1];
                pools.RemoveAt(pools.Count - 1);
                pool = ((mean * count + pool.Mean * pool.Count) / (count + pool.Count), count + pool.Count);
            }
            pools.Add(pool);
        }
        var tops = new double[offsets.Length];
        var at = 0;
        foreach (var (mean, count) in pools)
        {
            for (var i = 0; i < count; i++, at++) tops[at] = mean + offsets[at];
        }
        return tops;
    }
}
