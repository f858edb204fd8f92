namespace Caterpillar.GCode;

/// <summary>Collects the bytes of a spliced file. Numbered lines after an inserted or dropped line get new numbers and checksums.</summary>
internal sealed class SplicedText(Stream stream, LineStyle style)
{
    private readonly byte[] _buffer = new byte[1 << 18];
    private readonly ParsedLine _line = new();
    private int _count;
    private int _shift;
    private double _lastNumber;
    private bool _open;

    /// <summary>True while untouched lines can be copied as they are.</summary>
    public bool IsPlain => _shift == 0;

    public void Copy(byte[] text, int start, int end)
    {
        if (end <= start) return;
        _open = text[end - 1] != '\n' && text[end - 1] != '\r';
        if (end - start > _buffer.Length - _count)
        {
            Flush();
            if (end - start > _buffer.Length)
            {
                stream.Write(text, start, end - start);
                return;
            }
        }
        Buffer.BlockCopy(text, start, _buffer, _count, end - start);
        _count += end - start;
    }

    /// <summary>The buffer, with space for so many bytes from <see cref="Count"/> on. Null if it is too small.</summary>
    public byte[]? Space(int bytes)
    {
        if (bytes > _buffer.Length - _count) Flush();
        return bytes > _buffer.Length ? null : _buffer;
    }

    /// <summary>Bytes that wait in the buffer.</summary>
    public int Count => _count;

    /// <summary>A line with its end was written into the buffer, up to here.</summary>
    public void Wrote(int end)
    {
        _count = end;
        _open = false;
    }

    /// <summary>A line of the file as it is.</summary>
    public void Add(FileLine line)
    {
        if (style.Numbered) Add(line.Text, line.Start, line.End, line);
        else Copy(line.Text, line.Start, line.Next);
    }

    /// <summary>A changed line, with the line end that it had.</summary>
    public void Add(byte[] text, int count, FileLine line) => Add(text, 0, count, line);

    /// <summary>Adds a new line.</summary>
    public void AddOwn(byte[] text, int count)
    {
        CloseLine();
        if (style.Numbered && count > 0 && text[0] != ';')
        {
            _shift++;
            var made = new byte[count + 60];
            var at = WriteNumber(made, _lastNumber + 1);
            made[at++] = (byte)' ';
            Buffer.BlockCopy(text, 0, made, at, count);
            at = Checksum(made, at + count);
            _lastNumber++;
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

    public void Flush()
    {
        stream.Write(_buffer, 0, _count);
        _count = 0;
    }

    private void Add(byte[] text, int start, int end, FileLine line)
    {
        if (style.Numbered) AddNumbered(text, start, end);
        else Copy(text, start, end);
        Copy(line.Text, line.End, line.Next);
    }

    private void AddNumbered(byte[] text, int start, int end)
    {
        _line.Scan(text, start, end);
        if (_line.NumberWordAt < 0)
        {
            Copy(text, start, end);
            return;
        }
        _lastNumber = _line.LineNumber + _shift;
        if (_shift == 0)
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

    private int Checksum(byte[] made, int count) => style.Checksums ? Sum(made, count) : count;

    private static int Sum(byte[] made, int count)
    {
        var sum = 0;
        for (var i = 0; i < count; i++) sum ^= made[i];
        made[count++] = (byte)'*';
        return NumberFormatter.WriteUnits(made, count, sum, 0);
    }
}
