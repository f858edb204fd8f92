namespace Caterpillar.GCode;

/// <summary>
/// Collects the text of a spliced file and writes it in parts, in the background if requested. An error of the stream is thrown where the next part is full, or
/// by <see cref="Finish"/>. Numbered lines after an inserted or dropped line get new numbers and checksums.
/// </summary>
internal sealed class SplicedText(Stream target, LineStyle style, bool hasThread) : IDisposable
{
    private const int PartSize = 256 * 1024;
    private const int LongestNumber = 24;
    private readonly ParsedLine _line = new();
    private byte[] _buffer = new byte[PartSize];
    private int _count;
    private byte[] _other = [];
    private Task _writing = Task.CompletedTask;

    // What comes next of the text that is read, and is not in the buffer yet.
    private byte[] _text = [];
    private int _start;
    private int _end;
    private int _shift;
    private double _lastNumber;
    private bool _open;

    /// <summary>True while untouched lines can be copied as they are.</summary>
    public bool IsPlain => _shift == 0;

    /// <summary>Bytes of this text are next, from an index on. It does not change up to the next call.</summary>
    public void Begin(byte[] text, int start)
    {
        Settle();
        (_text, _start, _end) = (text, start, start);
    }

    public void Copy(byte[] text, int start, int end)
    {
        if (end <= start) return;
        _open = text[end - 1] != '\n' && text[end - 1] != '\r';
        if (!ReferenceEquals(text, _text))
        {
            Settle();
            Append(text, start, end);
            return;
        }
        if (start != _end)
        {
            Settle();
            _start = start;
        }
        _end = end;
    }

    /// <summary>Writes a number in units of its last decimal, in place of the bytes of the text up to an index.</summary>
    public void Replace(int end, long units, int decimals)
    {
        Settle();
        _count = style.WriteUnits(_buffer, _count, units, decimals);
        _start = _end = end;
    }

    /// <summary>A line of the file as it is.</summary>
    public void Add(FileLine line) => Add(line.Text, line.Start, line.End, line);

    /// <summary>A changed line, with the line end that it had.</summary>
    public void Add(byte[] text, int start, int end, FileLine line)
    {
        if (style.Numbered) AddNumbered(text, start, end);
        else Copy(text, start, end);
        Copy(line.Text, line.End, line.Next);
    }

    /// <summary>Adds a new line.</summary>
    public void AddOwn(byte[] text, int count)
    {
        CloseLine();
        if (style.Numbered && count > 0 && text[0] != ';')
        {
            _shift++;
            var made = new byte[count + 60];
            var at = WriteNumber(made, ++_lastNumber);
            made[at++] = (byte)' ';
            Buffer.BlockCopy(text, 0, made, at, count);
            at += count;
            if (style.Checksums) at = Sum(made, at);
            Copy(made, 0, at);
        }
        else
        {
            Copy(text, 0, count);
        }
        Copy(style.LineEnd, 0, style.LineEnd.Length);
    }

    /// <summary>Drops a line of the file.</summary>
    public void Drop(ParsedLine line)
    {
        if (line.NumberWordAt >= 0) _shift--;
    }

    /// <summary>Ends the last line of a file that does not end it.</summary>
    public void CloseLine()
    {
        if (_open) Copy(style.LineEnd, 0, style.LineEnd.Length);
    }

    /// <summary>Writes the last part. Everything is written afterwards.</summary>
    public void Finish()
    {
        Settle();
        WritePart();
        _writing.GetAwaiter().GetResult();
    }

    // Whoever wants to know of its problem has asked before.
    public void Dispose() => OwnThread.Wait(_writing);

    private void Settle()
    {
        Append(_text, _start, _end);
        _start = _end;
    }

    // There is room for a number after them.
    private void Append(byte[] text, int start, int end)
    {
        var length = end - start;
        if (_buffer.Length - _count < length + LongestNumber) WritePart();
        if (_buffer.Length < length + LongestNumber) _buffer = new byte[Math.Max(length + LongestNumber, PartSize)];
        Buffer.BlockCopy(text, start, _buffer, _count, length);
        _count += length;
    }

    // While it is written, the other buffer is filled.
    private void WritePart()
    {
        _writing.GetAwaiter().GetResult();
        var (part, count) = (_buffer, _count);
        if (hasThread) _writing = Task.Run(() => target.Write(part, 0, count));
        else target.Write(part, 0, count);
        (_buffer, _other, _count) = (_other, part, 0);
    }

    private void AddNumbered(byte[] text, int start, int end)
    {
        _line.Scan(text, start, end);
        if (_line.NumberWordAt >= 0) _lastNumber = _line.LineNumber + _shift;
        if (_line.NumberWordAt < 0 || _shift == 0)
        {
            Copy(text, start, end);
            return;
        }
        var made = new byte[end - start + 60];
        var at = _line.NumberWordAt - start;
        Buffer.BlockCopy(text, start, made, 0, at);
        at += WriteNumber(made, _lastNumber, at) - at;
        var stop = _line.ChecksumAt >= 0 ? _line.ChecksumAt : end;
        Buffer.BlockCopy(text, _line.NumberWordEnd, made, at, stop - _line.NumberWordEnd);
        at += stop - _line.NumberWordEnd;
        if (_line.ChecksumAt >= 0)
        {
            at = Sum(made, at);
            stop++;
            while (stop < end && (uint)(text[stop] - '0') <= 9) stop++;
        }
        Buffer.BlockCopy(text, stop, made, at, end - stop);
        Copy(made, 0, at + end - stop);
    }

    private static int WriteNumber(byte[] made, double number, int at = 0)
    {
        made[at++] = (byte)'N';
        return NumberFormatter.WriteUnits(made, at, number is > -1e15 and < 1e15 ? (long)number : 0, 0);
    }

    /// <summary>Adds the checksum of these bytes after them, and returns the index after it.</summary>
    public static int Sum(byte[] made, int count)
    {
        var sum = 0;
        for (var i = 0; i < count; i++) sum ^= made[i];
        made[count++] = (byte)'*';
        return NumberFormatter.WriteUnits(made, count, sum, 0);
    }
}
