namespace Caterpillar.Basics;

/// <summary>
/// Makes quotations in messages fit to print: numbers of hundreds of digits and whole files on one line are shortened, control characters are shown as
/// <c>\u001B</c>, so that a file cannot control the terminal of its reader.
/// </summary>
internal static class LongWords
{
    // Paths of ordinary length stay whole.
    private const int Longest = 120;
    private const int Head = 40;
    private const int Tail = 20;
    private const int MostDigits = 24;

    /// <summary>The text with words of more than 120 characters shortened in the middle, and numbers of more than 24 digits as powers of ten.</summary>
    public static string Shorten(string text)
    {
        if (text is null) return text!;
        text = WithoutDigits(Visible(text));
        if (text.Length <= Longest) return text;
        StringBuilder? shorter = null;
        for (int start = 0, at = 0; at <= text.Length; at++)
        {
            if (at < text.Length && text[at] is not (' ' or '\n')) continue;
            if (at - start > Longest)
            {
                shorter ??= new StringBuilder(text, 0, start, text.Length);
                shorter.Append(text, start, Head).Append('…').Append(text, at - Tail, Tail);
            }
            else
            {
                shorter?.Append(text, start, at - start);
            }
            if (at < text.Length) shorter?.Append(text[at]);
            start = at + 1;
        }
        return shorter?.ToString() ?? text;
    }

    /// <summary>The text with control characters as <c>\u001B</c>, except tabs and line ends.</summary>
    public static string Visible(string text)
    {
        StringBuilder? visible = null;
        for (var i = 0; i < text.Length; i++)
        {
            var c = text[i];
            if (IsControl(c)) (visible ??= new StringBuilder(text, 0, i, text.Length + 16)).Append("\\u").Append(((int)c).ToString("X4", null));
            else visible?.Append(c);
        }
        return visible?.ToString() ?? text;
    }

    /// <summary>A name on one line, without control characters.</summary>
    public static string OneLine(string? name) => name is null ? "" : Visible(string.Join("\\n", string.Join("\\r", name.Split('\r')).Split('\n')));

    // Also those that change the direction of text.
    private static bool IsControl(char c)
        => (c < ' ' && c is not ('\n' or '\r' or '\t')) || c is >= '\x7F' and <= '\x9F' or >= '\u202A' and <= '\u202E' or >= '\u2066' and <= '\u2069';

    private static string WithoutDigits(string text)
    {
        StringBuilder? shorter = null;
        var kept = 0;
        for (int start = 0, at = 0; at <= text.Length; at++)
        {
            if (at < text.Length && text[at] is >= '0' and <= '9') continue;
            if (at - start > MostDigits && (start == 0 || text[start - 1] != '.'))
            {
                shorter ??= new StringBuilder(text.Length);
                shorter.Append(text, kept, start - kept).Append(text[start]);
                if (text[start + 1] != '0') shorter.Append('.').Append(text[start + 1]);
                shorter.Append('e').Append(NumberFormatter.Format(at - start - 1));
                kept = at;
            }
            start = at + 1;
        }
        return shorter?.Append(text, kept, text.Length - kept).ToString() ?? text;
    }
}
