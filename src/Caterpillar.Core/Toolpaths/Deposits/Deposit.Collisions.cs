using System;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>
/// What a head and its boxes meet that go straight from a to b, up or down as well. Nothing is missed.
/// </summary>
public sealed partial class Deposit
{
    // Rise of a piece of the path of a box that counts as level, mm.
    private const double Level = 0.02;

    /// <summary>
    /// What the head does to strands where its tip goes straight from a to b. Never misses one; strands that were dropped count as their cells.
    /// </summary>
    /// <param name="a">Start of the segment, mm.</param>
    /// <param name="b">Its end.</param>
    /// <param name="tolerance">How deep it may touch them, mm.</param>
    /// <param name="head">The underside of the head.</param>
    /// <param name="hitsOnly">What it only digs into does not count.</param>
    /// <param name="tag">Number of the strand that it hits or digs into, or −1 for one that has none.</param>
    internal HeadContact Meets(Vec3 a, Vec3 b, double tolerance, HeadShape head, bool hitsOnly, out int tag)
    {
        tag = -1;
        var z = Math.Min(a.Z, b.Z) + tolerance;
        var most = head.Reach(Highest - z);
        if (most < 0 || _bins.Length == 0) return HeadContact.None;
        var query = new HeadQuery(a, b, tolerance, head, hitsOnly);
        var side = DepositBin.Side * _cell;
        var wide = side * (1 << TopBits);
        var firstRow = Clamp(Math.Min(a.Y, b.Y) - most, side, _bottom, _rows);
        var lastRow = Clamp(Math.Max(a.Y, b.Y) + most, side, _bottom, _rows);
        for (var tall = firstRow >> TopBits; tall <= lastRow >> TopBits; tall++)
        {
            if (!FlatSegment.RowSpan(a, b, tall * wide - most, (tall + 1) * wide + most, out var x0, out var x1)) continue;
            var first = Clamp(x0 - most, side, _left, _columns);
            var last = Clamp(x1 + most, side, _left, _columns);
            for (var broad = first >> TopBits; broad <= last >> TopBits; broad++)
            {
                var reach = head.Reach(_tops[(tall - _topsBottom) * _topsColumns + broad - _topsLeft] - z);
                if (reach < 0) continue;
                var center = new Vec3((broad + 0.5) * wide, (tall + 0.5) * wide);
                var far = reach + wide * 0.7072;
                if (FlatSegment.SquareDistance(center, a, b) > far * far) continue;
                if (MeetsIn(broad, tall, z, reach, ref query, ref tag)) return HeadContact.Hits;
            }
        }
        return query.Digs ? HeadContact.Digs : HeadContact.None;
    }

    /// <summary>
    /// A cell more than <paramref name="tolerance"/> above the bottom of a box that is moved from a to b with its origin; the number of a strand
    /// there, or −1.
    /// </summary>
    internal bool MeetsBox(Vec3 a, Vec3 b, double tolerance, Bounds box, out int tag)
    {
        tag = -1;
        var z = Math.Min(a.Z, b.Z) + tolerance + box.Min.Z;
        if (_bins.Length == 0 || !(Highest > z)) return false;
        var side = DepositBin.Side * _cell;
        var firstRow = Clamp(Math.Min(a.Y, b.Y) + box.Min.Y, side, _bottom, _rows);
        var lastRow = Clamp(Math.Max(a.Y, b.Y) + box.Max.Y, side, _bottom, _rows);
        var first = Clamp(Math.Min(a.X, b.X) + box.Min.X, side, _left, _columns);
        var last = Clamp(Math.Max(a.X, b.X) + box.Max.X, side, _left, _columns);
        for (var tall = firstRow >> TopBits; tall <= lastRow >> TopBits; tall++)
        {
            for (var broad = first >> TopBits; broad <= last >> TopBits; broad++)
            {
                if (!(_tops[(tall - _topsBottom) * _topsColumns + broad - _topsLeft] > z)) continue;
                var (rowEnd, columnEnd) = (Math.Min(lastRow, (tall << TopBits) + 7), Math.Min(last, (broad << TopBits) + 7));
                for (var row = Math.Max(firstRow, tall << TopBits); row <= rowEnd; row++)
                {
                    for (var column = Math.Max(first, broad << TopBits); column <= columnEnd; column++)
                    {
                        var bin = _bins[(row - _bottom) * _columns + column - _left];
                        if (bin is not null && bin.Top > z && MeetsBoxIn(bin, column, row, a, b, tolerance, box, out tag)) return true;
                    }
                }
            }
        }
        return false;
    }

    // True where it hits; digging is noted in the query.
    private bool MeetsIn(int broad, int tall, double z, double most, ref HeadQuery query, ref int tag)
    {
        var side = DepositBin.Side * _cell;
        var (a, b) = (query.From, query.To);
        var firstRow = Math.Max(tall << TopBits, Clamp(Math.Min(a.Y, b.Y) - most, side, _bottom, _rows));
        var lastRow = Math.Min((tall << TopBits) + 7, Clamp(Math.Max(a.Y, b.Y) + most, side, _bottom, _rows));
        var firstColumn = Math.Max(broad << TopBits, Clamp(Math.Min(a.X, b.X) - most, side, _left, _columns));
        var lastColumn = Math.Min((broad << TopBits) + 7, Clamp(Math.Max(a.X, b.X) + most, side, _left, _columns));
        for (var row = firstRow; row <= lastRow; row++)
        {
            for (var column = firstColumn; column <= lastColumn; column++)
            {
                if (_bins[(row - _bottom) * _columns + column - _left] is not { } bin || !(bin.Top > z)) continue;
                // All of the bin is at least so far away: only what is higher than the underside of the head there can be touched.
                double x = (column + 0.5) * side, y = (row + 0.5) * side;
                var above = query.Head.HeightAt(query.DistanceTo(x, y, side / 2));
                if (!(bin.Top > z + above)) continue;
                var low = query.LowestNear(x, y, side / 2, query.Head.Reach(bin.Top - z)) + query.Tolerance;
                if (bin.Top > low + above && MeetsBin(bin, column, row, low + above, low, ref query, ref tag)) return true;
            }
        }
        return false;
    }

    private bool MeetsBin(DepositBin bin, int column, int row, double z, double low, ref HeadQuery query, ref int tag)
    {
        // Nothing in the bin is touched farther away.
        var reach = query.Head.Reach(bin.Top - low);
        query.Aim(bin.Top - low);
        for (var block = (bin.Count - 1) >> DepositBin.BlockBits; block >= 0; block--)
        {
            var first = block << DepositBin.BlockBits;
            if (first + DepositBin.Block <= bin.Count && !(bin.BlockTops[block] > z)) continue;
            for (var i = Math.Min(first + DepositBin.Block, bin.Count) - 1; i >= first; i--)
            {
                if (!(bin.Entries[i].Top > z)) continue;
                ref var strand = ref _store[bin.Entries[i].Strand];
                if (strand.IsBeyond(query.From, query.To, reach + strand.Half)) continue;
                var hits = query.Meets(strand);
                if (hits || (query.Digs && tag < 0)) tag = strand.Tag;
                if (hits) return true;
            }
        }
        if (!(bin.Dropped > z)) return false;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = Math.Min(CellIn(column, row, i).Top, bin.Dropped);
            if (top > z && query.Meets(Strand.At(Center(column, row, i), top, _cell * 0.7072))) return true;
        }
        return false;
    }

    private bool MeetsBoxIn(DepositBin bin, int column, int row, Vec3 a, Vec3 b, double tolerance, Bounds box, out int tag)
    {
        tag = -1;
        var side = DepositBin.Side * _cell;
        if (!Passes(box, new Vec3((column + 0.5) * side, (row + 0.5) * side), side / 2, a, b)) return false;
        var z = Math.Min(a.Z, b.Z) + tolerance + box.Min.Z;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = CellIn(column, row, i).Top;
            if (!(top > z) || !MeetsCell(Center(column, row, i), top - tolerance - box.Min.Z, a, b, box)) continue;
            for (var k = bin.Count - 1; k >= 0 && tag < 0; k--)
            {
                if (bin.Entries[k].Top > z) tag = _store[bin.Entries[k].Strand].Tag;
            }
            return true;
        }
        return false;
    }

    // The cell is hit by an origin below a height.
    private bool MeetsCell(Vec3 center, double below, Vec3 a, Vec3 b, Bounds box)
    {
        if (!(below > Math.Min(a.Z, b.Z)) || !Passes(box, center, _cell / 2, a, b)) return false;
        if (IsLevel(a, b)) return true;
        var middle = Vec3.Lerp(a, b, 0.5);
        return MeetsCell(center, below, a, middle, box) || MeetsCell(center, below, middle, b, box);
    }

    // A box passes a square where its origin passes a rectangle around it.
    private static bool Passes(Bounds box, Vec3 center, double half, Vec3 a, Vec3 b)
    {
        double low = 0, high = 1;
        return Slab(a.X, b.X, center.X - box.Max.X - half, center.X - box.Min.X + half, ref low, ref high)
            && Slab(a.Y, b.Y, center.Y - box.Max.Y - half, center.Y - box.Min.Y + half, ref low, ref high);
    }

    // Straight up and down the lower end decides.
    private bool IsLevel(Vec3 a, Vec3 b) => Math.Abs(a.Z - b.Z) <= Level || (b - a).LengthXY <= _cell / 8;

    private static bool Slab(double a, double b, double min, double max, ref double low, ref double high)
    {
        var d = b - a;
        if (d == 0) return a >= min && a <= max;
        low = Math.Max(low, Math.Min((min - a) / d, (max - a) / d));
        high = Math.Min(high, Math.Max((min - a) / d, (max - a) / d));
        return low <= high;
    }
}
