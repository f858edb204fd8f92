namespace Caterpillar.Toolpaths;

/// <summary>A set of the moves of a toolpath, a bit for each.</summary>
/// <param name="count">Number of moves.</param>
internal sealed class MoveSet(int count)
{
    private readonly ulong[] _words = new ulong[(count >> 6) + 1];

    /// <summary>Whether a move is in the set.</summary>
    public bool this[int move]
    {
        get => (_words[move >> 6] >> move & 1) != 0;
        set
        {
            if (value) _words[move >> 6] |= 1UL << move;
            else _words[move >> 6] &= ~(1UL << move);
        }
    }

    /// <summary>The first move of a range that is in the set, or that is not. The end of the range if there is none.</summary>
    public int Find(bool value, int from, int end)
    {
        while (from < end)
        {
            var word = (value ? _words[from >> 6] : ~_words[from >> 6]) >> from;
            if ((word & 1) != 0) return from;
            from = word == 0 ? (from | 63) + 1 : from + 1;
        }
        return end;
    }
}
