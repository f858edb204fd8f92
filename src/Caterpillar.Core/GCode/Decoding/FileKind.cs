namespace Caterpillar.GCode;

/// <summary>Guesses the kind of a file that is not G-code from its first bytes.</summary>
internal static class FileKind
{
    // Bytes of any kind may contain what looks like a command by chance.
    private const int LinesPerChance = 20;
    private const int Looked = 4096;

    /// <summary>The error for a file without commands, or null for G-code.</summary>
    public static Diagnostic? NotGCode(GCodeChunk? head, long bytes, int lines, int commands)
    {
        if (commands > 0 && (long)commands * LinesPerChance >= lines && (head is null || Mark(head) is null)) return null;
        var kind = head is null || bytes == 0 ? "is empty" : Kind(head, bytes);
        if (commands > 0 && kind is null) return null;
        return new Diagnostic(Severity.Error, "gcode.not_gcode", "The file is not G-code. It " + (kind ?? "contains no commands") + ".");
    }

    private static string? Kind(GCodeChunk head, long bytes)
    {
        if (Mark(head) is { } known) return known;
        var (start, end) = Beginning(head);
        if (IsBinaryStl(head, bytes)) return "looks like a mesh (binary STL)";
        if (Array.IndexOf(head.Text, (byte)0, start, end - start) >= 0) return "looks like binary data";
        return TextKind(TextEncoding.Decode(head.Text, start, end));
    }

    // Files of these kinds begin with bytes with which no G-code begins.
    private static string? Mark(GCodeChunk head)
    {
        var (start, end) = Beginning(head);
        var text = TextEncoding.Decode(head.Text, start, Math.Min(end, start + 4));
        bool Begins(string mark) => text.StartsWith(mark, StringComparison.Ordinal);
        if (Begins("PK\u0003\u0004")) return "looks like a ZIP archive or a 3MF model";
        if (Begins("\u001F\u008B")) return "looks like data compressed with gzip twice";
        if (Begins("\u0089PNG")) return "looks like an image (PNG)";
        if (Begins("\u00FF\u00D8\u00FF")) return "looks like an image (JPEG)";
        if (Begins("GIF8")) return "looks like an image (GIF)";
        if (Begins("\u00FF\u00FE") || Begins("\u00FE\u00FF")) return "is UTF-16, which no firmware reads: save it as UTF-8";
        return Begins("%PDF") ? "looks like a PDF document" : null;
    }

    private static (int Start, int End) Beginning(GCodeChunk head)
    {
        var start = head.Start + TextEncoding.MarkLength(head);
        return (start, Math.Min(head.End, start + Looked));
    }

    private static bool IsBinaryStl(GCodeChunk head, long bytes)
        => bytes >= 84 && head.Length >= 84 && BitConverter.ToUInt32(head.Text, head.Start + 80) * 50L + 84 == bytes;

    private static string? TextKind(string text)
    {
        var trimmed = text.TrimStart();
        if (trimmed.Length == 0) return "contains only blank lines";
        if (trimmed.StartsWith("solid", StringComparison.Ordinal) && trimmed.IndexOf("facet", StringComparison.Ordinal) > 0)
            return "looks like a mesh (ASCII STL)";
        if (trimmed.StartsWith("ply\n", StringComparison.Ordinal) || trimmed.StartsWith("ply\r", StringComparison.Ordinal)) return "looks like a mesh (PLY)";
        if (trimmed[0] == '<')
            return trimmed.IndexOf("<svg", StringComparison.OrdinalIgnoreCase) >= 0 ? "looks like a drawing (SVG)" : "looks like XML or HTML";
        if (trimmed[0] is '{' or '[') return "looks like JSON";
        return IsObj(trimmed) ? "looks like a mesh (OBJ)" : null;
    }

    // Its first line that is no comment.
    private static bool IsObj(string text)
    {
        foreach (var line in text.Split('\n'))
        {
            if (line.Trim().Length == 0 || line[0] == '#') continue;
            return Array.Exists(["v ", "vn ", "vt ", "o ", "g ", "mtllib ", "usemtl "], word => line.StartsWith(word, StringComparison.Ordinal));
        }
        return false;
    }
}
