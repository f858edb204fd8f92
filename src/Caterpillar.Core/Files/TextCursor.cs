namespace Caterpillar.Files;

/// <summary>Reads the words and lines of a text file in memory.</summary>
internal sealed class TextCursor(byte[] bytes, int at, int end)
{
    public byte[] Bytes { get; } = bytes;

    public int At { get; set; } = at;

    public int End { get; } = end;

    public bool AtEnd => At >= End;

    /// <summary>Skips spaces and line ends. False at the end of the file.</summary>
    public bool SkipSpace()
    {
        // Locals, because fields would be written at every byte.
        var (text, p, stop) = (Bytes, At, End);
        while (p < stop && text[p] <= ' ') p++;
        At = p;
        return p < stop;
    }

    /// <summary>Skips spaces within the line. A backslash at the end of a line continues it. False at the end of the line.</summary>
    public bool SkipSpaces()
    {
        for (; At < End; At++)
        {
            var c = Bytes[At];
            if (c == '\n') return false;
            if (c <= ' ') continue;
            if (c != '\\') return true;
            var p = At + 1;
            while (p < End && (Bytes[p] == '\r' || Bytes[p] == ' ' || Bytes[p] == '\t')) p++;
            if (p < End && Bytes[p] != '\n') return true;
            At = p;
        }
        return false;
    }

    /// <summary>Moves after the next line end.</summary>
    public void SkipLine()
    {
        var found = At < End ? Array.IndexOf(Bytes, (byte)'\n', At, End - At) : -1;
        At = found < 0 ? End : found + 1;
    }

    /// <summary>Moves after the word at the cursor and returns its start.</summary>
    public int SkipWord()
    {
        var (text, p, stop) = (Bytes, At, End);
        while (p < stop && text[p] > ' ') p++;
        var start = At;
        At = p;
        return start;
    }

    /// <summary>True if the word from <paramref name="start"/> to the cursor is this one, ignoring case (given in lower case).</summary>
    public bool WordIs(int start, string lower)
    {
        if (At - start != lower.Length) return false;
        var text = Bytes;
        for (var i = 0; i < lower.Length; i++)
        {
            int c = text[start + i];
            if (c != lower[i] && (c is < 'A' or > 'Z' || c + 32 != lower[i])) return false;
        }
        return true;
    }

    /// <summary>
    /// Reads the word at the cursor as a number. <c>nan</c> and <c>inf</c> in any case give NaN. False, without moving, if it is not a number.
    /// </summary>
    public bool ReadNumber(out double value)
    {
        var (text, start) = (Bytes, At);
        var next = NumberReader.Scan(text, start, End, true, out value);
        if (next > start && (next == End || text[next] <= ' '))
        {
            At = next;
            return true;
        }
        return ReadNan(out value);
    }

    /// <summary>Reads three numbers, on several lines or within one. False, at the first that is none.</summary>
    public bool ReadPoint(bool withinLine, out double x, out double y, out double z)
    {
        y = z = 0;
        return ReadNext(withinLine, out x) && ReadNext(withinLine, out y) && ReadNext(withinLine, out z);
    }

    /// <summary>The rest of the line, trimmed, at most 200 characters.</summary>
    public string RestOfLine()
    {
        SkipSpaces();
        var start = At;
        SkipLine();
        var stop = At;
        while (stop > start && Bytes[stop - 1] <= ' ') stop--;
        return Encoding.UTF8.GetString(Bytes, start, Math.Min(200, stop - start));
    }

    private bool ReadNext(bool withinLine, out double value)
    {
        value = 0;
        return (withinLine ? SkipSpaces() : SkipSpace()) && ReadNumber(out value);
    }

    private bool ReadNan(out double value)
    {
        value = double.NaN;
        var p = At;
        if (p < End && (Bytes[p] == '-' || Bytes[p] == '+')) p++;
        if (p + 3 > End) return false;
        int a = Bytes[p] | 32, b = Bytes[p + 1] | 32, c = Bytes[p + 2] | 32;
        if (!((a == 'n' && b == 'a' && c == 'n') || (a == 'i' && b == 'n' && c == 'f'))) return false;
        SkipWord();
        return true;
    }
}
