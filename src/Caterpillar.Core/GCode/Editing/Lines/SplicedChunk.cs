namespace Caterpillar.GCode;

/// <summary>A part of a spliced file: a range of the text that was read, with numbers and other bytes in it. It is put together when it is written.</summary>
internal sealed class SplicedChunk
{
    private const int LongestNumber = 24;
    private Change[] _changes = new Change[1024];
    private byte[] _own = new byte[4096];
    private byte[] _text = [];
    private int _start;
    private int _end;
    private int _count;

    /// <summary>Bytes that are not of the text.</summary>
    public int OwnBytes { get; private set; }

    /// <summary>Begins a part of this text, from an index on.</summary>
    public void Begin(byte[] text, int start) => (_text, _start, _end, _count, OwnBytes) = (text, start, start, 0, 0);

    /// <summary>The part that follows in the same text.</summary>
    public void BeginAfter(SplicedChunk before) => Begin(before._text, before._end);

    /// <summary>Adds bytes. Those of the text are not copied, and what lies before them is left out.</summary>
    public void Add(byte[] text, int start, int end)
    {
        if (ReferenceEquals(text, _text) && start >= _end)
        {
            if (start > _end) Put(_end, start, 0, -1);
            _end = end;
            return;
        }
        var length = end - start;
        if (length > _own.Length - OwnBytes) Array.Resize(ref _own, Math.Max(_own.Length * 2, OwnBytes + length));
        Buffer.BlockCopy(text, start, _own, OwnBytes, length);
        OwnBytes += length;
        if (_count > 0 && _changes[_count - 1] is { Decimals: < 0 } last && last.Next == _end) _changes[_count - 1].Units += length;
        else Put(_end, _end, length, -1);
    }

    /// <summary>Puts a number in place of the bytes of the text up to an index.</summary>
    public void Replace(int end, long units, int decimals)
    {
        Put(_end, end, units, decimals);
        _end = end;
    }

    /// <summary>Writes all of it, with numbers in the style of the file.</summary>
    /// <param name="stream">The output.</param>
    /// <param name="style">The style of numbers.</param>
    /// <param name="buffer">A buffer, which grows.</param>
    [MethodImpl(Compile.Optimized)]
    public void WriteTo(Stream stream, LineStyle style, ref byte[] buffer)
    {
        if (_count == 0)
        {
            stream.Write(_text, _start, _end - _start);
            return;
        }
        var most = _end - _start + OwnBytes + _count * LongestNumber;
        if (buffer.Length < most) buffer = new byte[most];
        int at = _start, own = 0, count = 0;
        for (var i = 0; i < _count; i++)
        {
            ref var change = ref _changes[i];
            count = Copy(_text, at, change.At, buffer, count);
            at = change.Next;
            if (change.Decimals >= 0)
            {
                count = style.WriteUnits(buffer, count, change.Units, change.Decimals);
                continue;
            }
            count = Copy(_own, own, own + (int)change.Units, buffer, count);
            own += (int)change.Units;
        }
        stream.Write(buffer, 0, Copy(_text, at, _end, buffer, count));
    }

    private void Put(int at, int next, long units, int decimals)
    {
        if (_count == _changes.Length) Array.Resize(ref _changes, _count * 2);
        ref var change = ref _changes[_count++];
        (change.At, change.Next, change.Units, change.Decimals) = (at, next, units, decimals);
    }

    private static int Copy(byte[] text, int from, int to, byte[] buffer, int count)
    {
        Buffer.BlockCopy(text, from, buffer, count, to - from);
        return count + to - from;
    }

    // The text is kept up to an index and continues at another one. In between is a number, or, with decimals below 0, a number of own bytes.
    private struct Change
    {
        public int At;
        public int Next;
        public int Decimals;
        public long Units;
    }
}
