namespace Caterpillar.Toolpaths;

/// <summary>
/// The bins of a <see cref="Deposit"/> by column and row, and the highest top of each square of 8 × 8 bins, so that low squares are skipped at once.
/// </summary>
/// <param name="cell">Side of a cell, mm.</param>
internal sealed class DepositBins(double cell)
{
    /// <summary>Bins on each side of the origin: 2 m with the usual cell. Everything farther out has one height.</summary>
    public const int Most = 1024;

    private const int SquareBits = 3;
    private GrowingGrid<DepositBin> _bins = new(4, 4, Most);
    private double[] _tops = [];
    private int _topsLeft, _topsBottom, _topsColumns;

    /// <summary>Side of a bin, mm.</summary>
    public double Side { get; } = DepositBin.Side * cell;

    /// <summary>Side of a square of bins, mm.</summary>
    public double SquareSide => Side * (1 << SquareBits);

    public bool IsEmpty => _bins.IsEmpty;

    /// <summary>The highest top of all, mm.</summary>
    public double Highest { get; private set; } = double.NegativeInfinity;

    public DepositBin? this[int column, int row] => _bins.Find(column, row);

    /// <summary>The column of a place, or the nearest column of the grid.</summary>
    public int Column(double x) => Clamp(x, _bins.Left, _bins.Columns);

    /// <summary>The row of a place, or the nearest row of the grid.</summary>
    public int Row(double y) => Clamp(y, _bins.Bottom, _bins.Rows);

    /// <summary>True for places that may have a bin.</summary>
    public bool MayHold(double x, double y) => Math.Abs(x) < Most * Side && Math.Abs(y) < Most * Side;

    /// <summary>The column (or row) of the square of a bin.</summary>
    public static int SquareOf(int bin) => bin >> SquareBits;

    /// <summary>The first and the last bin of a square along one axis.</summary>
    public static (int First, int Last) InSquare(int square) => (square << SquareBits, (square << SquareBits) + (1 << SquareBits) - 1);

    /// <summary>The highest top in a square, mm.</summary>
    public double TopOf(int squareColumn, int squareRow) => _tops[(squareRow - _topsBottom) * _topsColumns + squareColumn - _topsLeft];

    /// <summary>Adds an extrusion to a bin in which it is up to <paramref name="top"/> mm high.</summary>
    public void Enter(int column, int row, int extrusion, double top, bool isLevel, ExtrusionStore store, double keepDepth)
    {
        var bin = _bins.Find(column, row);
        if (bin is null)
        {
            bin = new DepositBin();
            if (_bins.Put(column, row, bin)) GrowTops();
        }
        bin.Add(extrusion, top, isLevel, store, keepDepth);
        if (top > bin.Top) Raise(bin, column, row, top);
    }

    private int Clamp(double at, int first, int count) => (int)Math.Min(Math.Max(Math.Floor(at / Side), first), first + count - 1);

    private void Raise(DepositBin bin, int column, int row, double top)
    {
        bin.Top = top;
        Highest = Math.Max(Highest, top);
        ref var wide = ref _tops[(SquareOf(row) - _topsBottom) * _topsColumns + SquareOf(column) - _topsLeft];
        if (top > wide) wide = top;
    }

    private void GrowTops()
    {
        int left = _bins.Left, bottom = _bins.Bottom, right = left + _bins.Columns, top = bottom + _bins.Rows;
        (_topsLeft, _topsBottom) = (SquareOf(left), SquareOf(bottom));
        _topsColumns = SquareOf(right - 1) - _topsLeft + 1;
        _tops = new double[_topsColumns * (SquareOf(top - 1) - _topsBottom + 1)];
        for (var i = 0; i < _tops.Length; i++) _tops[i] = double.NegativeInfinity;
        for (var row = bottom; row < top; row++)
        {
            for (var column = left; column < right; column++)
            {
                if (_bins.Find(column, row) is { } bin) Raise(bin, column, row, bin.Top);
            }
        }
    }
}
