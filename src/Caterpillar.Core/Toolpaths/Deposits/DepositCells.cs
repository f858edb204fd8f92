namespace Caterpillar.Toolpaths;

/// <summary>
/// The height field of a <see cref="Deposit"/>: square cells by column and row, in tiles that are created under extrusions. A tile is eight bins wide and one
/// high, so that rows of cells are seldom cut.
/// </summary>
internal sealed class DepositCells
{
    private const int ColumnBits = 6;
    private const int RowBits = DepositBin.Bits;

    // Columns of a tile.
    public const int Wide = 1 << ColumnBits;
    private static readonly DepositCell[] Empty = NewEmpty();

    // Far more tiles than bins can have.
    private GrowingGrid<DepositCell[]> _tiles = new(1, 4, 1 << 20);

    /// <summary>A cell. Empty if no extrusion is near it.</summary>
    public DepositCell this[int column, int row] => Find(column, row) is { } tile ? tile[At(column, row)] : Empty[0];

    /// <summary>The tile of a cell, or null.</summary>
    public DepositCell[]? Find(int column, int row) => _tiles.Find(column >> ColumnBits, row >> RowBits);

    /// <summary>A cell of a bin, by its number there.</summary>
    public DepositCell InBin(int column, int row, int cell)
        => this[(column << DepositBin.Bits) + (cell & (DepositBin.Side - 1)), (row << DepositBin.Bits) + (cell >> DepositBin.Bits)];

    /// <summary>The middle of a cell of a bin, for cells with a side in mm.</summary>
    public static Vec3 Center(int column, int row, int cell, double side) => new(
        ((column << DepositBin.Bits) + (cell & (DepositBin.Side - 1)) + 0.5) * side, ((row << DepositBin.Bits) + (cell >> DepositBin.Bits) + 0.5) * side);

    /// <summary>Index of a cell in its tile. The next cells are to its right.</summary>
    public static int At(int column, int row) => ((row & (DepositBin.Side - 1)) << ColumnBits) | (column & (Wide - 1));

    /// <summary>The tile of a cell, a new one if there is none.</summary>
    public DepositCell[] TileOf(int column, int row) => Find(column, row) ?? Make(column, row);

    /// <summary>Adds a height to spans of rows of one tile, between two columns.</summary>
    public void Lay((int First, int Last)[] spans, int row, int end, int left, int right, double top)
    {
        for (var from = left; from <= right; from = (from | (Wide - 1)) + 1)
        {
            var tile = TileOf(from, row);
            int first = from & ~(Wide - 1), last = first + Wide - 1;
            for (var i = row; i <= end; i++)
            {
                var at = ((i & (DepositBin.Side - 1)) << ColumnBits) - first;
                var to = at + Math.Min(spans[i - row].Last, last);
                for (at += Math.Max(spans[i - row].First, first); at <= to; at++) tile[at].Lay(top);
            }
        }
    }

    private DepositCell[] Make(int column, int row)
    {
        var tile = (DepositCell[])Empty.Clone();
        _tiles.Put(column >> ColumnBits, row >> RowBits, tile);
        return tile;
    }

    private static DepositCell[] NewEmpty()
    {
        var cells = new DepositCell[Wide * DepositBin.Side];
        for (var i = 0; i < cells.Length; i++) cells[i].Top = cells[i].Under = double.NegativeInfinity;
        return cells;
    }
}
