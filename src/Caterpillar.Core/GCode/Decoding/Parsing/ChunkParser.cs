namespace Caterpillar.GCode;

/// <summary>
/// First half of decoding, without state: cuts a chunk into lines and reads the words of motions in the usual notation (<c>G1 X1.5 Y2 E.03 F1800 ;
/// text</c>). <see cref="ParsedLine"/> reads everything else. Chunks can be parsed in parallel.
/// </summary>
/// <param name="extruder">The letter of E, or 0.</param>
internal sealed partial class ChunkParser(byte extruder)
{
    public const byte Comment = 2;
    public const byte Other = 3;
    public const byte HasX = 1;
    public const byte HasY = 2;
    public const byte HasZ = 4;
    public const byte HasE = 8;
    public const byte HasF = 16;

    public LineRecord[] Records { get; private set; } = new LineRecord[64];

    /// <summary>Places of the words of each record, for edits.</summary>
    public WordPlaces[] Places { get; private set; } = new WordPlaces[64];

    /// <summary>Number of lines, of lines that end with CRLF, and of motions with a <c>;</c> comment.</summary>
    public int Count { get; private set; }

    public int CrLf { get; private set; }

    public int Comments { get; private set; }

    public GCodeChunk? Chunk { get; private set; }

    /// <summary>True while somebody reads what it has found, perhaps another thread.</summary>
    public volatile bool IsHeld;

    /// <summary>Reads a chunk from <paramref name="start"/> on.</summary>
    public void Parse(GCodeChunk chunk, int start)
    {
        Chunk = chunk;
        var text = chunk.Text;
        var end = chunk.End;
        // Up to here every scan meets a LF before the text ends.
        var safe = end;
        while (safe > start && text[safe - 1] != '\n') safe--;
        Count = CrLf = Comments = 0;
        var at = start;
        while (true)
        {
            at = Plain(text, at, safe, end);
            if (at == safe) break;
            if (Count == Records.Length) Grow();
            else at = OtherLine(text, at, end);
        }
        // What follows the last LF: the last line of a file, or lines that end with CR.
        while (at < end)
        {
            if (Count == Records.Length) Grow();
            at = OtherLine(text, at, end);
        }
    }

    private int OtherLine(byte[] text, int at, int end)
    {
        var stop = LineEnds.Find(text, at, end);
        Places[Count] = default;
        Records[Count] = new LineRecord { Start = at, Aux = stop, Op = text[at] == ';' ? Comment : Other };
        Count++;
        if (stop + 1 < end && text[stop] == '\r' && text[stop + 1] == '\n') CrLf++;
        return LineEnds.Skip(text, stop, end);
    }

    private void Grow()
    {
        var (records, words) = (Records, Places);
        Array.Resize(ref records, Count * 2);
        Array.Resize(ref words, Count * 2);
        (Records, Places) = (records, words);
    }
}
