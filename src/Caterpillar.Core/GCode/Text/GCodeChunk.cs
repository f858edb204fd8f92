namespace Caterpillar.GCode;

/// <summary>A part of a document that ends after a line end (or with the file). The buffer is shared and never changed.</summary>
internal sealed class GCodeChunk
{
    /// <summary>Bytes of a chunk. Longer lines make it longer.</summary>
    public const int Target = 256 * 1024;

    private readonly byte[]? _text;
    private readonly Page<byte[]>? _page;
    private int[]? _lineStarts;

    public GCodeChunk(byte[] text, int start, int end) => (_text, Start, End) = (text, start, end);

    private GCodeChunk(Page<byte[]> page, int start, int end) => (_page, Start, End) = (page, start, end);

    public byte[] Text => _text ?? _page!.Value;

    public int Start { get; }

    public int End { get; }

    public int Length => End - Start;

    /// <summary>The same chunk, whose text a file keeps. It has the text for itself.</summary>
    public GCodeChunk In(PageFile<byte[]> file) => new(file.Add(Text), Start, End);

    public void WriteTo(Stream stream) => stream.Write(Text, Start, Length);

    /// <summary>Cuts bytes into chunks after line ends.</summary>
    public static void Cut(byte[] bytes, int count, List<GCodeChunk> chunks)
    {
        for (var start = 0; start < count;)
        {
            var end = count - start <= Target ? count : LineEnds.Next(bytes, start + Target, count);
            chunks.Add(new GCodeChunk(bytes, start, end));
            start = end;
        }
    }

    /// <summary>Start of each line, and the end of the chunk.</summary>
    public int[] LineStarts()
    {
        var known = Volatile.Read(ref _lineStarts);
        if (known is not null) return known;
        var starts = new int[64];
        var count = 0;
        for (var at = Start; at < End;)
        {
            if (count + 1 >= starts.Length) Array.Resize(ref starts, starts.Length * 2);
            starts[count++] = at;
            at = LineEnds.Next(Text, at, End);
        }
        Array.Resize(ref starts, count + 1);
        starts[count] = End;
        Volatile.Write(ref _lineStarts, starts);
        return starts;
    }

    public int CountLines()
    {
        var count = 0;
        for (var at = Start; at < End; count++) at = LineEnds.Next(Text, at, End);
        return count;
    }
}

/// <summary>LF, CRLF and CR end a line.</summary>
internal static class LineEnds
{
    /// <summary>Index of the first CR or LF from <paramref name="at"/> on, or <paramref name="end"/>.</summary>
    public static int Find(byte[] text, int at, int end)
    {
#if NET8_0_OR_GREATER
        var found = new ReadOnlySpan<byte>(text, at, end - at).IndexOfAny((byte)'\n', (byte)'\r');
        return found < 0 ? end : at + found;
#else
        while (at < end && text[at] != '\n' && text[at] != '\r') at++;
        return at;
#endif
    }

    /// <summary>Index after the line end at <paramref name="at"/>.</summary>
    public static int Skip(byte[] text, int at, int end)
    {
        if (at >= end) return end;
        return text[at] == '\r' && at + 1 < end && text[at + 1] == '\n' ? at + 2 : at + 1;
    }

    /// <summary>Start of the next line.</summary>
    public static int Next(byte[] text, int at, int end) => Skip(text, Find(text, at, end), end);
}
