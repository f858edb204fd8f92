namespace Caterpillar.Geometry;

/// <summary>
/// Gives equal points one number, in the order of their first appearance: an open-addressing hash over the bits of the coordinates, −0.0 taken as 0.0.
/// </summary>
internal sealed class VertexWelder
{
    private int[] _slots;
    private int _shift;
    private Vec3[] _points;

    public VertexWelder(int expectedVertices)
    {
        var bits = 8;
        while (bits < 28 && 1L << bits < 2L * expectedVertices) bits++;
        _slots = new int[1 << bits];
        _shift = 64 - bits;
        _points = new Vec3[Math.Max(16, expectedVertices)];
    }

    public int Count { get; private set; }

    /// <summary>The number of the point with these coordinates, new or known.</summary>
    public int Add(double x, double y, double z)
    {
        // Turns −0.0 into 0.0.
        x += 0.0;
        y += 0.0;
        z += 0.0;
        return Add(x, y, z, Hash(x, y, z));
    }

    /// <summary>The same with a known hash. −0.0 must be 0.0.</summary>
    public int Add(double x, double y, double z, ulong hash)
    {
        var mask = _slots.Length - 1;
        var slot = (int)(hash >> _shift);
        for (; _slots[slot] != 0; slot = (slot + 1) & mask)
        {
            ref readonly var known = ref _points[_slots[slot] - 1];
            if (known.X == x && known.Y == y && known.Z == z) return _slots[slot] - 1;
        }
        if (Count == _points.Length) Array.Resize(ref _points, Count * 2);
        _points[Count] = new Vec3(x, y, z);
        _slots[slot] = ++Count;
        if (Count * 2L > _slots.Length) Grow();
        return Count - 1;
    }

    /// <summary>The points by number, in an array of exactly that length.</summary>
    public Vec3[] ToArray()
    {
        if (_points.Length != Count) Array.Resize(ref _points, Count);
        return _points;
    }

    /// <summary>A hash of all coordinates, equal for equal points. −0.0 must be 0.0.</summary>
    public static ulong Hash(double x, double y, double z)
    {
        unchecked
        {
            var h = (ulong)BitConverter.DoubleToInt64Bits(x) * 0x9E3779B97F4A7C15UL;
            h ^= h >> 32;
            h = (h + (ulong)BitConverter.DoubleToInt64Bits(y)) * 0xD6E8FEB86659FD93UL;
            h ^= h >> 32;
            h = (h + (ulong)BitConverter.DoubleToInt64Bits(z)) * 0xA0761D6478BD642FUL;
            h ^= h >> 32;
            return h * 0xE7037ED1A0B428DBUL;
        }
    }

    private void Grow()
    {
        if (_slots.Length >= 1 << 30) return;
        _slots = new int[_slots.Length * 2];
        _shift--;
        var mask = _slots.Length - 1;
        for (var i = 0; i < Count; i++)
        {
            ref readonly var p = ref _points[i];
            var slot = (int)(Hash(p.X, p.Y, p.Z) >> _shift);
            while (_slots[slot] != 0) slot = (slot + 1) & mask;
            _slots[slot] = i + 1;
        }
    }
}
