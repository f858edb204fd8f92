namespace Caterpillar.Cli;

/// <summary>Text in columns, two spaces apart; an empty row gives an empty line.</summary>
internal static class TextTable
{
    public static void Write(TextWriter text, IReadOnlyList<string[]> rows)
    {
        var columns = rows.Max(r => r.Length);
        var widths = Enumerable.Range(0, columns).Select(c => rows.Max(r => c < r.Length ? r[c].Length : 0)).ToArray();
        var line = new StringBuilder();
        foreach (var row in rows)
        {
            line.Clear();
            for (var c = 0; c < row.Length; c++) line.Append(row[c].PadRight(widths[c] + 2));
            text.WriteLine(line.ToString().TrimEnd(' '));
        }
    }
}
