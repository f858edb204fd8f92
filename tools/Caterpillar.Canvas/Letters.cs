namespace Caterpillar.CanvasPictures;

/// <summary>Widths of texts in Grasshopper's standard font, in pixels, as columns of ports in public definitions show them.</summary>
internal static class Letters
{
    /// <summary>Height of a line of a panel.</summary>
    public const double PanelLine = 13;

    /// <summary>Width of a letter of a panel.</summary>
    public const double PanelLetter = 6.1;

    public static double Width(string text)
    {
        double width = 0;
        foreach (var letter in text) width += Width(letter);
        return width;
    }

    private static double Width(char letter) => letter switch
    {
        'i' or 'j' or 'l' or '\'' or '|' or '.' or ',' or ':' => 2.7,
        'f' or 'r' or 't' or '(' or ')' or '-' or 'I' => 3.6,
        'F' or 'L' => 5.3,
        'm' => 7.7,
        'w' => 7,
        'M' or 'W' or '%' => 10.3,
        'D' or 'G' or 'N' or 'O' or 'Q' => 8.3,
        'A' or 'C' or 'H' or 'R' or 'U' or 'V' => 7.3,
        >= 'B' and <= 'Z' => 6.3,
        _ => 5.2,
    };
}
