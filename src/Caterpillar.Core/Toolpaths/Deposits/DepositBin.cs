using System;

namespace Caterpillar.Toolpaths;

/// <summary>A square of cells of a <see cref="Deposit"/>, with the strands that overlap it.</summary>
internal sealed class DepositBin
{
    public const int Bits = 3;
    public const int Side = 1 << Bits;
    public const int BlockBits = 4;
    public const int Block = 1 << BlockBits;
    private const int FirstCompaction = 32;

    public readonly DepositCell[] Cells = new DepositCell[Side * Side];

    /// <summary>Numbers of the strands, in the order in which they were added.</summary>
    public int[] Strands = new int[4];

    /// <summary>Their tops, beside each other: most strands lie lower than what is asked for.</summary>
    public double[] Tops = new double[4];

    /// <summary>The highest top of each block of <see cref="Block"/> strands: layers far below are skipped by blocks.</summary>
    public double[] BlockTops = new double[1];

    public int Count;

    /// <summary>Highest top in the bin.</summary>
    public double Top = double.NegativeInfinity;

    /// <summary>Highest top among strands that were dropped because the print is far above them; there only the cells answer.</summary>
    public double Dropped = double.NegativeInfinity;

    private int _compactAt = FirstCompaction;

    public DepositBin()
    {
        for (var i = 0; i < Cells.Length; i++) Cells[i].Top = Cells[i].Under = double.NegativeInfinity;
    }

    public void Add(int strand, StrandStore store, double keepDepth)
    {
        if (Count > 0 && Strands[Count - 1] == strand) return;
        if (Count == _compactAt) Compact(store, keepDepth);
        if (Count == Strands.Length)
        {
            Array.Resize(ref Strands, Count * 2);
            Array.Resize(ref Tops, Count * 2);
        }
        ref var added = ref store[strand];
        added.Users++;
        Put(Count++, strand, added.Top);
    }

    private void Compact(StrandStore store, double keepDepth)
    {
        var kept = 0;
        for (var i = 0; i < Count; i++)
        {
            if (Tops[i] >= Top - keepDepth)
            {
                Put(kept++, Strands[i], Tops[i]);
                continue;
            }
            Dropped = Math.Max(Dropped, Tops[i]);
            store.Release(Strands[i]);
        }
        Count = kept;
        _compactAt = Math.Max(FirstCompaction, kept * 2);
    }

    private void Put(int at, int strand, double top)
    {
        Strands[at] = strand;
        Tops[at] = top;
        var block = at >> BlockBits;
        if (block == BlockTops.Length) Array.Resize(ref BlockTops, block * 2);
        BlockTops[block] = (at & (Block - 1)) == 0 ? top : Math.Max(BlockTops[block], top);
    }
}

/// <summary>A cell of a <see cref="Deposit"/>.</summary>
internal struct DepositCell
{
    // Tops up to so many mm apart are of one layer.
    private const double SameHeight = 0.02;

    /// <summary>Highest top, mm; negative infinity where nothing is.</summary>
    public double Top;

    /// <summary>The highest top that is clearly below the highest, mm; negative infinity if there is none.</summary>
    public double Under;

    public void Lay(double top)
    {
        if (top > Top)
        {
            // The same height again is no layer of its own.
            if (top > Top + SameHeight) Under = Top;
            Top = top;
        }
        else if (top > Under && top < Top - SameHeight)
        {
            Under = top;
        }
    }
}
