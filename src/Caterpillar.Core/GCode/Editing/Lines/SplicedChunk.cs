namespace Caterpillar.GCode;

/// <summary>A part of a spliced file: a range of the text that was read, with numbers and other bytes in it. It is put together when it is written.</summary>
internal sealed class SplicedChunk
{
    private const int LongestNumber = 24;
    private readonly List<Change> _changes = [];
    private byte[] _own = new byte[4096];
    private byte[] _text = [];
    private int _start;
    private int _end;

    /// <summary>Number of bytes that are not from the text.</summary>
    public int OwnBytes { get; private set; }

    /// <summary>Begins a part of this text, from an index on.</summary>
    public void Begin(byte[] text, int start)
    {
        (_text, _start, _end, OwnBytes) = (text, start, start, 0);
        _changes.Clear();
    }

    /// <summary>Begins the part that follows in the same text.</summary>
    public void BeginAfter(SplicedChunk before) => Begin(before._text, before._end);

    /// <summary>Adds bytes. Those of the text are not copied, and what lies before them is left out.</summary>
    public void Add(byte[] text, int start, int end)
    {
        if (!ReferenceEquals(text, _text) || start < _end)
        {
            var most = OwnBytes + end - start;
            if (most > _own.Length) Array.Resize(ref _own, Math.Max(most, 2 * _own.Length));
            OwnBytes = Copy(text, start, end, _own, OwnBytes);
            _changes.Add(new Change(_end, _end, end - start, -1));
            return;
        }
        if (start > _end) _changes.Add(new Change(_end, start, 0, -1));
        _end = end;
    }

    /// <summary>Puts a number in place of the bytes of the text up to an index.</summary>
    public void Replace(int end, long units, int decimals)
    {
        _changes.Add(new Change(_end, end, units, decimals));
        _end = end;
    }

    /// <summary>Writes the part, with numbers in the style of the file. The buffer grows as needed.</summary>
    [MethodImpl(Compile.Optimized)]
    public void WriteTo(Stream stream, LineStyle style, ref byte[] buffer)
    {
        if (_changes.Count == 0)
        {
            stream.Write(_text, _start, _end - _start);
            return;
        }
        var most = _end - _start + OwnBytes + _changes.Count * LongestNumber;
        if (buffer.Length < most) buffer = new byte[most];
        int at = _start, own = 0, count = 0;
        foreach (var change in _changes)
        {
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

    private static int Copy(byte[] text, int from, int to, byte[] buffer, int count)
    {
        Buffer.BlockCopy(text, from, buffer, count, to - from);
        return count + to - from;
    }

    // The text is kept up to an index and continues at another one. In between is a number, or, with decimals below 0, a number of own bytes.
    private readonly record struct Change(int At, int Next, long Units, int Decimals);
}
