namespace Caterpillar.Basics;

/// <summary>Binary search by a condition.</summary>
internal static class Search
{
    /// <summary>
    /// The first number from which on a condition holds, at least <paramref name="from"/> and at most <paramref name="to"/>. The condition gets a state,
    /// so that it needs no allocation.
    /// </summary>
    public static int First<T>(int from, int to, T state, Func<T, int, bool> holds)
    {
        while (from < to)
        {
            var middle = from + (to - from) / 2;
            if (holds(state, middle)) to = middle;
            else from = middle + 1;
        }
        return from;
    }
}
