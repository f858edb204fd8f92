namespace Caterpillar.GCode;

/// <summary>Collects the text of a spliced file. Numbered lines after an inserted or dropped line get new numbers and checksums.</summary>
internal sealed class SplicedText(SplicedOutput output, LineStyle style)
{
    private const int MostOwnBytes = 256 * 1024;
    private readonly ParsedLine _line = new();
    private SplicedChunk _chunk = output.NewChunk();
    private int _shift;
    private double _lastNumber;
    private bool _open;

    /// <summary>True while untouched lines can be copied as they are.</summary>
    public bool IsPlain => _shift == 0;

    /// <summary>Bytes of this text are next, from an index on.</summary>
    public void Begin(byte[] text, int start)
    {
        Flush();
        _chunk.Begin(text, start);
    }

    public void Copy(byte[] text, int start, int end)
    {
        if (end <= start) return;
        _open = text[end - 1] != '\n' && text[end - 1] != '\r';
        _chunk.Add(text, start, end);
        if (_chunk.OwnBytes < MostOwnBytes) return;
        var full = _chunk;
        Flush();
        _chunk.BeginAfter(full);
    }

    /// <summary>Writes a number in units of its last decimal, in place of the bytes of the text up to an index.</summary>
    public void Replace(int end, long units, int decimals) => _chunk.Replace(end, units, decimals);

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
            at += count;
            if (style.Checksums) at = Sum(made, at);
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
        output.Write(_chunk);
        _chunk = output.NewChunk();
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
