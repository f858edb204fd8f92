namespace Caterpillar.Toolpaths;

/// <summary>
/// The print so far, seen from above: a height field of square cells, with the extrusions in bins for exact answers. Used for Z-hop, beads from the gap, the
/// safe return of turtles, support and collisions. It grows with the print. Extrusions far below the top of their bin are dropped. The cells then answer: never
/// too low, and too wide by less than one cell; along a travel, all of the bin counts. Not thread-safe.
/// </summary>
internal sealed class Deposit
{
    // Deviation of the chords of an arc, mm.
    private const double ArcTolerance = 0.02;

    // mm; far more than an interpolated height is off.
    private const double Rounding = 1e-6;

    private readonly double _cell;
    private readonly double _perCell;
    private readonly double _keepDepth;
    private readonly bool _hasCells;
    private readonly ExtrusionStore _store = new();
    private readonly DepositCells _cells = new();
    private readonly DepositBins _bins;

    // What an extrusion covers: of all, and in the rows of a bin.
    private readonly ExtrusionRows _rowsOf;
    private readonly (int First, int Last)[] _spans = new (int, int)[DepositBin.Side];
    private double _outside = double.NegativeInfinity;

    // The last extrusion, if all of it is inside; else −1.
    private int _last = -1;

    /// <param name="cell">Side of a cell, mm, at most half the width of an extrusion.</param>
    /// <param name="keepDepth">Depth below the highest extrusion of a bin at which extrusions are dropped, mm.</param>
    /// <param name="hasCells">Without cells, only <see cref="TopAlong"/> and <see cref="Highest"/> answer.</param>
    /// <exception cref="ArgumentOutOfRangeException">A length is not positive.</exception>
    public Deposit(double cell = 0.25, double keepDepth = 10, bool hasCells = true)
    {
        if (!(cell > 0) || double.IsInfinity(cell)) throw new ArgumentOutOfRangeException(nameof(cell), "The cell size must be positive.");
        if (!(keepDepth > 0)) throw new ArgumentOutOfRangeException(nameof(keepDepth), "The depth must be positive.");
        _cell = cell;
        _perCell = 1 / cell;
        _rowsOf = new ExtrusionRows(cell);
        _keepDepth = keepDepth;
        _hasCells = hasCells;
        _bins = new DepositBins(cell);
        Contacts = new DepositContacts(_bins, _cells, _store, cell);
        Overlaps = new DepositOverlaps(_bins, _cells, _store, cell);
    }

    /// <summary>Side of a cell, mm.</summary>
    public double Cell => _cell;

    /// <summary>Highest printed point, mm. Negative infinity before the first extrusion.</summary>
    public double Highest { get; private set; } = double.NegativeInfinity;

    /// <summary>What a head and its boxes touch.</summary>
    public DepositContacts Contacts { get; }

    /// <summary>What is in the place of new extrusions.</summary>
    public DepositOverlaps Overlaps { get; }

    /// <summary>Number of extrusions kept for exact answers.</summary>
    public int ExtrusionCount => _store.Count;

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

    /// <summary>
    /// Adds a straight extrusion: the path of the nozzle tip (its top) in mm and half its width in mm. Tags are 0 or more, −1 = none. It is joined if another
    /// extrusion continues downward from its lower end.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite, or the width is negative.</exception>
    public void Add(Vec3 from, Vec3 to, double halfWidth, int tag = -1, bool isJoined = false)
    {
        if (!from.IsFinite || !to.IsFinite) throw new ArgumentOutOfRangeException(nameof(from), "The ends of an extrusion must be finite.");
        if (!(halfWidth >= 0) || double.IsInfinity(halfWidth))
            throw new ArgumentOutOfRangeException(nameof(halfWidth), "The width of an extrusion must be finite and not negative.");
        var extrusion = Extrusion.Of(from, to, halfWidth, tag, isJoined);
        Highest = Math.Max(Highest, extrusion.Top);
        var edge = DepositBins.Most * _bins.Side;
        _last = -1;
        if (IsOutside(from, halfWidth, edge) || IsOutside(to, halfWidth, edge))
        {
            _outside = Math.Max(_outside, extrusion.Top);
            // Only the part inside is drawn into cells.
            double low = 0, high = 1;
            var inside = edge - halfWidth - _cell;
            if (!(inside > 0) || !FlatSegment.Slab(extrusion.Ax, extrusion.Bx - extrusion.Ax, -inside, inside, ref low, ref high)
                || !FlatSegment.Slab(extrusion.Ay, extrusion.By - extrusion.Ay, -inside, inside, ref low, ref high))
            {
                return;
            }
            extrusion = Extrusion.Of(Vec3.Lerp(from, to, low), Vec3.Lerp(from, to, high), halfWidth, tag, isJoined);
            Draw(_store.Add(extrusion), extrusion);
            return;
        }
        Draw(_last = _store.Add(extrusion), extrusion);
    }

    /// <summary>Extends the last extrusion in its line, at the same width, to another end.</summary>
    public void GoOn(Vec3 from, Vec3 to, double halfWidth, int tag, bool isJoined = false)
    {
        if (_last < 0 || IsOutside(to, halfWidth, DepositBins.Most * _bins.Side))
        {
            Add(from, to, halfWidth, tag, isJoined);
            return;
        }
        ref var whole = ref _store[_last];
        (whole.Bx, whole.By, whole.Bz) = (to.X, to.Y, to.Z);
        if (to.Z < from.Z) whole.IsJoined = isJoined;
        Highest = Math.Max(Highest, to.Z);
        Draw(_last, whole with { Ax = from.X, Ay = from.Y, Az = from.Z });
    }

    /// <summary>
    /// Highest top, mm, within <paramref name="radius"/> mm of the line from <paramref name="a"/> to <paramref name="b"/>, seen from above. Negative infinity =
    /// nothing.
    /// </summary>
    public double TopAlong(Vec3 a, Vec3 b, double radius)
    {
        var edge = DepositBins.Most * _bins.Side;
        var best = IsOutside(a, radius, edge) || IsOutside(b, radius, edge) ? _outside : double.NegativeInfinity;
        if (_bins.IsEmpty) return best;
        var side = _bins.Side;
        var halfDiagonal = side * 0.7072;
        var firstRow = _bins.Row(Math.Min(a.Y, b.Y) - radius);
        var lastRow = _bins.Row(Math.Max(a.Y, b.Y) + radius);
        for (var row = firstRow; row <= lastRow; row++)
        {
            var y = row * side;
            if (!FlatSegment.RowSpan(a, b, y - radius, y + side + radius, out var x0, out var x1)) continue;
            var first = _bins.Column(x0 - radius);
            var last = _bins.Column(x1 + radius);
            for (var column = first; column <= last; column++)
            {
                var bin = _bins[column, row];
                if (bin is null || bin.Top <= best) continue;
                var center = new Vec3((column + 0.5) * side, y + side / 2);
                if (FlatSegment.SquareDistance(center, a, b) > (radius + halfDiagonal) * (radius + halfDiagonal)) continue;
                best = TopInBin(bin, a, b, radius, best);
            }
        }
        return best;
    }

    /// <summary>
    /// Highest top, mm, not above <paramref name="limit"/>, within <paramref name="radius"/> mm of a point, seen from above, of extrusions with a tag below
    /// <paramref name="before"/>. A result not above <paramref name="floor"/> = nothing. With <paramref name="least"/>, any top from there on is enough, and a
    /// lower result = nothing.
    /// </summary>
    public double TopUnder(Vec3 point, double limit, double radius = 0, int before = int.MaxValue, double? least = null,
        double floor = double.NegativeInfinity)
        => TopUnder(point, limit, out _, radius, before, least, floor);

    /// <summary>The same with the highest extrusion that was found; dropped ones are none.</summary>
    public double TopUnder(Vec3 point, double limit, out Extrusion? found, double radius = 0, int before = int.MaxValue, double? least = null,
        double floor = double.NegativeInfinity)
    {
        var best = least - Rounding ?? floor;
        found = null;
        if (_bins.IsEmpty || !_bins.MayHold(point.X, point.Y)) return best;
        // A cell is never too low.
        if (radius == 0 && _cells[Index(point.X), Index(point.Y)].Top <= best) return best;
        var (lastRow, lastColumn) = (BinOf(point.Y + radius), BinOf(point.X + radius));
        for (var row = BinOf(point.Y - radius); row <= lastRow; row++)
        {
            for (var column = BinOf(point.X - radius); column <= lastColumn; column++)
            {
                var bin = _bins[column, row];
                if (bin is null || bin.Top <= best) continue;
                best = TopUnderIn(bin, point, limit, radius, before, best, least ?? double.PositiveInfinity, ref found);
                if (best >= least) return best;
                if (bin.Dropped > best) best = DroppedUnder(bin, column, row, point, limit, radius, best);
            }
        }
        return best;
    }

    /// <summary>
    /// The height of the cell under a point, and the next height clearly below it, mm. Negative infinity = nothing. A cell is as high as the highest extrusion
    /// that touches it.
    /// </summary>
    public (double Top, double Under) CellAt(double x, double y)
    {
        if (!_bins.MayHold(x, y)) return (_outside, double.NegativeInfinity);
        var cell = _cells[Index(x), Index(y)];
        return (cell.Top, cell.Under);
    }

    // The last ones are the highest as a rule: the others are skipped by their tops.
    private double TopUnderIn(DepositBin bin, Vec3 point, double limit, double radius, int before, double best, double enough,
        ref Extrusion? found)
    {
        for (var i = bin.Count - 1; i >= 0 && best < enough && !bin.AllBelow(i, best); i--)
        {
            if (!(bin.Entries[i].Top > best) || (bin.Entries[i].IsLevel && bin.Entries[i].Top > limit)) continue;
            ref var extrusion = ref _store[bin.Entries[i].Extrusion];
            if (extrusion.Tag >= before || Math.Min(extrusion.Az, extrusion.Bz) > limit) continue;
            var top = extrusion.TopAt(point, radius);
            if (top <= limit && top > best) (best, found) = (top, extrusion);
        }
        return best;
    }

    private double TopInBin(DepositBin bin, Vec3 a, Vec3 b, double radius, double best)
    {
        for (var i = bin.Count - 1; i >= 0; i--)
        {
            if (bin.Entries[i].Top > best) best = Math.Max(best, _store[bin.Entries[i].Extrusion].TopWithin(a, b, radius));
        }
        return Math.Max(best, bin.Dropped);
    }

    private double DroppedUnder(DepositBin bin, int column, int row, Vec3 point, double limit, double radius, double best)
    {
        var reach = radius + _cell * 0.7072;
        for (var i = 0; i < DepositBin.Cells; i++)
        {
            var top = Math.Min(_cells.InBin(column, row, i).Top, bin.Dropped);
            if (top > best && top <= limit && (DepositCells.Center(column, row, i, _cell) - point).LengthXY <= reach) best = top;
        }
        return best;
    }

    private void Draw(int index, in Extrusion extrusion)
    {
        var rows = _rowsOf;
        rows.Aim(extrusion);
        var (highest, rise) = (extrusion.Top, extrusion.Bz - extrusion.Az);
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
            // Spans of rows above each other touch: there is no bin between the outermost that knows nothing of the extrusion.
            for (var column = left >> DepositBin.Bits; column <= right >> DepositBin.Bits; column++)
            {
                var top = isLevel ? highest : TopInBin(extrusion, column, row >> DepositBin.Bits);
                _bins.Enter(column, row >> DepositBin.Bits, index, top, isLevel, _store, _keepDepth);
            }
            if (!_hasCells) continue;
            if (isLevel) _cells.Lay(_spans, row, end, left, right, highest);
            else LaySloped(extrusion, row, end);
        }
    }

    // Never too low: a long slope must not raise the bins at its foot, whose extrusions would be dropped.
    private double TopInBin(in Extrusion extrusion, int column, int row)
    {
        double dx = extrusion.Bx - extrusion.Ax, dy = extrusion.By - extrusion.Ay;
        var (length, side) = (_rowsOf.Length, _bins.Side);
        var middle = ((column + 0.5) * side - extrusion.Ax) * dx + ((row + 0.5) * side - extrusion.Ay) * dy;
        var reach = (Math.Abs(dx) + Math.Abs(dy)) * side / 2 + (extrusion.Half + _cell) * length;
        var rise = extrusion.Bz - extrusion.Az;
        var highest = (middle + (rise > 0 ? reach : -reach)) / (length * length);
        return extrusion.Az + rise * Math.Min(1, Math.Max(0, highest));
    }

    // Each cell as high as the extrusion is there at most.
    private void LaySloped(in Extrusion extrusion, int row, int end)
    {
        double dx = extrusion.Bx - extrusion.Ax, dy = extrusion.By - extrusion.Ay, inverse = 1 / (dx * dx + dy * dy);
        double low = extrusion.Az, rise = extrusion.Bz - low, highest = extrusion.Top;
        var spread = Math.Abs(rise) / _rowsOf.Length * _cell * 0.7072;
        for (var i = row; i <= end; i++)
        {
            var across = ((i + 0.5) * _cell - extrusion.Ay) * dy;
            var (column, last) = _spans[i - row];
            while (column <= last)
            {
                var tile = _cells.TileOf(column, i);
                for (var stop = Math.Min(last, column | (DepositCells.Wide - 1)); column <= stop; column++)
                {
                    var along = (((column + 0.5) * _cell - extrusion.Ax) * dx + across) * inverse;
                    along = along < 0 ? 0 : along > 1 ? 1 : along;
                    tile[DepositCells.At(column, i)].Lay(Math.Min(highest, low + rise * along + spread));
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Index(double x) => ExtrusionRows.Index(x, _perCell);

    // The column or row of the bin of a place.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int BinOf(double x) => Index(x) >> DepositBin.Bits;

    private static bool IsOutside(Vec3 p, double margin, double edge) => !(Math.Abs(p.X) + margin < edge && Math.Abs(p.Y) + margin < edge);
}
