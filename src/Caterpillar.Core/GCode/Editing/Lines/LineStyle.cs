namespace Caterpillar.GCode;

/// <summary>The style of a file: decimals, spaces, case, line ends. New and changed lines follow it.</summary>
internal sealed class LineStyle
{
    /// <summary>Number of lines that show the style.</summary>
    public const int Sample = 20000;

    public int DecimalsXyz { get; private set; } = 3;

    public int DecimalsE { get; private set; } = 5;

    public int DecimalsF { get; private set; } = 3;

    /// <summary>Maximum decimals. Null = decimals of the file.</summary>
    public int? LimitXyz { get; private set; }

    public int? LimitE { get; private set; }

    public int? LimitF { get; private set; }

    /// <summary>Maximum rounding error of F, mm/min.</summary>
    public double FeedTolerance => LimitF is { } decimals ? 0.501 * NumberFormatter.FromUnits(1, decimals) : 0;

    public bool LowerCase { get; private set; }

    public bool NoSpace { get; private set; }

    /// <summary>Numbers below 1 have no 0 before the point.</summary>
    public bool NoLeadingZero { get; private set; }

    /// <summary>Numbers keep their trailing zeros.</summary>
    public bool FixedDecimals { get; private set; }

    public bool TravelsByG0 { get; private set; }

    /// <summary>Lines begin with numbers and end with checksums.</summary>
    public bool Numbered { get; private set; }

    public bool Checksums { get; private set; }

    public byte[] LineEnd { get; private set; } = [(byte)'\n'];

    public static LineStyle Of(GCodeDocument document)
    {
        var style = new LineStyle();
        var line = new ParsedLine();
        int code = 0, lower = 0, close = 0, bare = 0, zero = 0, trailing = 0, plain = 0, numbered = 0, sums = 0, xyz = 0, e = 0;
        var seen = 0;
        foreach (var chunk in document.Chunks)
        {
            var starts = chunk.LineStarts();
            for (var i = 0; i + 1 < starts.Length && seen < Sample; i++, seen++)
            {
                var end = LineEnds.Find(chunk.Text, starts[i], starts[i + 1]);
                if (seen == 0 && end < starts[i + 1]) style.LineEnd = TextEncoding.Copy(chunk.Text, end, starts[i + 1]);
                line.Scan(chunk.Text, starts[i], end);
                if (line.Shape != LineShape.Code) continue;
                code++;
                if (line.LowerCase) lower++;
                if (line.NoSpace) close++;
                if (line.NumberWordAt >= 0) numbered++;
                if (line.ChecksumAt >= 0) sums++;
                if (line.Letters[0] == 'G' && line.Values[0] == 0) style.TravelsByG0 = true;
                for (var w = 0; w < line.Count; w++)
                {
                    var decimals = Decimals(chunk.Text, line.NumberAt[w], line.NumberEnd[w], out var starting, out var ending);
                    if (line.Letters[w] is (byte)'X' or (byte)'Y' or (byte)'Z') xyz = Math.Max(xyz, decimals);
                    else if (line.Letters[w] is (byte)'E' or (byte)'A' or (byte)'B') e = Math.Max(e, decimals);
                    else continue;
                    if (decimals == 0) continue;
                    if (starting == '.') bare++;
                    else if (starting == '0') zero++;
                    if (ending == '0') trailing++;
                    else plain++;
                }
            }
            if (seen >= Sample) break;
        }
        style.LowerCase = lower * 2 > code;
        style.NoSpace = close * 2 > code;
        style.NoLeadingZero = bare > zero;
        style.FixedDecimals = trailing * 20 > plain && trailing > 0;
        style.Numbered = numbered * 2 > code && code > 0;
        style.Checksums = sums * 2 > code && code > 0;
        if (xyz > 0) style.DecimalsXyz = Math.Min(Math.Max(xyz, 3), 9);
        if (e > 0) style.DecimalsE = Math.Min(Math.Max(e, 5), 9);
        return style;
    }

    /// <summary>The style with other decimals as maximum.</summary>
    public LineStyle With(int? xyz, int? e, int? f)
    {
        var style = (LineStyle)MemberwiseClone();
        style.LimitXyz = xyz;
        style.LimitE = e;
        style.LimitF = f;
        style.DecimalsXyz = xyz ?? DecimalsXyz;
        style.DecimalsE = e ?? DecimalsE;
        style.DecimalsF = f ?? DecimalsF;
        return style;
    }

    /// <summary>Writes a number in this style and returns the index after it.</summary>
    public int Write(byte[] buffer, int at, double value, int decimals)
    {
        // A double has no more than 15 digits.
        while (decimals > 0 && Math.Abs(value) > NumberFormatter.FromUnits(8_000_000_000_000_000, decimals)) decimals--;
        return WriteUnits(buffer, at, NumberFormatter.ToUnits(value, decimals), decimals);
    }

    /// <summary>The same for a number in units of its last decimal.</summary>
    public int WriteUnits(byte[] buffer, int at, long units, int decimals)
    {
        var start = at;
        at = NumberFormatter.WriteUnits(buffer, at, units, decimals);
        if (!FixedDecimals && !NoLeadingZero) return at;
        var point = Array.IndexOf(buffer, (byte)'.', start, at - start);
        if (FixedDecimals && decimals > 0)
        {
            if (point < 0)
            {
                point = at;
                buffer[at++] = (byte)'.';
            }
            while (at - point - 1 < decimals) buffer[at++] = (byte)'0';
        }
        var first = start + (units < 0 ? 1 : 0);
        if (!NoLeadingZero || point != first + 1 || buffer[first] != '0') return at;
        Buffer.BlockCopy(buffer, point, buffer, first, at - point);
        return at - 1;
    }

    /// <summary>Decimals of a number as written, its first digit or point and its last character.</summary>
    public static int Decimals(byte[] text, int start, int end, out char first, out char last)
    {
        first = last = ' ';
        if (end <= start) return 0;
        var at = text[start] is (byte)'-' or (byte)'+' ? start + 1 : start;
        if (at < end) first = (char)text[at];
        last = (char)text[end - 1];
        var point = Array.IndexOf(text, (byte)'.', start, end - start);
        if (point < 0) return 0;
        var stop = point + 1;
        while (stop < end && (uint)(text[stop] - '0') <= 9) stop++;
        return stop - point - 1;
    }
}
