namespace Caterpillar.Toolpaths;

/// <summary>
/// The square cells under an extrusion, seen from above. In each row, the extrusion (wider by half a diagonal) covers a span between its sides or the ends of
/// its discs. Rows away from both ends have the same span, moved along the extrusion. Reused for one extrusion after another.
/// </summary>
/// <param name="cell">Side of a cell, mm.</param>
internal sealed class ExtrusionRows(double cell)
{
    private readonly double _perCell = 1 / cell;
    private double _ax, _ay, _half, _inverse;

    // The extrusion goes up; seen from the front or from the back (then turned), so that it goes to the right.
    private double _x, _y, _dx, _dy, _turn, _reach, _perY, _slope, _lead, _width;
    private int _firstMiddle, _lastMiddle;

    /// <summary>Length of the extrusion seen from above, mm.</summary>
    public double Length { get; private set; }

    /// <summary>Number of its first row.</summary>
    public int First { get; private set; }

    /// <summary>Number of its last row.</summary>
    public int Last { get; private set; }

    /// <summary>Switches to another extrusion.</summary>
    public void Aim(in Extrusion extrusion)
    {
        (_ax, _ay, _half) = (extrusion.Ax, extrusion.Ay, extrusion.Half);
        double dx = extrusion.Bx - _ax, dy = extrusion.By - _ay;
        var goesUp = dy > 0 || dy == 0 && dx >= 0;
        (_x, _y) = goesUp ? (_ax, _ay) : (extrusion.Bx, extrusion.By);
        _turn = dx >= 0 == goesUp ? 1 : -1;
        (_dx, _dy) = (Math.Abs(dx), Math.Abs(dy));
        _reach = _half + cell * 0.7072;
        var square = dx * dx + dy * dy;
        _inverse = square > 0 ? 1 / square : 0;
        Length = Math.Sqrt(square);
        First = Index(_y - _half, _perCell);
        Last = Index(_y + _dy + _half, _perCell);
        (_firstMiddle, _lastMiddle) = (0, -1);
        // Level ones have their discs in all rows.
        (_lead, _perY, _slope) = (2, 0, 0);
        if (_dy == 0) return;
        _perY = 1 / _dy;
        _slope = _dx * _perY;
        var side = _reach * Length * _perY;
        _lead = side * _dx * _inverse;
        var across = _half + cell / 2;
        // What its ends may change, along y.
        var ends = Math.Max(across, _lead * _dy);
        if (!(_dy > 2 * ends + cell)) return;
        _width = Math.Min(_half + across * _slope, side - cell / 2);
        _firstMiddle = Index(_y + ends + cell / 2, _perCell);
        _lastMiddle = Index(_y + _dy - ends - cell / 2, _perCell);
    }

    /// <summary>A number of cells, rounded down.</summary>
    // Plain comparisons: this, and the drawing of extrusions, is most of what a check costs.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Index(double x, double perCell)
    {
        var cells = x * perCell;
        var index = (int)cells;
        return cells < index ? index - 1 : index;
    }

    /// <summary>The first and last column that it covers in a row. If the last is before the first, it covers none.</summary>
    public void Span(int row, out int first, out int last)
    {
        var y = (row + 0.5) * cell - _y;
        if (row >= _firstMiddle && row <= _lastMiddle)
        {
            var middle = _x + _turn * y * _slope;
            first = Index(middle - _width, _perCell);
            last = Index(middle + _width, _perCell);
            return;
        }
        // The part of the axis that may reach the row, with its discs.
        var across = _half + cell / 2;
        var left = _dx * Math.Max(0, (y - across) * _perY) - _half;
        var right = _dx * Math.Min(1, _perY == 0 ? 1 : (y + across) * _perY) + _half;
        // Where the sides of the wider extrusion cross the row, or the discs at its ends.
        double at = y * _perY, from = Math.Min(1, Math.Max(0, at - _lead)), to = Math.Min(1, Math.Max(0, at + _lead));
        double down = y - from * _dy, up = y - to * _dy, square = _reach * _reach;
        double low = from * _dx - Math.Sqrt(square - down * down) + cell / 2, high = to * _dx + Math.Sqrt(square - up * up) - cell / 2;
        (left, right) = (Math.Max(left, low), Math.Min(right, high));
        if (!(left <= right + cell))
        {
            (first, last) = (0, -1);
            return;
        }
        if (_turn < 0) (left, right) = (-right, -left);
        first = Index(_x + left, _perCell);
        last = Index(_x + right, _perCell);
    }
}
