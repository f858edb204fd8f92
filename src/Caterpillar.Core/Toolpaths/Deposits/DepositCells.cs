using System;

namespace Caterpillar.Toolpaths;

/// <summary>
/// The height field of a <see cref="Deposit"/>: square cells by column and row, in tiles that are made where something is printed. A tile is eight bins wide
/// and one high, so that a row of cells is seldom cut.
/// </summary>
internal sealed class DepositCells
{
    private const int ColumnBits = 6;
    private const int RowBits = DepositBin.Bits;

    // Columns of a tile.
    public const int Wide = 1 << ColumnBits;
    private static readonly DepositCell[] Empty = NewEmpty();
    private DepositCell[]?[] _tiles = [];
    private int _left, _bottom, _columns, _rows;

    /// <summary>A cell as it is; empty where nothing was ever laid near it.</summary>
    public DepositCell this[int column, int row] => Find(column, row) is { } tile ? tile[At(column, row)] : Empty[0];

    /// <summary>The tile of a cell; null where there is none.</summary>
    public DepositCell[]? Find(int column, int row)
    {
        int x = (column >> ColumnBits) - _left, y = (row >> RowBits) - _bottom;
        return (uint)x < (uint)_columns && (uint)y < (uint)_rows ? _tiles[y * _columns + x] : null;
    }

    /// <summary>The place of a cell in its tile; the next ones are to the right of it.</summary>
    public static int At(int column, int row) => ((row & (DepositBin.Side - 1)) << ColumnBits) | (column & (Wide - 1));

    /// <summary>Lays a height in mm into a cell.</summary>
    public void Lay(int column, int row, double top) => (Find(column, row) ?? Make(column, row))[At(column, row)].Lay(top);

    /// <summary>Lays a height into spans of rows of one tile, which are all between two columns.</summary>
    public void Lay((int First, int Last)[] spans, int row, int end, int left, int right, double top)
    {
        for (var from = left; from <= right; from = (from | (Wide - 1)) + 1)
        {
            var tile = Find(from, row) ?? Make(from, row);
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
        (column, row) = (column >> ColumnBits, row >> RowBits);
        if (column < _left || row < _bottom || column >= _left + _columns || row >= _bottom + _rows) GrowTo(column, row);
        return _tiles[(row - _bottom) * _columns + column - _left] = (DepositCell[])Empty.Clone();
    }

    // By half on the side that was exceeded, so that growing costs little overall.
    private void GrowTo(int column, int row)
    {
        int across = _tiles.Length == 0 ? 1 : _columns / 2 + 1, up = _tiles.Length == 0 ? 4 : _rows / 2 + 1;
        int left = column - across, right = column + across, bottom = row - up, top = row + up;
        if (_tiles.Length > 0)
        {
            if (column >= _left) left = _left;
            if (column < _left + _columns) right = _left + _columns - 1;
            if (row >= _bottom) bottom = _bottom;
            if (row < _bottom + _rows) top = _bottom + _rows - 1;
        }
        var tiles = new DepositCell[]?[(right - left + 1) * (top - bottom + 1)];
        for (var y = 0; y < _rows; y++) Array.Copy(_tiles, y * _columns, tiles, (y + _bottom - bottom) * (right - left + 1) + _left - left, _columns);
        (_tiles, _left, _bottom, _columns, _rows) = (tiles, left, bottom, right - left + 1, top - bottom + 1);
    }

    private static DepositCell[] NewEmpty()
    {
        var cells = new DepositCell[Wide * DepositBin.Side];
        for (var i = 0; i < cells.Length; i++) cells[i].Top = cells[i].Under = double.NegativeInfinity;
        return cells;
    }
}
