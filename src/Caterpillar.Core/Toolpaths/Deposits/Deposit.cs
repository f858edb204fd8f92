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
    private DepositBin?[] _bins = [];

    // Those of the bins: what is asked for most is one step nearer.
    private DepositCell[]?[] _cells = [];
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
        for (var i = 0; i < bin.Cells.Length; i++)
        {
            var top = Math.Min(bin.Cells[i].Top, bin.Dropped);
            if (top > best && FlatSegment.SquareDistance(Center(column, row, i), a, b) <= reach * reach) best = top;
        }
        return best;
    }

    private double DroppedUnder(DepositBin bin, int column, int row, Vec3 point, double limit, double radius, double best)
    {
        var reach = radius + _cell * 0.7072;
        for (var i = 0; i < bin.Cells.Length; i++)
        {
            var top = Math.Min(bin.Cells[i].Top, bin.Dropped);
            if (top > best && top <= limit && FlatSegment.SquareDistance(Center(column, row, i), point, point) <= reach * reach) best = top;
        }
        return best;
    }

    private Vec3 Center(int column, int row, int cell) => new(
        ((column << DepositBin.Bits) + (cell & (DepositBin.Side - 1)) + 0.5) * _cell, ((row << DepositBin.Bits) + (cell >> DepositBin.Bits) + 0.5) * _cell);

    // In each row of cells the strand, wider by half a diagonal, covers a span: between its sides, or the ends of its discs.
    private void Draw(int index, in Strand strand)
    {
        double ax = strand.Ax, ay = strand.Ay, az = strand.Az, dx = strand.Bx - ax, dy = strand.By - ay, rise = strand.Bz - az;
        var (half, highest, cell) = (strand.Half, strand.Top, _cell);
        var halfDiagonal = cell * 0.7072;
        var reach = half + halfDiagonal;
        var square = dx * dx + dy * dy;
        var inverse = square > 0 ? 1 / square : 0;
        var perY = dy != 0 ? 1 / dy : 0;
        double slope = dx * perY, side = reach * Math.Sqrt(square) * Math.Abs(perY);
        var spread = rise != 0 && square > 0 ? Math.Abs(rise) * Math.Sqrt(inverse) * halfDiagonal : 0;
        var lastRow = Index(Math.Max(ay, strand.By) + half);
        // The bins of the row that know of the strand already.
        int known = 0, beyond = 0;
        for (var row = Index(Math.Min(ay, strand.By) - half); row <= lastRow; row++)
        {
            if ((row & (DepositBin.Side - 1)) == 0) known = beyond = 0;
            var y = row * cell - ay;
            // The part of the axis from which the strand may reach the row.
            double from = 0, to = 1;
            if (dy != 0)
            {
                double enter = (y - half) * perY, leave = (y + cell + half) * perY;
                if (enter > leave) (enter, leave) = (leave, enter);
                if (enter > 1 || leave < 0) continue;
                if (enter > 0) from = enter;
                if (leave < 1) to = leave;
            }
            double left = dx * from, right = dx * to;
            if (left > right) (left, right) = (right, left);
            var py = y + cell / 2;
            var along = py * dy;
            double low = py * slope - side, high = py * slope + side;
            double lowAt = (low * dx + along) * inverse, highAt = (high * dx + along) * inverse;
            if (dy == 0) (lowAt, highAt) = dx < 0 ? (2, -1) : (-1, 2);
            if (!(lowAt >= 0 && lowAt <= 1 || IsOnDisc(lowAt > 1, dx, dy, py, reach, -1, out low))) continue;
            if (!(highAt >= 0 && highAt <= 1 || IsOnDisc(highAt > 1, dx, dy, py, reach, 1, out high))) continue;
            var column = Math.Max(Index(ax + left - half), Index(ax + low + cell / 2));
            var last = Math.Min(Index(ax + right + half), Index(ax + high - cell / 2));
            var line = (row & (DepositBin.Side - 1)) << DepositBin.Bits;
            while (column <= last)
            {
                var at = column >> DepositBin.Bits;
                DepositCell[] cells;
                if (at >= known && at < beyond)
                {
                    cells = _cells[((row >> DepositBin.Bits) - _bottom) * _columns + at - _left]!;
                }
                else
                {
                    cells = Enter(at, row >> DepositBin.Bits, index, highest);
                    if (known == beyond) (known, beyond) = (at, at + 1);
                    else if (at == beyond) beyond++;
                    else if (at == known - 1) known--;
                }
                var end = Math.Min(last, column | (DepositBin.Side - 1));
                if (rise == 0 || !(square > 0))
                {
                    for (; column <= end; column++) cells[line | (column & (DepositBin.Side - 1))].Lay(highest);
                    continue;
                }
                for (; column <= end; column++)
                {
                    var t = (((column + 0.5) * cell - ax) * dx + along) * inverse;
                    var top = Math.Min(highest, az + rise * Math.Min(1, Math.Max(0, t)) + spread);
                    cells[line | (column & (DepositBin.Side - 1))].Lay(top);
                }
            }
        }
    }

    // The left or right end of a row of the disc around the start or the end of a strand.
    private static bool IsOnDisc(bool atEnd, double dx, double dy, double py, double reach, int sign, out double x)
    {
        var y = atEnd ? py - dy : py;
        var root = reach * reach - y * y;
        x = (atEnd ? dx : 0) + sign * Math.Sqrt(root);
        return root >= 0;
    }

    // Rounded down. Plain comparisons: this, and the drawing of strands, is most of what a check costs.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Index(double x)
    {
        var cells = x * _perCell;
        var index = (int)cells;
        return cells < index ? index - 1 : index;
    }

    // The cells of a bin, with a strand that reaches into it.
    private DepositCell[] Enter(int column, int row, int strand, double highest)
    {
        var bin = BinAt(column, row);
        bin.Add(strand, highest, _store, _keepDepth);
        if (highest > bin.Top) Raise(bin, column, row, highest);
        return bin.Cells;
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
        if (bin is not null) return bin;
        bin = new DepositBin();
        _cells[(row - _bottom) * _columns + column - _left] = bin.Cells;
        return bin;
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
        var cells = new DepositCell[]?[bins.Length];
        for (var y = 0; y < _rows; y++)
        {
            var at = (y + _bottom - bottom) * (right - left + 1) + _left - left;
            Array.Copy(_bins, y * _columns, bins, at, _columns);
            Array.Copy(_cells, y * _columns, cells, at, _columns);
        }
        (_bins, _cells, _left, _bottom, _columns, _rows) = (bins, cells, left, bottom, right - left + 1, top - bottom + 1);
        GrowTops();
    }
}
