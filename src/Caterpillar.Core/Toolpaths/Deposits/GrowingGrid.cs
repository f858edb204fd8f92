namespace Caterpillar.Toolpaths;

/// <summary>Objects by column and row, in an array that grows as needed.</summary>
/// <param name="margin">Columns on each side of the first object.</param>
/// <param name="rowMargin">Rows on each side of it.</param>
/// <param name="most">Maximum number of columns and rows on each side of the origin.</param>
internal struct GrowingGrid<T>(int margin, int rowMargin, int most)
    where T : class
{
    private T?[] _items = [];

    public int Left { get; private set; }

    public int Bottom { get; private set; }

    public int Columns { get; private set; }

    public int Rows { get; private set; }

    public readonly bool IsEmpty => Columns == 0;

    /// <summary>The object of a place, or null.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly T? Find(int column, int row)
    {
        int x = column - Left, y = row - Bottom;
        return (uint)x < (uint)Columns && (uint)y < (uint)Rows ? _items[y * Columns + x] : null;
    }

    /// <summary>Puts an object in its place. True if the grid had to grow.</summary>
    public bool Put(int column, int row, T item)
    {
        var grows = column < Left || row < Bottom || column >= Left + Columns || row >= Bottom + Rows;
        if (grows) GrowTo(column, row);
        _items[(row - Bottom) * Columns + column - Left] = item;
        return grows;
    }

    // By half on the side that was exceeded, so that growing costs little overall.
    private void GrowTo(int column, int row)
    {
        int across = IsEmpty ? margin : Columns / 2 + 1, up = IsEmpty ? rowMargin : Rows / 2 + 1;
        var left = !IsEmpty && column >= Left ? Left : Math.Max(column - across, -most - 1);
        var right = !IsEmpty && column < Left + Columns ? Left + Columns - 1 : Math.Min(column + across, most);
        var bottom = !IsEmpty && row >= Bottom ? Bottom : Math.Max(row - up, -most - 1);
        var top = !IsEmpty && row < Bottom + Rows ? Bottom + Rows - 1 : Math.Min(row + up, most);
        var items = new T?[(right - left + 1) * (top - bottom + 1)];
        for (var y = 0; y < Rows; y++) Array.Copy(_items, y * Columns, items, (y + Bottom - bottom) * (right - left + 1) + Left - left, Columns);
        (_items, Left, Bottom, Columns, Rows) = (items, left, bottom, right - left + 1, top - bottom + 1);
    }
}
