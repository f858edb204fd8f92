namespace Caterpillar.GCode;

/// <summary>A thumbnail in the comments of a file.</summary>
/// <param name="Width">Pixels.</param>
/// <param name="Height">Pixels.</param>
/// <param name="Format">PNG, JPG, QOI or another name from the file.</param>
public sealed record Thumbnail(int Width, int Height, string Format)
{
    /// <summary>Reads "thumbnail begin 16x16 616" and "thumbnail_QOI begin 313x173 14412". Null for other lines.</summary>
    internal static Thumbnail? Read(string comment)
    {
        const string Word = "thumbnail", Begin = " begin ";
        var at = comment.IndexOf(Begin, StringComparison.Ordinal);
        if (at < Word.Length || !comment.StartsWith(Word, StringComparison.Ordinal)) return null;
        var format = comment.Substring(Word.Length, at - Word.Length);
        if (format.Length > 0 && (format[0] != '_' || format.Length is < 2 or > 9)) return null;
        var numbers = comment.Substring(at + Begin.Length).Split(['x', ' '], StringSplitOptions.RemoveEmptyEntries);
        if (numbers.Length < 2 || !Size(numbers[0], out var width) || !Size(numbers[1], out var height)) return null;
        return new Thumbnail(width, height, format.Length == 0 ? "PNG" : format.Substring(1));
    }

    /// <summary>The lines of an image in base64, as PrusaSlicer writes them.</summary>
    internal IEnumerable<string> Lines(byte[] image)
    {
        const int RowLength = 78;
        var name = Format == "PNG" ? "thumbnail" : "thumbnail_" + Format;
        var encoded = Convert.ToBase64String(image);
        yield return ";";
        yield return $"; {name} begin {NumberFormatter.Format(Width)}x{NumberFormatter.Format(Height)} {NumberFormatter.Format(encoded.Length)}";
        for (var at = 0; at < encoded.Length; at += RowLength) yield return "; " + encoded.Substring(at, Math.Min(RowLength, encoded.Length - at));
        yield return $"; {name} end";
        yield return ";";
    }

    /// <summary>For example "16x16 PNG".</summary>
    public override string ToString() => NumberFormatter.Format(Width) + "x" + NumberFormatter.Format(Height) + " " + Format;

    private static bool Size(string text, out int size)
    {
        var good = NumberReader.TryParse(text, out var value) && value >= 0 && value <= 65535 && value == Math.Floor(value);
        size = good ? (int)value : 0;
        return good;
    }
}
