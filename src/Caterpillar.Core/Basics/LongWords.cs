using System.Text;

namespace Caterpillar.Basics;

/// <summary>Keeps messages readable that quote what somebody wrote: numbers of hundreds of digits, whole files on one line.</summary>
public static class LongWords
{
    // Paths of ordinary length stay whole.
    private const int Longest = 120;
    private const int Head = 40;
    private const int Tail = 20;

    /// <summary>The text with every word of more than 120 characters cut in its middle.</summary>
    public static string Shorten(string text)
    {
        if (text is null || text.Length <= Longest) return text!;
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
}
