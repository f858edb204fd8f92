namespace Caterpillar.GCode;

/// <summary>One line as the fast path leaves it.</summary>
internal struct LineRecord
{
    public double X;
    public double Y;
    public double Z;
    public double E;
    public double F;

    /// <summary>Where the line begins in the text.</summary>
    public int Start;

    /// <summary>Of a motion: where its comment begins, or −1. Of other lines: where the line ends (without its line end).</summary>
    public int Aux;

    /// <summary>Number of the line in its chunk, from 0.</summary>
    public int Line;

    /// <summary>0 and 1 for G0 and G1 in the usual notation; <see cref="ChunkParser.Comment"/>; <see cref="ChunkParser.Other"/>.</summary>
    public byte Op;

    /// <summary>Words that are there: 1 X, 2 Y, 4 Z, 8 E, 16 F.</summary>
    public byte Mask;
}

/// <summary>Where the numbers of a motion are in its line; slots are the bits of <see cref="LineRecord.Mask"/>.</summary>
internal struct WordPlaces
{
    // A byte for each slot: where its number begins and ends, counted from the beginning of the line.
    public ulong Starts;
    public ulong Ends;

    /// <summary>Four bits for each slot.</summary>
    public uint Decimals;

    /// <summary>The slots in the order of their words, three bits for each.</summary>
    public uint Order;

    /// <summary>Number of words; 0 where they are not known: other lines, words that are there twice, very long lines.</summary>
    public int Count;

    public readonly int StartOf(int slot) => (int)(Starts >> (8 * slot)) & 255;

    public readonly int EndOf(int slot) => (int)(Ends >> (8 * slot)) & 255;

    public readonly int DecimalsOf(int slot) => (int)(Decimals >> (4 * slot)) & 15;

    public readonly int SlotAt(int word) => (int)(Order >> (3 * word)) & 7;

    public void Add(int slot, int start, int end, int decimals)
    {
        Starts |= (ulong)start << (8 * slot);
        Ends |= (ulong)end << (8 * slot);
        Decimals |= (uint)decimals << (4 * slot);
        Order |= (uint)slot << (3 * Count);
        Count++;
    }
}
