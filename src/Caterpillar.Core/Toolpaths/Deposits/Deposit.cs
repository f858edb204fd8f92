using System;
using System.Runtime.CompilerServices;
using Caterpillar.Dialects;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>
/// What has been printed so far, seen from above: a height field of square cells, with the strands in bins for exact answers. One structure for the height of
/// travels, beads from the gap, the safe return of turtles, support and collision. It grows with the print; strands far below the top of their bin are dropped,
/// and there the cells answer (never too low, and too wide by less than one cell). Not thread-safe.
/// </summary>
public sealed partial class Deposit
{
    // Deviation of the chords of an arc, mm.
    private const double ArcTolerance = 0.02;

    // Bins on each side of the origin: 2 m with the usual cell. Everything farther out has one height.
    private const int MaxBins = 1024;
    private readonly double _cell;
    private readonly double _perCell;
    private readonly double _keepDepth;
    private readonly StrandStore _store = new();
    private readonly DepositCells _cells = new();

    // What a strand covers: of all, and in the rows of a bin.
    private readonly StrandRows _rowsOf;
    private readonly (int First, int Last)[] _spans = new (int, int)[DepositBin.Side];
    private DepositBin?[] _bins = [];
    private int _left, _bottom, _columns, _rows;
    private double _outside = double.NegativeInfinity;

    // The last strand, if all of it is inside; else −1.
    private int _last = -1;

    /// <param name="cell">Side of a cell, mm; half the width of a strand or less.</param>
    /// <param name="keepDepth">Strands this far below the highest one of their bin are dropped, mm.</param>
    /// <exception cref="ArgumentOutOfRangeException">A length is not positive.</exception>
    public Deposit(double cell = 0.25, double keepDepth = 10)
    {
        if (!(cell > 0) || double.IsInfinity(cell)) throw new ArgumentOutOfRangeException(nameof(cell), "The cell size must be positive.");
        if (!(keepDepth > 0)) throw new ArgumentOutOfRangeException(nameof(keepDepth), "The depth must be positive.");
        _cell = cell;
        _perCell = 1 / cell;
        _rowsOf = new StrandRows(cell);
        _keepDepth = keepDepth;
    }

    /// <summary>Side of a cell, mm.</summary>
    public double Cell => _cell;

    /// <summary>Highest point printed, mm; negative infinity before anything is.</summary>
    public double Highest { get; private set; } = double.NegativeInfinity;

    /// <summary>Number of strands kept for exact answers.</summary>
    public int StrandCount => _store.Count;

    /// <summary>Adds the strands of a path. Segments without material are skipped.</summary>
    public void Add(PrintPath path, BeadShape shape = BeadShape.Rectangle)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        for (var i = 0; i < path.SegmentCount; i++) Add(path.Points[i], path.EndOf(i), path.BeadOf(i), path.ArcOf(i), shape);
    }

    /// <summary>Adds a segment of a path, straight or an arc.</summary>
    public void Add(Vec3 from, Vec3 to, Bead bead, Arc? arc = null, BeadShape shape = BeadShape.Rectangle)
    {
        if (!(bead.Area > 0)) return;
        // A bead of almost no height would be as wide as the bed.
        var half = Math.Min(bead.Width(shape), 40 * Math.Sqrt(bead.Area / Math.PI)) / 2;
        if (arc is not { } turn)
        {
            Add(from, to, half);
            return;
        }
        var chords = turn.ChordCount(from, ArcTolerance);
        var at = from;
        for (var k = 1; k <= chords; k++)
        {
            var next = turn.PointAt(from, to, (double)k / chords);
            Add(at, next, half);
            at = next;
        }
    }

    /// <summary>Adds a straight strand: the path of the nozzle tip (its top) in mm and half its width in mm.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite, or the width is negative.</exception>
    public void Add(Vec3 from, Vec3 to, double halfWidth) => Add(from, to, halfWidth, -1);

    /// <summary>The same with a number for what it is, 0 or more.</summary>
    internal void Add(Vec3 from, Vec3 to, double halfWidth, int tag)
    {
        if (!from.IsFinite || !to.IsFinite) throw new ArgumentOutOfRangeException(nameof(from), "The ends of a strand must be finite.");
        if (!(halfWidth >= 0) || double.IsInfinity(halfWidth))
        {
            throw new ArgumentOutOfRangeException(nameof(halfWidth), "The width of a strand must be finite and not negative.");
        }
        var strand = new Strand { Ax = from.X, Ay = from.Y, Az = from.Z, Bx = to.X, By = to.Y, Bz = to.Z, Half = halfWidth, Tag = tag };
        Highest = Math.Max(Highest, strand.Top);
        var edge = MaxBins * DepositBin.Side * _cell;
        _last = -1;
        if (IsOutside(from, halfWidth, edge) || IsOutside(to, halfWidth, edge))
        {
            _outside = Math.Max(_outside, strand.Top);
            // Only the part inside is drawn into cells.
            double low = 0, high = 1;
            if (!ClipAxis(strand.Ax, strand.Bx, edge - halfWidth - _cell, ref low, ref high)
                || !ClipAxis(strand.Ay, strand.By, edge - halfWidth - _cell, ref low, ref high))
            {
                return;
            }
            var (a, b) = (Vec3.Lerp(from, to, low), Vec3.Lerp(from, to, high));
            strand = strand with { Ax = a.X, Ay = a.Y, Az = a.Z, Bx = b.X, By = b.Y, Bz = b.Z };
            Draw(_store.Add(strand), strand);
            return;
        }
        Draw(_last = _store.Add(strand), strand);
    }

    /// <summary>The strand that was added last goes on in its line, at the same width, from its end to another.</summary>
    internal void GoOn(Vec3 from, Vec3 to, double halfWidth, int tag)
    {
        if (_last < 0 || IsOutside(to, halfWidth, MaxBins * DepositBin.Side * _cell))
        {
            Add(from, to, halfWidth, tag);
            return;
        }
        ref var whole = ref _store[_last];
        (whole.Bx, whole.By, whole.Bz) = (to.X, to.Y, to.Z);
        Highest = Math.Max(Highest, to.Z);
        Draw(_last, whole with { Ax = from.X, Ay = from.Y, Az = from.Z });
    }

    /// <summary>
    /// Highest top, mm, of what lies within <paramref name="radius"/> mm of the line from <paramref name="a"/> to <paramref name="b"/>, all seen from above;
    /// negative infinity if nothing does.
    /// </summary>
    public double TopAlong(Vec3 a, Vec3 b, double radius)
    {
        var edge = MaxBins * DepositBin.Side * _cell;
        var best = IsOutside(a, radius, edge) || IsOutside(b, radius, edge) ? _outside : double.NegativeInfinity;
        if (_bins.Length == 0) return best;
        var side = DepositBin.Side * _cell;
        var halfDiagonal = side * 0.7072;
        var firstRow = Clamp(Math.Min(a.Y, b.Y) - radius, side, _bottom, _rows);
        var lastRow = Clamp(Math.Max(a.Y, b.Y) + radius, side, _bottom, _rows);
        for (var row = firstRow; row <= lastRow; row++)
        {
            var y = row * side;
            if (!FlatSegment.RowSpan(a, b, y - radius, y + side + radius, out var x0, out var x1)) continue;
            var first = Clamp(x0 - radius, side, _left, _columns);
            var last = Clamp(x1 + radius, side, _left, _columns);
            for (var column = first; column <= last; column++)
            {
                var bin = _bins[(row - _bottom) * _columns + column - _left];
                if (bin is null || bin.Top <= best) continue;
                var center = new Vec3((column + 0.5) * side, y + side / 2);
                if (FlatSegment.SquareDistance(center, a, b) > (radius + halfDiagonal) * (radius + halfDiagonal)) continue;
                best = TopInBin(bin, column, row, a, b, radius, best);
            }
        }
        return best;
    }

    /// <summary>
    /// Highest top, mm, not above <paramref name="limit"/>, of what lies within <paramref name="radius"/> mm of a point seen from above; negative infinity
    /// if nothing does.
    /// </summary>
    public double TopUnder(Vec3 point, double limit, double radius = 0)
    {
        var best = double.NegativeInfinity;
        var side = DepositBin.Side * _cell;
        if (_bins.Length == 0 || !(Math.Abs(point.X) < MaxBins * side && Math.Abs(point.Y) < MaxBins * side)) return best;
        var lastRow = Clamp(point.Y + radius, side, _bottom, _rows);
        var lastColumn = Clamp(point.X + radius, side, _left, _columns);
        for (var row = Clamp(point.Y - radius, side, _bottom, _rows); row <= lastRow; row++)
        {
            for (var column = Clamp(point.X - radius, side, _left, _columns); column <= lastColumn; column++)
            {
                var bin = _bins[(row - _bottom) * _columns + column - _left];
                if (bin is null || bin.Top <= best) continue;
                for (var i = 0; i < bin.Count; i++)
                {
                    var top = _store[bin.Entries[i].Strand].TopAt(point, radius);
                    if (top <= limit && top > best) best = top;
                }
                if (bin.Dropped > best) best = DroppedUnder(bin, column, row, point, limit, radius, best);
            }
        }
        return best;
    }

    /// <summary>
    /// True if a tip of the given radius in mm can move straight from <paramref name="a"/> to <paramref name="b"/> without dipping more than
    /// <paramref name="tolerance"/> mm below the top of anything it passes.
    /// </summary>
    public bool IsFree(Vec3 a, Vec3 b, double radius, double tolerance = 1e-6)
    {
        var top = TopAlong(a, b, radius);
        if (top <= Math.Min(a.Z, b.Z) + tolerance) return true;
        if (top > Math.Max(a.Z, b.Z) + tolerance && a.Z == b.Z) return false;
        // On a slope the height differs along the line: check it in pieces.
        if ((b - a).LengthXY <= _cell / 4) return false;
        var middle = Vec3.Lerp(a, b, 0.5);
        return IsFree(a, middle, radius, tolerance) && IsFree(middle, b, radius, tolerance);
    }

    private double TopInBin(DepositBin bin, int column, int row, Vec3 a, Vec3 b, double radius, double best)
    {
        for (var i = bin.Count - 1; i >= 0; i--)
        {
            if (bin.Entries[i].Top > best) best = Math.Max(best, _store[bin.Entries[i].Strand].TopWithin(a, b, radius));
        }
        if (bin.Dropped <= best) return best;
        var reach = radius + _cell * 0.7072;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = Math.Min(CellIn(column, row, i).Top, bin.Dropped);
            if (top > best && FlatSegment.SquareDistance(Center(column, row, i), a, b) <= reach * reach) best = top;
        }
        return best;
    }

    private double DroppedUnder(DepositBin bin, int column, int row, Vec3 point, double limit, double radius, double best)
    {
        var reach = radius + _cell * 0.7072;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = Math.Min(CellIn(column, row, i).Top, bin.Dropped);
            if (top > best && top <= limit && FlatSegment.SquareDistance(Center(column, row, i), point, point) <= reach * reach) best = top;
        }
        return best;
    }

    // A cell of a bin.
    private DepositCell CellIn(int column, int row, int cell)
        => _cells[(column << DepositBin.Bits) + (cell & (DepositBin.Side - 1)), (row << DepositBin.Bits) + (cell >> DepositBin.Bits)];

    private Vec3 Center(int column, int row, int cell) => new(
        ((column << DepositBin.Bits) + (cell & (DepositBin.Side - 1)) + 0.5) * _cell, ((row << DepositBin.Bits) + (cell >> DepositBin.Bits) + 0.5) * _cell);

    private void Draw(int index, in Strand strand)
    {
        var rows = _rowsOf;
        rows.Aim(strand);
        var (highest, rise) = (strand.Top, strand.Bz - strand.Az);
        var isLevel = rise == 0 || !(rows.Length > 0);
        for (int row = rows.First, end; row <= rows.Last; row = end + 1)
        {
            end = Math.Min(rows.Last, row | (DepositBin.Side - 1));
            int left = int.MaxValue, right = int.MinValue;
            for (var i = row; i <= end; i++)
            {
                ref var span = ref _spans[i - row];
                rows.Span(i, out span.First, out span.Last);
                if (span.First > span.Last) continue;
                left = Math.Min(left, span.First);
                right = Math.Max(right, span.Last);
            }
            // Spans of rows above each other touch: there is no bin between the outermost that knows nothing of the strand.
            for (var column = left >> DepositBin.Bits; column <= right >> DepositBin.Bits; column++) Enter(column, row >> DepositBin.Bits, index, highest);
            if (isLevel) _cells.Lay(_spans, row, end, left, right, highest);
            else LaySloped(strand, row, end);
        }
    }

    // Each cell as high as the strand is there at most.
    private void LaySloped(in Strand strand, int row, int end)
    {
        var rise = strand.Bz - strand.Az;
        var spread = Math.Abs(rise) / _rowsOf.Length * _cell * 0.7072;
        for (var i = row; i <= end; i++)
        {
            for (var column = _spans[i - row].First; column <= _spans[i - row].Last; column++)
            {
                var top = strand.Az + rise * Math.Min(1, Math.Max(0, _rowsOf.Along(strand, column, i))) + spread;
                _cells.Lay(column, i, Math.Min(strand.Top, top));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Index(double x) => StrandRows.Index(x, _perCell);

    // A strand reaches into a bin.
    private void Enter(int column, int row, int strand, double highest)
    {
        var bin = BinAt(column, row);
        bin.Add(strand, highest, _store, _keepDepth);
        if (highest > bin.Top) Raise(bin, column, row, highest);
    }

    private static int Clamp(double x, double side, int first, int count)
        => (int)Math.Min(Math.Max(Math.Floor(x / side), first), first + count - 1);

    private static bool IsOutside(Vec3 p, double margin, double edge) => !(Math.Abs(p.X) + margin < edge && Math.Abs(p.Y) + margin < edge);

    private static bool ClipAxis(double a, double b, double edge, ref double low, ref double high)
    {
        var d = b - a;
        if (!(edge > 0)) return false;
        if (d == 0) return Math.Abs(a) <= edge;
        low = Math.Max(low, Math.Min((-edge - a) / d, (edge - a) / d));
        high = Math.Min(high, Math.Max((-edge - a) / d, (edge - a) / d));
        return low <= high;
    }

    private DepositBin BinAt(int column, int row)
    {
        if (column < _left || row < _bottom || column >= _left + _columns || row >= _bottom + _rows) GrowTo(column, row);
        ref var bin = ref _bins[(row - _bottom) * _columns + column - _left];
        return bin ??= new DepositBin();
    }

    private void GrowTo(int column, int row)
    {
        // Grows by half on the side that was exceeded, so that growing costs little overall.
        var margin = _bins.Length == 0 ? 4 : Math.Max(_columns, _rows) / 2;
        var left = _bins.Length == 0 ? column - margin : column < _left ? column - margin : _left;
        var bottom = _bins.Length == 0 ? row - margin : row < _bottom ? row - margin : _bottom;
        var right = _bins.Length == 0 ? column + margin : column >= _left + _columns ? column + margin : _left + _columns - 1;
        var top = _bins.Length == 0 ? row + margin : row >= _bottom + _rows ? row + margin : _bottom + _rows - 1;
        left = Math.Max(left, -MaxBins - 1);
        bottom = Math.Max(bottom, -MaxBins - 1);
        right = Math.Min(right, MaxBins);
        top = Math.Min(top, MaxBins);
        var bins = new DepositBin?[(right - left + 1) * (top - bottom + 1)];
        for (var y = 0; y < _rows; y++)
        {
            var at = (y + _bottom - bottom) * (right - left + 1) + _left - left;
            Array.Copy(_bins, y * _columns, bins, at, _columns);
        }
        (_bins, _left, _bottom, _columns, _rows) = (bins, left, bottom, right - left + 1, top - bottom + 1);
        GrowTops();
    }
}
