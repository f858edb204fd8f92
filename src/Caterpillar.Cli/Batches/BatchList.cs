namespace Caterpillar.Cli;

/// <summary>Makes the list of runs of a command line, and checks it before any work begins.</summary>
internal sealed class BatchList(Verb verb, ParseResult parsed, Session session)
{
    private readonly BatchOptions _options = verb.Batch!;

    /// <summary>The columns of the table, if any.</summary>
    public IReadOnlyList<string> Columns { get; private set; } = [];

    /// <exception cref="CliException">Options cannot be combined, or a file is missing.</exception>
    public IReadOnlyList<BatchJob> Jobs()
    {
        var table = parsed.GetValue(_options.Table) is { } file ? Table(file) : null;
        Columns = table?.Columns ?? [];
        var inputs = Inputs();
        var output = verb.Options.FirstOrDefault(o => o.Name == "--output") is Option<string?> option ? parsed.GetValue(option) : null;
        if (output == "-")
            throw CliException.Usage("Several outputs cannot go to standard output. Give a pattern, such as -o 'out/{name}" + verb.Ending + "'.");
        var pattern = verb.Ending is { } ending && !verb.ReplacesInput(parsed) ? new OutputPattern(output, ending, table) : null;
        var shared = _options.Shared(parsed, verb).ToArray();
        var jobs = new List<BatchJob>();
        foreach (var files in inputs)
        {
            for (var row = 1; row <= (table?.Rows.Count ?? 1); row++)
            {
                var cells = table?.Rows[row - 1] ?? [];
                string[] words = [.. files.Select(Safe), .. shared, .. table is null ? [] : RowWords(table.Columns, cells)];
                jobs.Add(new BatchJob(jobs.Count + 1, files, cells, pattern?.For(files[0], row, table), words));
            }
        }
        if (jobs.Count == 0) throw new CliException(ExitCode.BadInput, "Nothing to do: the table has no rows.");
        CheckOutputs(jobs, pattern);
        return _options.PartOf(jobs, parsed);
    }

    private IReadOnlyList<IReadOnlyList<string>> Inputs()
    {
        var named = parsed.CommandResult.Children.OfType<ArgumentResult>().SelectMany(a => a.Tokens).Select(t => t.Value).ToArray();
        if (parsed.GetResult(_options.Each) is not { Implicit: false }) return [named];
        if (named.Length > 0) throw CliException.Usage($"{named[0]} cannot be combined with --each. Put it after --each.");
        return FilePattern.Files(parsed.GetValue(_options.Each) ?? []).Select(f => new[] { f }).ToArray();
    }

    private CsvTable Table(string file)
    {
        var text = System.Text.Encoding.UTF8.GetString(session.ReadBytes(file));
        var table = CsvTable.Parse(text, Session.NameOf(file));
        foreach (var column in table.Columns.Where(c => c != "name"))
        {
            if (column.StartsWith("--", StringComparison.Ordinal) && verb.Options.All(o => o.Name != column.Split(' ')[0]))
                throw CliException.Usage($"{file}: {verb.Name} has no option {column}. Rename the column.");
            if (!column.StartsWith('-') && Option(column) is null)
                throw CliException.Usage($"{file}: {verb.Name} has no settings, so column \"{column}\" must be an option, such as --{column}.");
        }
        return table;
    }

    // An empty cell keeps the default.
    private IEnumerable<string> RowWords(IReadOnlyList<string> columns, IReadOnlyList<string> cells)
    {
        for (var i = 0; i < columns.Count; i++)
        {
            if (columns[i] == "name" || cells[i].Length == 0) continue;
            var parts = columns[i].Split(' ', 2, StringSplitOptions.TrimEntries);
            var isOption = columns[i].StartsWith("--", StringComparison.Ordinal);
            yield return isOption ? parts[0] : Option(columns[i])!;
            yield return !isOption ? $"{columns[i]}={cells[i]}" : parts.Length > 1 ? $"{parts[1]}={cells[i]}" : cells[i];
        }
    }

    // A parameter of a turtle program, or a key of the profiles.
    private string? Option(string column)
    {
        var isKey = ProfileKeys.All.Any(k => k.Name == column);
        string[] order = isKey ? ["--set", "--var"] : ["--var", "--set"];
        return order.FirstOrDefault(name => verb.Options.Any(o => o.Name == name));
    }

    // File names that look like options.
    private static string Safe(string file) => file.StartsWith('-') && file.Length > 1 ? "./" + file : file;

    private static void CheckOutputs(List<BatchJob> jobs, OutputPattern? pattern)
    {
        if (pattern is null) return;
        // Names that differ only in case are one file on many systems.
        var writers = new Dictionary<string, BatchJob>(StringComparer.OrdinalIgnoreCase);
        foreach (var job in jobs)
        {
            if (!writers.TryAdd(Path.GetFullPath(job.Output!), job))
            {
                throw CliException.Usage($"--output {pattern}: two outputs would be named {job.Output}. "
                    + (job.Cells.Count > 0 ? "Add {row} or a column." : "Add {name} or {folder}."));
            }
        }
        foreach (var input in jobs.SelectMany(j => j.Inputs))
        {
            if (writers.ContainsKey(Path.GetFullPath(input)))
                throw CliException.Usage($"--output {pattern} would replace the input {input}. Give another name.");
        }
    }
}
