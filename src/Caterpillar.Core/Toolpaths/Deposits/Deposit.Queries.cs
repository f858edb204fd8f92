using System;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>What a head at a height meets.</summary>
public sealed partial class Deposit
{
    private const double SameHeight = 0.02;
    private const int TopBits = 3;
    private const int MostParallel = 128;

    // Cosine of 18°.
    private const double Parallel = 0.95;
    private double[] _tops = [];
    private int _topsLeft, _topsBottom, _topsColumns;

    /// <summary>
    /// A strand that the head meets where its tip goes straight from a to b (seen from above) at height <paramref name="z"/>; its number, or −1 for one
    /// that has none. Never misses one; strands that were dropped count as their cells.
    /// </summary>
    /// <param name="a">Start of the segment, mm.</param>
    /// <param name="b">Its end.</param>
    /// <param name="z">Height of the tip, mm.</param>
    /// <param name="head">The underside of the head.</param>
    /// <param name="lenient">Not what the flat of the tip touches of a slope of up to 45°.</param>
    /// <param name="tag">Number of the strand.</param>
    internal bool Meets(Vec3 a, Vec3 b, double z, HeadShape head, bool lenient, out int tag)
    {
        tag = -1;
        var most = head.Reach(Highest - z);
        if (most < 0 || _bins.Length == 0) return false;
        var side = DepositBin.Side * _cell;
        var wide = side * (1 << TopBits);
        var (low, high) = (Math.Min(a.Y, b.Y) - most, Math.Max(a.Y, b.Y) + most);
        var firstRow = Clamp(low, side, _bottom, _rows);
        var lastRow = Clamp(high, side, _bottom, _rows);
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
                reach += wide * 0.7072;
                if (FlatSegment.SquareDistance(center, a, b) > reach * reach) continue;
                if (MeetsIn(broad, tall, a, b, z, head, lenient, ref tag)) return true;
            }
        }
        return false;
    }

    /// <summary>
    /// The height of the cell under a point, and the next height clearly below it, mm; negative infinity where nothing is. A cell is as high as what touches
    /// it.
    /// </summary>
    internal (double Top, double Under) CellAt(double x, double y)
    {
        if (!(Math.Abs(x) < MaxBins * DepositBin.Side * _cell && Math.Abs(y) < MaxBins * DepositBin.Side * _cell))
            return (_outside, double.NegativeInfinity);
        int column = Index(x), row = Index(y);
        int binColumn = (column >> DepositBin.Bits) - _left, binRow = (row >> DepositBin.Bits) - _bottom;
        if (binColumn < 0 || binRow < 0 || binColumn >= _columns || binRow >= _rows || _bins[binRow * _columns + binColumn] is not { } bin)
            return (double.NegativeInfinity, double.NegativeInfinity);
        var cell = ((row & (DepositBin.Side - 1)) << DepositBin.Bits) | (column & (DepositBin.Side - 1));
        return (bin.Cells[cell], bin.Under[cell]);
    }

    /// <summary>
    /// A cell above height <paramref name="z"/> that a rectangle passes, which is moved from a to b with its origin; the number of a strand there, or −1.
    /// </summary>
    internal bool MeetsBox(Vec3 a, Vec3 b, double z, Bounds box, out int tag)
    {
        tag = -1;
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
                        if (bin is not null && bin.Top > z && MeetsBoxIn(bin, column, row, a, b, z, box, out tag)) return true;
                    }
                }
            }
        }
        return false;
    }

    /// <summary>
    /// True if one of the last strands around a point is about as high, as wide, and runs in its place: their axes are less than a quarter of their widths
    /// apart.
    /// </summary>
    internal bool HasParallel(Vec3 p, Vec3 along, double half, double height, out int tag)
    {
        tag = -1;
        var side = DepositBin.Side * _cell;
        if (!(Math.Abs(p.X) < MaxBins * side && Math.Abs(p.Y) < MaxBins * side)) return false;
        int column = (Index(p.X) >> DepositBin.Bits) - _left, row = (Index(p.Y) >> DepositBin.Bits) - _bottom;
        if (column < 0 || row < 0 || column >= _columns || row >= _rows || _bins[row * _columns + column] is not { } bin) return false;
        var length = along.LengthXY;
        if (!(length > 0)) return false;
        for (int i = bin.Count - 1, last = Math.Max(0, bin.Count - MostParallel); i >= last; i--)
        {
            ref var strand = ref _store[bin.Strands[i]];
            // The layer below begins here.
            if (strand.Top < p.Z - 2 * height) return false;
            if (Math.Min(half, strand.Half) < 0.6 * Math.Max(half, strand.Half)) continue;
            double dx = strand.Bx - strand.Ax, dy = strand.By - strand.Ay;
            var other = Math.Sqrt(dx * dx + dy * dy);
            if (!(other > 0) || Math.Abs(dx * along.X + dy * along.Y) < Parallel * other * length) continue;
            var t = ((p.X - strand.Ax) * dx + (p.Y - strand.Ay) * dy) / (other * other);
            if (t < 0 || t > 1) continue;
            double ex = p.X - strand.Ax - dx * t, ey = p.Y - strand.Ay - dy * t;
            var near = 0.25 * (half + strand.Half);
            if (ex * ex + ey * ey > near * near || Math.Abs(strand.Az + (strand.Bz - strand.Az) * t - p.Z) > 0.5 * height) continue;
            tag = strand.Tag;
            return true;
        }
        return false;
    }

    private bool MeetsIn(int broad, int tall, Vec3 a, Vec3 b, double z, HeadShape head, bool lenient, ref int tag)
    {
        var side = DepositBin.Side * _cell;
        var firstRow = Math.Max(tall << TopBits, _bottom);
        var lastRow = Math.Min((tall << TopBits) + 7, _bottom + _rows - 1);
        var firstColumn = Math.Max(broad << TopBits, _left);
        var lastColumn = Math.Min((broad << TopBits) + 7, _left + _columns - 1);
        for (var row = firstRow; row <= lastRow; row++)
        {
            for (var column = firstColumn; column <= lastColumn; column++)
            {
                if (_bins[(row - _bottom) * _columns + column - _left] is not { } bin) continue;
                var reach = head.Reach(bin.Top - z);
                if (reach < 0) continue;
                reach += side * 0.7072;
                if (FlatSegment.SquareDistance(new Vec3((column + 0.5) * side, (row + 0.5) * side), a, b) > reach * reach) continue;
                if (MeetsStrand(bin, column, row, a, b, z, head, lenient, ref tag)) return true;
            }
        }
        return false;
    }

    private bool MeetsStrand(DepositBin bin, int column, int row, Vec3 a, Vec3 b, double z, HeadShape head, bool lenient, ref int tag)
    {
        for (var i = bin.Count - 1; i >= 0; i--)
        {
            ref var strand = ref _store[bin.Strands[i]];
            if (!(strand.Top > z) || !strand.Meets(a, b, z, head, lenient)) continue;
            tag = strand.Tag;
            return true;
        }
        if (!(bin.Dropped > z)) return false;
        for (var i = 0; i < bin.Cells.Length; i++)
        {
            var reach = head.AxisReach(Math.Min(bin.Cells[i], bin.Dropped) - z, _cell * 0.7072, lenient);
            if (reach < 0) continue;
            if (FlatSegment.SquareDistance(Center(column, row, i), a, b) <= reach * reach) return true;
        }
        return false;
    }

    private bool MeetsBoxIn(DepositBin bin, int column, int row, Vec3 a, Vec3 b, double z, Bounds box, out int tag)
    {
        tag = -1;
        var half = _cell / 2;
        for (var i = 0; i < bin.Cells.Length; i++)
        {
            if (!(bin.Cells[i] > z)) continue;
            var center = Center(column, row, i);
            double low = 0, high = 1;
            // The box passes the cell where its origin passes a rectangle around it.
            if (!Slab(a.X, b.X, center.X - box.Max.X - half, center.X - box.Min.X + half, ref low, ref high)
                || !Slab(a.Y, b.Y, center.Y - box.Max.Y - half, center.Y - box.Min.Y + half, ref low, ref high)) continue;
            for (var k = bin.Count - 1; k >= 0 && tag < 0; k--)
            {
                if (_store[bin.Strands[k]].Top > z) tag = _store[bin.Strands[k]].Tag;
            }
            return true;
        }
        return false;
    }

    private static bool Slab(double a, double b, double min, double max, ref double low, ref double high)
    {
        var d = b - a;
        if (d == 0) return a >= min && a <= max;
        low = Math.Max(low, Math.Min((min - a) / d, (max - a) / d));
        high = Math.Min(high, Math.Max((min - a) / d, (max - a) / d));
        return low <= high;
    }

    private void Raise(DepositBin bin, int column, int row, double top)
    {
        bin.Top = top;
        ref var wide = ref _tops[((row >> TopBits) - _topsBottom) * _topsColumns + (column >> TopBits) - _topsLeft];
        if (top > wide) wide = top;
    }

    private void GrowTops()
    {
        _topsLeft = _left >> TopBits;
        _topsBottom = _bottom >> TopBits;
        _topsColumns = ((_left + _columns - 1) >> TopBits) - _topsLeft + 1;
        _tops = new double[_topsColumns * (((_bottom + _rows - 1) >> TopBits) - _topsBottom + 1)];
        for (var i = 0; i < _tops.Length; i++) _tops[i] = double.NegativeInfinity;
        for (var i = 0; i < _bins.Length; i++)
        {
            if (_bins[i] is { } bin) Raise(bin, i % _columns + _left, i / _columns + _bottom, bin.Top);
        }
    }
}
