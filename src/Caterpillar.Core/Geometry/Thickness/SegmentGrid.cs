namespace Caterpillar.Geometry;

/// <summary>
/// The edges of a region's contours in the cells of an even grid, for questions about what is near. Inside is left of every edge. Coordinates in mm.
/// </summary>
internal sealed class SegmentGrid
{
    /// <summary>Contour c has the edges from ContourStart[c] up to ContourStart[c + 1].</summary>
    public int[] ContourStart = [];

    /// <summary>Edge i goes from Points[i] to Points[Next[i]].</summary>
    public Vec3[] Points = [];
    public int[] Next = [];
    public int[] Previous = [];
    public int[] Contour = [];

    /// <summary>Unit normals, to the inside.</summary>
    public Vec3[] Normal = [];
    public double[] Length = [];

    private double _cell;
    private double _minX;
    private double _minY;
    private int _columns;
    private int _rows;
    private int[] _cellStart = [];
    private int[] _cellItems = [];
    private int[] _stamp = [];
    private int _now;

    public int Contours { get; private set; }

    /// <summary>Number of edges.</summary>
    public int Count { get; private set; }

    /// <summary>Takes the contours of a region instead of those before; the arrays are used again, and may be longer.</summary>
    /// <param name="paths">Contours on the grid of regions.</param>
    /// <param name="within">Edges out of this box (mm) are left out of the cells.</param>
    /// <param name="cell">Size of a cell, mm.</param>
    public void Take(GridPoint[][] paths, Bounds within, double cell)
    {
        Contours = paths.Length;
        Buffers.Reserve(ref ContourStart, Contours + 1);
        for (var c = 0; c < Contours; c++) ContourStart[c + 1] = ContourStart[c] + paths[c].Length;
        var n = Count = ContourStart[Contours];
        Buffers.Reserve(ref Points, n);
        Buffers.Reserve(ref Next, n);
        Buffers.Reserve(ref Previous, n);
        Buffers.Reserve(ref Contour, n);
        Buffers.Reserve(ref Normal, n);
        Buffers.Reserve(ref Length, n);
        Buffers.Reserve(ref _stamp, n);
        for (var c = 0; c < paths.Length; c++)
        {
            int start = ContourStart[c], end = ContourStart[c + 1];
            for (var i = start; i < end; i++)
            {
                Points[i] = Grid.ToMm(paths[c][i - start]);
                Next[i] = i + 1 == end ? start : i + 1;
                Previous[i] = i == start ? end - 1 : i - 1;
                Contour[i] = c;
            }
        }
        for (var i = 0; i < n; i++)
        {
            var d = Points[Next[i]] - Points[i];
            Length[i] = d.LengthXY;
            Normal[i] = Length[i] > 0 ? new Vec3(-d.Y / Length[i], d.X / Length[i]) : Vec3.Zero;
        }
        _minX = within.Min.X;
        _minY = within.Min.Y;
        // However large the box, the cells stay in proportion to the edges.
        _cell = Math.Max(cell, Math.Sqrt(within.Size.X * within.Size.Y / (16.0 * n + 1024)));
        _columns = Math.Max(1, (int)(within.Size.X / _cell) + 1);
        _rows = Math.Max(1, (int)(within.Size.Y / _cell) + 1);
        var cells = _columns * _rows;
        Buffers.Reserve(ref _cellStart, cells + 1);
        Array.Clear(_cellStart, 0, cells + 1);
        for (var i = 0; i < n; i++) EachCell(i, 0);
        for (var c = 0; c < cells; c++) _cellStart[c + 1] += _cellStart[c];
        Buffers.Reserve(ref _cellItems, _cellStart[cells]);
        for (var i = 0; i < n; i++) EachCell(i, 1);
        // Filling moved every start to the end of its cell, which is the start of the next.
        Array.Copy(_cellStart, 0, _cellStart, 1, cells);
        _cellStart[0] = 0;
    }

    /// <summary>The edges whose cells a box meets, each once, in order of cells.</summary>
    public void Near(double minX, double minY, double maxX, double maxY, List<int> found)
    {
        found.Clear();
        _now++;
        int c0 = Column(minX), c1 = Column(maxX), r0 = Row(minY), r1 = Row(maxY);
        for (var r = r0; r <= r1; r++)
        {
            for (var c = c0; c <= c1; c++)
            {
                var cell = r * _columns + c;
                for (var k = _cellStart[cell]; k < _cellStart[cell + 1]; k++)
                {
                    var item = _cellItems[k];
                    if (_stamp[item] == _now) continue;
                    _stamp[item] = _now;
                    found.Add(item);
                }
            }
        }
    }

    // First pass: counts. Second pass: fills backward from the starts of the next cells.
    private void EachCell(int i, int pass)
    {
        Vec3 a = Points[i], b = Points[Next[i]];
        double x0 = Math.Min(a.X, b.X), x1 = Math.Max(a.X, b.X), y0 = Math.Min(a.Y, b.Y), y1 = Math.Max(a.Y, b.Y);
        if (x1 < _minX || y1 < _minY || x0 > _minX + _columns * _cell || y0 > _minY + _rows * _cell) return;
        int c0 = Column(x0), c1 = Column(x1), r0 = Row(y0), r1 = Row(y1);
        for (var r = r0; r <= r1; r++)
        {
            for (var c = c0; c <= c1; c++)
            {
                if (c1 > c0 && r1 > r0 && !Meets(a, i, c, r)) continue;
                if (pass == 0) _cellStart[r * _columns + c + 1]++;
                else _cellItems[_cellStart[r * _columns + c]++] = i;
            }
        }
    }

    // Whether the line of an edge goes through a cell.
    private bool Meets(Vec3 a, int i, int column, int row)
    {
        var n = Normal[i];
        var x = _minX + (column + 0.5) * _cell - a.X;
        var y = _minY + (row + 0.5) * _cell - a.Y;
        return Math.Abs(n.X * x + n.Y * y) <= 0.51 * _cell * (Math.Abs(n.X) + Math.Abs(n.Y)) + 1e-9;
    }

    private int Column(double x) => (int)Math.Min(Math.Max((x - _minX) / _cell, 0), _columns - 1);

    private int Row(double y) => (int)Math.Min(Math.Max((y - _minY) / _cell, 0), _rows - 1);
}
