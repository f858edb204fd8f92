namespace Caterpillar.Cli;

/// <summary>
/// A table of text with column names in the first row. Cells are separated by commas, or by semicolons or tabs if the first row has more of them, and quoted
/// as in spreadsheets (RFC 4180). Empty rows and rows that start with # are skipped.
/// </summary>
internal sealed record CsvTable(IReadOnlyList<string> Columns, IReadOnlyList<IReadOnlyList<string>> Rows)
{
    /// <exception cref="CliException">It is not a table (bad input).</exception>
    public static CsvTable Parse(string text, string file)
    {
        if (text.StartsWith('\uFEFF')) text = text[1..];
        var firstLine = text.Split('\n').FirstOrDefault(l => l.Trim() is { Length: > 0 } row && row[0] != '#') ?? "";
        var separator = new[] { ',', ';', '\t' }.MaxBy(c => firstLine.Count(d => d == c));
        IReadOnlyList<string>? columns = null;
        var rows = new List<IReadOnlyList<string>>();
        foreach (var (cells, line) in Split(text, separator, file))
        {
            if (cells.All(c => c.Length == 0) || cells[0].StartsWith('#')) continue;
            if (columns is null)
            {
                columns = cells;
                if (cells.FirstOrDefault(c => cells.Count(d => d == c) > 1) is { } twice) throw Bad(file, line, $"there are two columns \"{twice}\".");
                if (cells.Contains("")) throw Bad(file, line, "a column has no name.");
                continue;
            }
            if (cells.Count > columns.Count)
                throw Bad(file, line, $"{NumberFormatter.Format(cells.Count)} cells for {Figures.Count(columns.Count, "column")}.");
            rows.Add([.. cells, .. Enumerable.Repeat("", columns.Count - cells.Count)]);
        }
        return new CsvTable(columns ?? throw new CliException(ExitCode.BadInput, $"{file}: the table is empty. Its first row must name the columns."), rows);
    }

    /// <summary>A row of cells, quoted where necessary.</summary>
    public static string Line(IEnumerable<string> cells)
        => string.Join(",", cells.Select(c => c.IndexOfAny([',', '"', '\n', '\r']) < 0
            && c.Trim().Length == c.Length ? c : "\"" + c.Replace("\"", "\"\"") + "\""));

    private static IEnumerable<(IReadOnlyList<string> Cells, int Line)> Split(string text, char separator, string file)
    {
        var cells = new List<string>();
        var cell = new StringBuilder();
        var (line, first) = (1, 1);
        bool quoted = false, wasQuoted = false;
        for (var i = 0; i <= text.Length; i++)
        {
            var c = i < text.Length ? text[i] : '\n';
            if (quoted)
            {
                if (i == text.Length) throw Bad(file, first, "a quote is not closed.");
                if (c == '\n') line++;
                if (c != '"') cell.Append(c);
                else if (i + 1 < text.Length && text[i + 1] == '"') cell.Append(text[++i]);
                else quoted = false;
                continue;
            }
            if (c == '"' && cell.ToString().Trim().Length == 0)
            {
                cell.Clear();
                quoted = wasQuoted = true;
            }
            else if (c == separator || c == '\n')
            {
                cells.Add(wasQuoted ? cell.ToString() : cell.ToString().Trim());
                cell.Clear();
                wasQuoted = false;
                if (c != '\n') continue;
                yield return (cells, first);
                cells = [];
                first = ++line;
            }
            else if (!wasQuoted || !char.IsWhiteSpace(c))
            {
                cell.Append(c);
            }
        }
    }

    private static CliException Bad(string file, int line, string problem) => new(ExitCode.BadInput, $"{file}:{NumberFormatter.Format(line)}: {problem}");
}
