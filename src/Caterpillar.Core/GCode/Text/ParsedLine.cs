namespace Caterpillar.GCode;

internal enum LineShape : byte
{
    /// <summary>Only spaces and comments.</summary>
    Empty,

    /// <summary>Words.</summary>
    Code,

    /// <summary>An extended command or something that is not G-code.</summary>
    Macro,
}

/// <summary>
/// General reader of lines that the fast path of <see cref="ChunkParser"/> does not read. Reused from line to line. Positions are indices into the text.
/// </summary>
internal sealed class ParsedLine
{
    // No firmware reads more than a few hundred characters of a line.
    private const int MostWords = 10_000;

    public byte[] Letters = new byte[16];
    public double[] Values = new double[16];
    public bool[] HasValue = new bool[16];
    public int[] LetterAt = new int[16];
    public int[] NumberAt = new int[16];
    public int[] NumberEnd = new int[16];

    public int Count { get; private set; }

    public LineShape Shape { get; private set; }

    /// <summary>Start of the words (after spaces, / and the N word) and end of the code (before the checksum and comments).</summary>
    public int CodeStart { get; private set; }

    public int CodeEnd { get; private set; }

    /// <summary>Index of the <c>;</c> and of the first <c>(</c>. −1 = none.</summary>
    public int CommentStart { get; private set; }

    public int ParenStart { get; private set; }

    /// <summary>Index of the <c>*</c>, or −1.</summary>
    public int ChecksumAt { get; private set; }

    /// <summary>Index of the N, or −1, and its number.</summary>
    public int NumberWordAt { get; private set; }

    public int NumberWordEnd { get; private set; }

    public double LineNumber { get; private set; }

    public bool BlockDelete { get; private set; }

    public bool LowerCase { get; private set; }

    public bool NoSpace { get; private set; }

    public bool Exponent { get; private set; }

    /// <summary>Index of the last word with this letter and a number, or −1.</summary>
    public int Find(char letter)
    {
        for (var i = Count - 1; i >= 0; i--)
        {
            if (Letters[i] == letter && HasValue[i]) return i;
        }
        return -1;
    }

    public bool Has(char letter) => Array.IndexOf(Letters, (byte)letter, 0, Count) >= 0;

    /// <summary>True if one of its G words has this number.</summary>
    public bool HasCode(double code)
    {
        for (var i = 0; i < Count; i++)
        {
            if (Letters[i] == 'G' && HasValue[i] && Values[i] == code) return true;
        }
        return false;
    }

    /// <summary>True if the line has a word with one of these letters.</summary>
    public bool HasAny(string letters)
    {
        foreach (var letter in letters)
        {
            if (Has(letter)) return true;
        }
        return false;
    }

    public bool TryGet(char letter, out double value)
    {
        var at = Find(letter);
        value = at >= 0 ? Values[at] : 0;
        return at >= 0;
    }

    public double Get(char letter, double otherwise) => TryGet(letter, out var value) ? value : otherwise;

    /// <summary>Reads the line between <paramref name="start"/> and <paramref name="end"/> (without its line end).</summary>
    public void Scan(byte[] text, int start, int end)
    {
        Count = 0;
        Shape = LineShape.Empty;
        CommentStart = ParenStart = ChecksumAt = NumberWordAt = -1;
        BlockDelete = LowerCase = NoSpace = Exponent = false;
        var at = SkipSpaces(text, start, end);
        CodeStart = CodeEnd = at;
        if (at == end) return;
        if (text[at] is (byte)'%' or (byte)'@' or (byte)'<')
        {
            Shape = LineShape.Macro;
            CodeEnd = end;
            return;
        }
        if (text[at] == '/')
        {
            BlockDelete = true;
            CodeStart = ++at;
        }
        Words(text, at, end);
    }

    private void Words(byte[] text, int at, int end)
    {
        var wordEnd = -1;
        while ((at = SkipSpaces(text, at, end)) < end)
        {
            var c = text[at];
            if (c == ';')
            {
                CommentStart = at;
                return;
            }
            if (c == '(')
            {
                if (ParenStart < 0) ParenStart = at;
                var close = Array.IndexOf(text, (byte)')', at, end - at);
                if (close < 0) return;
                at = close + 1;
                continue;
            }
            if (ChecksumAt >= 0)
            {
                at++;
                continue;
            }
            if (c == '*')
            {
                ChecksumAt = at;
                at = NumberReader.Scan(text, at + 1, end, false, out _);
                continue;
            }
            var letter = (byte)(c & 0xDF);
            if (letter is >= (byte)'A' and <= (byte)'Z' && c < 128)
            {
                var next = Count < MostWords ? Word(text, at, end, letter, wordEnd) : -1;
                if (next < 0)
                {
                    // An extended command, or no G-code: what follows is text, up to a comment.
                    Shape = LineShape.Macro;
                    CommentStart = Array.IndexOf(text, (byte)';', at, end - at);
                    CodeEnd = CommentStart < 0 ? end : CommentStart;
                    Count = 0;
                    return;
                }
                at = wordEnd = CodeEnd = next;
                if (Count == 1 && Letters[0] == 'M' && HasValue[0] && TakesText(Values[0]))
                {
                    CommentStart = Array.IndexOf(text, (byte)';', at, end - at);
                    CodeEnd = CommentStart < 0 ? end : CommentStart;
                    return;
                }
                continue;
            }
            if (Shape == LineShape.Empty)
            {
                Shape = LineShape.Macro;
                CommentStart = Array.IndexOf(text, (byte)';', at, end - at);
                CodeEnd = CommentStart < 0 ? end : CommentStart;
                return;
            }
            at = c == '"' ? SkipQuoted(text, at, end) : at + 1;
            CodeEnd = at;
        }
    }

    // Returns the index after the word, or -1 when the first word of the line is not a letter with a number.
    private int Word(byte[] text, int at, int end, byte letter, int previousEnd)
    {
        var numberAt = at + 1;
        while (numberAt < end && text[numberAt] is (byte)' ' or (byte)'\t') numberAt++;
        var numberEnd = NumberReader.Scan(text, numberAt, end, false, out var value);
        var has = numberEnd > numberAt;
        if (!has)
        {
            if (Shape == LineShape.Empty) return -1;
            numberAt = numberEnd = at + 1;
        }
        else if (numberAt == at + 1 && numberEnd < end && (text[numberEnd] | 0x20) == 'e' && (at == 0 || text[at - 1] <= ' ' || text[at - 1] == ')'))
        {
            var close = PrintfExponent(text, numberEnd, end);
            if (close > numberEnd)
            {
                numberEnd = NumberReader.Scan(text, numberAt, close, true, out value);
                Exponent = true;
            }
        }
        if (text[at] > 'Z' && has) LowerCase = true;
        if (at == previousEnd && has) NoSpace = true;
        if (letter == 'N' && Shape == LineShape.Empty && NumberWordAt < 0)
        {
            NumberWordAt = at;
            NumberWordEnd = numberEnd;
            LineNumber = value;
            CodeStart = numberEnd;
            return numberEnd;
        }
        Shape = LineShape.Code;
        Add(letter, has, value, at, numberAt, numberEnd);
        return numberEnd;
    }

    // An exponent as printf writes it: sign, two digits or more, and then a space or the end.
    private static int PrintfExponent(byte[] text, int at, int end)
    {
        var p = at + 1;
        if (p >= end || (text[p] != '+' && text[p] != '-')) return at;
        var digits = ++p;
        while (p < end && (uint)(text[p] - '0') <= 9) p++;
        return p - digits >= 2 && (p == end || text[p] <= ' ' || text[p] is (byte)';' or (byte)'(' or (byte)'*') ? p : at;
    }

    private void Add(byte letter, bool has, double value, int at, int numberAt, int numberEnd)
    {
        if (Count == Letters.Length)
        {
            var size = Count * 2;
            Array.Resize(ref Letters, size);
            Array.Resize(ref Values, size);
            Array.Resize(ref HasValue, size);
            Array.Resize(ref LetterAt, size);
            Array.Resize(ref NumberAt, size);
            Array.Resize(ref NumberEnd, size);
        }
        Letters[Count] = letter;
        Values[Count] = value;
        // An infinite number is none.
        HasValue[Count] = has && !double.IsInfinity(value);
        LetterAt[Count] = at;
        NumberAt[Count] = numberAt;
        NumberEnd[Count] = numberEnd;
        Count++;
    }

    // M commands whose argument is a text or a file name.
    private static bool TakesText(double code) => code is 117 or 118 or 23 or 28 or 29 or 30 or 32 or 36 or 16 or 70 or 550 or 587 or 588 or 589 or 928;

    private static int SkipQuoted(byte[] text, int at, int end)
    {
        var close = Array.IndexOf(text, (byte)'"', at + 1, end - at - 1);
        return close < 0 ? at + 1 : close + 1;
    }

    private static int SkipSpaces(byte[] text, int at, int end)
    {
        while (at < end && text[at] <= ' ') at++;
        return at;
    }
}
