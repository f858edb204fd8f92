namespace Caterpillar.Cli;

/// <summary>The results of a batch as a CSV table, and the runs that an earlier table lists as done.</summary>
internal sealed class BatchSummary
{
    private readonly string[] _header;
    private readonly Dictionary<string, string[]> _earlier = new(StringComparer.Ordinal);

    // Rows of the earlier summary by what they were made from, until their runs are looked at again.
    private readonly Dictionary<string, string[]> _rows = new(StringComparer.Ordinal);

    /// <param name="columns">Columns of the table of values.</param>
    public BatchSummary(IReadOnlyList<string> columns)
    {
        string[] before = ["job", "input"];
        string[] after = ["output", "status", "exit_code", "error", "message", .. FigureNames, "work_s", "fingerprint"];
        // A column of the values may have the name of a result.
        _header = [.. before, .. columns.Select(c => before.Contains(c) || after.Contains(c) ? "given_" + c : c), .. after];
    }

    /// <summary>Names of the columns for the written files.</summary>
    public static IReadOnlyList<string> FigureNames { get; } = [.. PrintFigures.Names, "lines", "bytes"];

    /// <summary>Reads the summary of an earlier run.</summary>
    /// <exception cref="CliException">It is not a summary.</exception>
    public void ReadEarlier(string text, string file)
    {
        var table = CsvTable.Parse(text, file);
        var places = new[] { "fingerprint", "status", "output", "bytes" }.Select(n => table.Columns.ToList().IndexOf(n)).ToArray();
        var figures = FigureNames.Select(n => table.Columns.ToList().IndexOf(n)).ToArray();
        if (places.Concat(figures).Contains(-1)) throw new CliException(ExitCode.BadInput, $"{file} is not a summary of an earlier run. --resume needs one.");
        foreach (var row in table.Rows.Where(r => r[places[1]] is "done" or "skipped" && r[places[0]].Length > 0))
        {
            var (output, bytes) = (row[places[2]], row[places[3]]);
            if (output.Length > 0 && (!File.Exists(output) || NumberFormatter.Format(new FileInfo(output).Length) != bytes)) continue;
            _earlier[row[places[0]]] = figures.Select(i => row[i]).ToArray();
            if (table.Columns.SequenceEqual(_header)) _rows[Key(row)] = [.. row];
        }
    }

    /// <summary>The figures of a run that is already done, or null.</summary>
    public IReadOnlyList<string>? Earlier(string fingerprint) => _earlier.GetValueOrDefault(fingerprint);

    /// <summary>Writes the table.</summary>
    public void Write(Session session, string file, IEnumerable<BatchOutcome> outcomes) => session.WriteText(file, text =>
    {
        text.WriteLine(CsvTable.Line(_header));
        foreach (var outcome in outcomes) text.WriteLine(CsvTable.Line(Row(outcome)));
    });

    private string[] Row(BatchOutcome outcome)
    {
        string[] cells = [.. Cells(outcome)];
        if (outcome.Status != BatchStatus.NotStarted || !_rows.TryGetValue(Key(cells), out var row)) return cells;
        row[0] = cells[0];
        return row;
    }

    // Inputs, values and output.
    private string Key(IReadOnlyList<string> row) => string.Join("\n", row.Take(Array.IndexOf(_header, "status")).Skip(1));

    private static IEnumerable<string> Cells(BatchOutcome outcome)
        =>
        [
            NumberFormatter.Format(outcome.Job.Number), string.Join(" ", outcome.Job.Inputs), .. outcome.Job.Cells, outcome.Job.Output ?? "",
            Words.Spaced(outcome.Status.ToString()).ToLowerInvariant(),
            outcome.Status is BatchStatus.NotStarted or BatchStatus.Interrupted ? "" : NumberFormatter.Format(outcome.Code),
            outcome.ErrorCode, outcome.Error, .. outcome.Figures.Count > 0 ? outcome.Figures : FigureNames.Select(_ => ""),
            outcome.Status == BatchStatus.NotStarted ? "" : NumberFormatter.Format(outcome.Seconds, 3), outcome.Fingerprint,
        ];
}
