namespace Caterpillar.Expressions;

/// <summary>
/// A random generator with a seed that gives the same numbers on every runtime and in every version (SplitMix64: Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014). Not thread-safe.
/// </summary>
/// <param name="seed">The same seed gives the same numbers everywhere.</param>
internal sealed class SeededRandom(int seed = 0)
{
    /// <summary>The step from one state to the next: 2⁶⁴ divided by the golden ratio.</summary>
    public const ulong Golden = 0x9E3779B97F4A7C15;

    private ulong _state = Mix(unchecked((ulong)seed * Golden + Golden));

    /// <summary>The seed.</summary>
    public int Seed { get; } = seed;

    /// <summary>The next number, at least 0 and below 1.</summary>
    public double NextDouble()
    {
        _state = unchecked(_state + Golden);
        return ToUnit(Mix(_state));
    }

    /// <summary>The next integer from <paramref name="low"/> to <paramref name="high"/>, both included.</summary>
    /// <exception cref="ArgumentOutOfRangeException">High is below low.</exception>
    public long NextInteger(long low, long high)
    {
        if (high < low) throw new ArgumentOutOfRangeException(nameof(high), "The upper limit is below the lower limit.");
        return low + (long)Math.Min(Math.Floor(NextDouble() * ((double)high - low + 1)), (double)high - low);
    }

    /// <summary>A number from 0 to below 1 that depends on the value alone: the same seed gives the same number anywhere.</summary>
    public static double Of(double seed) => ToUnit(Mix(unchecked((ulong)BitConverter.DoubleToInt64Bits(seed + 0.0) * Golden + Golden)));

    private static double ToUnit(ulong bits) => (bits >> 11) * (1.0 / 9007199254740992.0);

    /// <summary>Scrambles bits.</summary>
    public static ulong Mix(ulong z)
    {
        unchecked
        {
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
            return z ^ (z >> 31);
        }
    }
}
