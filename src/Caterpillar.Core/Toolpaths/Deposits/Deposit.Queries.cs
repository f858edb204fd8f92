using System;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>What lies at a place.</summary>
public sealed partial class Deposit
{
    private const int TopBits = 3;
    private const int MostParallel = 128;

    // mm; far more than an interpolated height is off.
    private const double Rounding = 1e-6;

    // Cosine of 18°.
    private const double Parallel = 0.95;
    private double[] _tops = [];
    private int _topsLeft, _topsBottom, _topsColumns;

    /// <summary>
    /// The height of the cell under a point, and the next height clearly below it, mm; negative infinity where nothing is. A cell is as high as what touches
    /// it.
    /// </summary>
    internal (double Top, double Under) CellAt(double x, double y)
    {
        if (!(Math.Abs(x) < MaxBins * DepositBin.Side * _cell && Math.Abs(y) < MaxBins * DepositBin.Side * _cell))
            return (_outside, double.NegativeInfinity);
        var cell = _cells[Index(x), Index(y)];
        return (cell.Top, cell.Under);
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
        int column = Index(p.X), row = Index(p.Y);
        var lowest = p.Z - 0.5 * height - Rounding;
        // A strand in its place would have raised the cell.
        if (_cells[column, row].Top < lowest) return false;
        (column, row) = ((column >> DepositBin.Bits) - _left, (row >> DepositBin.Bits) - _bottom);
        if (column < 0 || row < 0 || column >= _columns || row >= _rows || _bins[row * _columns + column] is not { } bin) return false;
        var length = along.LengthXY;
        if (!(length > 0)) return false;
        for (int i = bin.Count - 1, last = Math.Max(0, bin.Count - MostParallel); i >= last; i--)
        {
            var top = bin.Entries[i].Top;
            // The layer below begins here.
            if (top < p.Z - 2 * height) return false;
            if (top < lowest) continue;
            ref var strand = ref _store[bin.Entries[i].Strand];
            if (Math.Min(half, strand.Half) < 0.6 * Math.Max(half, strand.Half)) continue;
            double dx = strand.Bx - strand.Ax, dy = strand.By - strand.Ay;
            var near = 0.25 * (half + strand.Half);
            // Most are clearly beside it, which is told without a root.
            var aside = (p.X - strand.Ax) * dy - (p.Y - strand.Ay) * dx;
            if (aside * aside > (near * near + Rounding) * (dx * dx + dy * dy)) continue;
            var other = Math.Sqrt(dx * dx + dy * dy);
            if (!(other > 0) || Math.Abs(dx * along.X + dy * along.Y) < Parallel * other * length) continue;
            var t = ((p.X - strand.Ax) * dx + (p.Y - strand.Ay) * dy) / (other * other);
            if (t < 0 || t > 1) continue;
            double ex = p.X - strand.Ax - dx * t, ey = p.Y - strand.Ay - dy * t;
            if (ex * ex + ey * ey > near * near || Math.Abs(strand.Az + (strand.Bz - strand.Az) * t - p.Z) > 0.5 * height) continue;
            tag = strand.Tag;
            return true;
        }
        return false;
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
