namespace Caterpillar.Drawings;

/// <summary>
/// A single-line font for pens, nozzles and engraving: ASCII and accented Latin letters. On its grid, capitals are 12 units high, small letters 8, and
/// descenders reach 4 units below the baseline.
/// </summary>
internal static class StrokeFont
{
    private const double CapHeight = 12;
    private const double SmallHeight = 8;
    private const double Gap = 3;
    private const int Below = 4;

    // The middle of the marks.
    private const double MarkCenter = 3;

    // What other characters look like.
    private const string Box = "60e6e6q0q0e";

    private static readonly Dictionary<(string Kind, char Character), string> Shapes = EmbeddedText.Rows("drawings/StrokeFont.tsv").Skip(1)
        .SelectMany(row => row[2].Select(character => (Key: (row[0], character), Shape: row[1]))).ToDictionary(s => s.Key, s => s.Shape);

    /// <summary>True for characters that have a shape. Others are boxes.</summary>
    public static bool Has(char character) => Shapes.ContainsKey(("glyph", character)) || Accented(character) is not null;

    /// <summary>The strokes of a line of text from the origin along X, with Y up.</summary>
    /// <param name="text">One line.</param>
    /// <param name="capHeight">Height of capitals, mm.</param>
    /// <exception cref="ArgumentOutOfRangeException">The height is not above 0.</exception>
    public static IReadOnlyList<Vec3[]> Strokes(string text, double capHeight) => Drawn(text, capHeight).Strokes;

    /// <summary>Width of the text from its first letter to the start of a following letter, mm.</summary>
    /// <inheritdoc cref="Strokes"/>
    public static double Advance(string text, double capHeight) => Drawn(text, capHeight).Advance;

    private static (IReadOnlyList<Vec3[]> Strokes, double Advance) Drawn(string text, double capHeight)
    {
        if (!(capHeight > 0) || double.IsInfinity(capHeight)) throw new ArgumentOutOfRangeException(nameof(capHeight), "The letter height must be above 0.");
        var scale = capHeight / CapHeight;
        var strokes = new List<Vec3[]>();
        double x = 0;
        foreach (var character in text ?? throw new ArgumentNullException(nameof(text))) x += Draw(character, x, scale, strokes);
        return (strokes, x);
    }

    // The letter below an accent, and the accent.
    private static (char Letter, char Mark)? Accented(char character)
        => Shapes.TryGetValue(("accent", character), out var both) ? (both[0], both[1]) : null;

    private static double Draw(char character, double x, double scale, List<Vec3[]> strokes)
    {
        var accented = Accented(character);
        var letter = accented?.Letter ?? character;
        var glyph = Shapes.TryGetValue(("glyph", letter), out var known) ? known : Box;
        var width = (double)(glyph[0] - '0');
        var words = glyph.Substring(1).Split([' '], StringSplitOptions.RemoveEmptyEntries);
        for (var i = 0; i < words.Length; i++)
        {
            // An accent takes the place of the dot.
            if (i == 1 && accented is not null && letter is 'i' or 'j') continue;
            Add(words[i], x, 0, scale, strokes);
        }
        if (accented is { } with)
        {
            var top = char.IsUpper(letter) ? CapHeight : SmallHeight;
            foreach (var mark in Shapes[("mark", with.Mark)].Split(' '))
                Add(mark, x + (width / 2 - MarkCenter) * scale, with.Mark == ',' ? 0 : top * scale, scale, strokes);
        }
        return (width + Gap) * scale;
    }

    // Pairs of a digit for x and a letter for y, of which e is the line.
    private static void Add(string word, double x, double y, double scale, List<Vec3[]> strokes)
    {
        var points = new Vec3[word.Length / 2];
        for (var i = 0; i < points.Length; i++)
            points[i] = new Vec3(x + (word[2 * i] - '0') * scale, y + (word[2 * i + 1] - 'a' - Below) * scale);
        strokes.Add(points);
    }
}
