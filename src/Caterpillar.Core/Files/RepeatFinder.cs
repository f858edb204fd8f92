namespace Caterpillar.Files;

/// <summary>Finds repeats of earlier bytes, for compression (LZ77): among the nearest positions with the same three bytes, the first of the longest.</summary>
internal static class RepeatFinder
{
    private const int Shortest = 3;
    private const int HashBits = 14;

    /// <summary>The data in pieces: single bytes with length 1, and repeats of three bytes and more with their distance back.</summary>
    /// <param name="data">The bytes.</param>
    /// <param name="farthest">Maximum distance.</param>
    /// <param name="longest">Maximum length.</param>
    /// <param name="tries">Maximum number of positions to compare.</param>
    public static IEnumerable<(int At, int Length, int Back)> Pieces(byte[] data, int farthest, int longest, int tries)
    {
        // The last position of each hash, and before each position the one with the same hash.
        var last = Enumerable.Repeat(-1, 1 << HashBits).ToArray();
        var before = new int[data.Length];
        for (var at = 0; at < data.Length;)
        {
            var (length, back) = (1, 0);
            if (at + Shortest <= data.Length)
            {
                var most = Math.Min(longest, data.Length - at);
                var left = tries;
                for (var from = last[Hash(data, at)]; from >= 0 && at - from <= farthest && left-- > 0 && length < most; from = before[from])
                {
                    var same = 0;
                    while (same < most && data[from + same] == data[at + same]) same++;
                    if (same >= Shortest && same > length) (length, back) = (same, at - from);
                }
            }
            yield return (at, length, back);
            for (var end = at + length; at < end; at++)
            {
                if (at + Shortest > data.Length) continue;
                var hash = Hash(data, at);
                before[at] = last[hash];
                last[hash] = at;
            }
        }
    }

    private static int Hash(byte[] data, int at)
        => (int)((uint)(data[at] | data[at + 1] << 8 | data[at + 2] << 16) * 2654435761u >> 32 - HashBits);
}
