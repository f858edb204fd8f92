namespace Caterpillar.Toolpaths;

/// <summary>A square of cells of a <see cref="Deposit"/>, with the extrusions that overlap it.</summary>
internal sealed class DepositBin
{
    public const int Bits = 3;
    public const int Side = 1 << Bits;
    public const int BlockBits = 3;
    public const int Block = 1 << BlockBits;
    private const int FirstCompaction = 32;

    /// <summary>Number of its cells.</summary>
    public const int Cells = Side * Side;

    /// <summary>The extrusions, in the order in which they were added.</summary>
    public DepositEntry[] Entries = new DepositEntry[16];

    public int Count;

    /// <summary>Highest top in the bin.</summary>
    public double Top = double.NegativeInfinity;

    /// <summary>Highest top of dropped extrusions, far below the print. Below it, only the cells answer.</summary>
    public double Dropped = double.NegativeInfinity;

    private int _compactAt = FirstCompaction;

    // Bounds of full blocks, so far as they were asked for, and how many of these have their planes.
    private DepositBlock[] _blocks = [];
    private int _known, _planes;

    // The last one, beside what else is asked for.
    private int _last = -1;

    /// <summary>An extrusion, or more of the last one, whose part here is up to <paramref name="top"/> mm high.</summary>
    public void Add(int extrusion, double top, bool isLevel, ExtrusionStore store, double keepDepth)
    {
        if (extrusion == _last)
        {
            ref var last = ref Entries[Count - 1];
            Put(Count - 1, new() { Extrusion = extrusion, Top = Math.Max(top, last.Top), IsLevel = last.IsLevel && isLevel && top == last.Top });
            return;
        }
        if (Count == _compactAt) Compact(store, keepDepth);
        if (Count == Entries.Length) Array.Resize(ref Entries, Count * 2);
        store.Use(extrusion);
        Put(Count++, new DepositEntry { Extrusion = extrusion, Top = top, IsLevel = isLevel });
        _last = extrusion;
    }

    /// <summary>True for the last entry of a block if it and all entries before it are at most so high.</summary>
    public bool AllBelow(int entry, double top) => (entry & (Block - 1)) == Block - 1 && !(BoundsOf(entry >> BlockBits).TopSoFar > top);

    /// <summary>Bounds of a full block of <see cref="Block"/> extrusions: layers below are skipped by blocks.</summary>
    public ref DepositBlock BoundsOf(int block)
    {
        if (block >= _blocks.Length) Array.Resize(ref _blocks, Entries.Length >> BlockBits);
        for (; _known <= block; _known++)
            _blocks[_known] = new DepositBlock(Entries, _known << BlockBits, _known > 0 ? _blocks[_known - 1].TopSoFar : double.NegativeInfinity);
        return ref _blocks[block];
    }

    /// <summary>A full block with its plane, in a bin with its middle and half its side and a cell in mm.</summary>
    public ref DepositBlock WithPlane(int block, Vec3 center, double distance, ExtrusionStore store)
    {
        ref var bounds = ref BoundsOf(block);
        for (; _planes <= block; _planes++)
        {
            var next = _blocks[_planes].WithPlane(_planes > 0 ? _blocks[_planes - 1] : default, Entries, _planes << BlockBits, store);
            // Blocks of the same layer raise it a little, those of lower ones do not.
            for (var before = _planes - 1; before >= 0 && !next.IsOver(_blocks[before], center, distance); before--)
                next = next.Over(Entries, before << BlockBits, store);
            _blocks[_planes] = next;
        }
        return ref bounds;
    }

    private void Compact(ExtrusionStore store, double keepDepth)
    {
        var kept = 0;
        for (var i = 0; i < Count; i++)
        {
            var entry = Entries[i];
            if (entry.Top >= Top - keepDepth)
            {
                Put(kept++, entry);
                continue;
            }
            Dropped = Math.Max(Dropped, entry.Top);
            store.Release(entry.Extrusion);
        }
        Count = kept;
        if (kept == 0) _last = -1;
        _compactAt = Math.Max(FirstCompaction, kept * 2);
    }

    private void Put(int at, in DepositEntry entry)
    {
        Entries[at] = entry;
        _known = Math.Min(_known, at >> BlockBits);
        _planes = Math.Min(_planes, _known);
    }
}

/// <summary>An extrusion in a bin. The top of its part is next to its number, because most extrusions are lower than a query.</summary>
internal struct DepositEntry
{
    public double Top;

    /// <summary>Number in the store.</summary>
    public int Extrusion;

    /// <summary>True if all of the extrusion is as high.</summary>
    public bool IsLevel;
}

/// <summary>A cell of a <see cref="Deposit"/>.</summary>
internal struct DepositCell
{
    // Tops up to so many mm apart are of one layer.
    private const double SameHeight = 0.02;

    /// <summary>Highest top, mm. Negative infinity = nothing.</summary>
    public double Top;

    /// <summary>The next top clearly below the highest one, mm. Negative infinity = none.</summary>
    public double Under;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
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
