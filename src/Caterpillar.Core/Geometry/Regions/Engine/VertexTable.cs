namespace Caterpillar.Geometry;

/// <summary>Numbers grid points in the order of their first appearance; an open-addressing hash table that is reused.</summary>
internal sealed class VertexTable
{
    private int[] _slots = new int[512];
    private int _mask = 511;

    public GridPoint[] Points = new GridPoint[256];

    public int Count { get; private set; }

    public void Clear(int expected)
    {
        var size = 512;
        while (size < 2 * expected) size *= 2;
        if (_slots.Length < size) _slots = new int[size];
        else Array.Clear(_slots, 0, size);
        _mask = size - 1;
        Buffers.Reserve(ref Points, expected);
        Count = 0;
    }

    /// <summary>The number of a point. No more points than were expected may be added.</summary>
    public int Add(int x, int y)
    {
        var hash = unchecked(((uint)x * 0x9E3779B1u) ^ ((uint)y * 0x85EBCA77u));
        hash ^= hash >> 15;
        for (var slot = (int)(hash & (uint)_mask); ; slot = (slot + 1) & _mask)
        {
            var entry = _slots[slot];
            if (entry == 0)
            {
                Points[Count++] = new GridPoint(x, y);
                _slots[slot] = Count;
                return Count - 1;
            }
            var p = Points[entry - 1];
            if (p.X == x && p.Y == y) return entry - 1;
        }
    }
}
