namespace Caterpillar.GCode;

/// <summary>One line after the fast path.</summary>
internal struct LineRecord
{
    public double X;
    public double Y;
    public double Z;
    public double E;
    public double F;

    /// <summary>Index of the line in the text.</summary>
    public int Start;

    /// <summary>Motions: index of the comment, or −1. Other lines: index of the line end.</summary>
    public int Aux;

    /// <summary>0 and 1 for G0 and G1 in the usual notation; <see cref="ChunkParser.Comment"/>; <see cref="ChunkParser.Other"/>.</summary>
    public byte Op;

    /// <summary>Bits of its words: 1 X, 2 Y, 4 Z, 8 E, 16 F.</summary>
    public byte Mask;
}

/// <summary>Places of the numbers of a motion in its line. Slots are the bits of <see cref="LineRecord.Mask"/>.</summary>
internal struct WordPlaces
{
    // A byte for each slot: where its number begins and ends, counted from the beginning of the line.
    public ulong Starts;
    public ulong Ends;

    /// <summary>Four bits for each slot.</summary>
    public uint Decimals;

    /// <summary>The slots in the order of their words, three bits for each.</summary>
    public uint Order;

    /// <summary>Number of words. 0 = unknown: other lines, repeated words, very long lines.</summary>
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
