using System;

namespace Caterpillar.Toolpaths;

/// <summary>A square of cells of a <see cref="Deposit"/>, with the strands that overlap it.</summary>
internal sealed class DepositBin
{
    public const int Bits = 4;
    public const int Side = 1 << Bits;
    private const int FirstCompaction = 64;

    /// <summary>Highest top in each cell, mm; negative infinity in empty cells.</summary>
    public readonly double[] Cells = new double[Side * Side];

    /// <summary>In each cell the highest top that is clearly below the highest, mm; negative infinity if there is none.</summary>
    public readonly double[] Under = new double[Side * Side];

    public int[] Strands = new int[4];

    public int Count;

    /// <summary>Highest top in the bin.</summary>
    public double Top = double.NegativeInfinity;

    /// <summary>Highest top among strands that were dropped because the print is far above them; there only the cells answer.</summary>
    public double Dropped = double.NegativeInfinity;

    private int _compactAt = FirstCompaction;

    public DepositBin()
    {
        for (var i = 0; i < Cells.Length; i++) Cells[i] = Under[i] = double.NegativeInfinity;
    }

    public void Add(int strand, StrandStore store, double keepDepth)
    {
        if (Count > 0 && Strands[Count - 1] == strand) return;
        if (Count == _compactAt) Compact(store, keepDepth);
        if (Count == Strands.Length) Array.Resize(ref Strands, Count * 2);
        Strands[Count++] = strand;
        store[strand].Users++;
    }

    private void Compact(StrandStore store, double keepDepth)
    {
        var kept = 0;
        for (var i = 0; i < Count; i++)
        {
            var top = store[Strands[i]].Top;
            if (top >= Top - keepDepth)
            {
                Strands[kept++] = Strands[i];
                continue;
            }
            Dropped = Math.Max(Dropped, top);
            store.Release(Strands[i]);
        }
        Count = kept;
        _compactAt = Math.Max(FirstCompaction, kept * 2);
    }
}
