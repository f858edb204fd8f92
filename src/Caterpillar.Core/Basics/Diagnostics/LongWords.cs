namespace Caterpillar.Basics;

/// <summary>
/// Makes quotations in messages fit to print: numbers of hundreds of digits and whole files on one line are shortened, control characters are shown as
/// <c>\u001B</c>, so that a file cannot control the terminal of its reader.
/// </summary>
internal static class LongWords
{
    // Paths of ordinary length stay whole.
    private static readonly Regex Longest = new("([^ \n]{40})[^ \n]{61,}([^ \n]{20})");

    // Also those that change the direction of text.
    private static readonly Regex Control = new(@"[\x00-\x08\x0B\x0C\x0E-\x1F\x7F-\x9F\u202A-\u202E\u2066-\u2069]");

    private static readonly Regex Digits = new("(?<![0-9.])([0-9])([0-9])[0-9]{23,}");

    /// <summary>The text with words of more than 120 characters shortened in the middle, and numbers of more than 24 digits as powers of ten.</summary>
    public static string Shorten(string text) => text is null ? text! : Longest.Replace(Digits.Replace(Visible(text), PowerOfTen), "$1…$2");

    /// <summary>The text with control characters as <c>\u001B</c>, except tabs and line ends.</summary>
    public static string Visible(string text)
        => Control.Replace(text, character => "\\u" + ((int)character.Value[0]).ToString("X4", CultureInfo.InvariantCulture));

    /// <summary>A name on one line, without control characters.</summary>
    public static string OneLine(string? name) => name is null ? "" : Visible(string.Join("\\n", string.Join("\\r", name.Split('\r')).Split('\n')));

    private static string PowerOfTen(Match number)
        => number.Result(number.Groups[2].Value == "0" ? "$1e" : "$1.$2e") + NumberFormatter.Format(number.Length - 1);
}
