namespace Caterpillar.Geometry;

/// <summary>Brings many contours into the order of a space-filling curve (Morton), so that neighbors in the box tree are neighbors in space.</summary>
internal sealed class ContourOrder
{
    private Segment[] _segments = new Segment[256];
    private int[] _start = new int[16];
    private byte[] _operand = new byte[16];
    private int[] _source = new int[16];
    private long[] _keys = new long[16];
    private int[] _order = new int[16];

    public void Apply(ref Segment[] segments, ref int[] start, ref byte[] operand, ref int[] source, int contours)
    {
        Buffers.Reserve(ref _keys, contours);
        Buffers.Reserve(ref _order, contours);
        if (_start.Length < start.Length) _start = new int[start.Length];
        if (_operand.Length < operand.Length) _operand = new byte[operand.Length];
        if (_source.Length < source.Length) _source = new int[source.Length];
        if (_segments.Length < segments.Length) _segments = new Segment[segments.Length];
        for (var c = 0; c < contours; c++)
        {
            var box = GridBox.Nothing;
            for (var i = start[c]; i < start[c + 1]; i++) box.Include(segments[i].Ax, segments[i].Ay);
            _order[c] = c;
            _keys[c] = Morton(box);
        }
        Array.Sort(_keys, _order, 0, contours);
        // Equal keys in the order of the input: the sort is not stable.
        for (var c = 0; c < contours;)
        {
            var end = c + 1;
            while (end < contours && _keys[end] == _keys[c]) end++;
            if (end > c + 1) Array.Sort(_order, c, end - c);
            c = end;
        }
        var n = 0;
        _start[0] = 0;
        for (var c = 0; c < contours; c++)
        {
            var from = _order[c];
            var count = start[from + 1] - start[from];
            Array.Copy(segments, start[from], _segments, n, count);
            n += count;
            _start[c + 1] = n;
            _operand[c] = operand[from];
            _source[c] = source[from];
        }
        (segments, _segments) = (_segments, segments);
        (start, _start) = (_start, start);
        (operand, _operand) = (_operand, operand);
        (source, _source) = (_source, source);
    }

    private static long Morton(in GridBox box)
    {
        var x = (uint)((((long)box.MinX + box.MaxX) >> 1) + Grid.Limit * 2L) >> 16;
        var y = (uint)((((long)box.MinY + box.MaxY) >> 1) + Grid.Limit * 2L) >> 16;
        var key = 0L;
        for (var bit = 0; bit < 16; bit++) key |= ((long)((x >> bit) & 1) << (2 * bit)) | ((long)((y >> bit) & 1) << (2 * bit + 1));
        return key;
    }
}
