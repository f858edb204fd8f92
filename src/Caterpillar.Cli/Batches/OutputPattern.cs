namespace Caterpillar.Cli;

/// <summary>Names of outputs: text with <c>{name}</c>, <c>{input}</c>, <c>{folder}</c>, <c>{row}</c> and the columns of the table.</summary>
internal sealed partial class OutputPattern
{
    private readonly string _pattern;

    /// <param name="given">The value of -o: a pattern or a folder; null = the same names as for single runs.</param>
    /// <param name="ending">The usual extension of the output.</param>
    /// <param name="table">The table, or null.</param>
    /// <exception cref="CliException">It has an unknown placeholder (wrong usage).</exception>
    public OutputPattern(string? given, string ending, CsvTable? table)
    {
        var usual = (table is null ? "{input}" : table.Columns.Contains("name") ? "{input}_{name}" : "{input}_{row}") + ending;
        _pattern = given is null ? usual : given.EndsWith('/') || given.EndsWith('\\') || Directory.Exists(given) ? Path.Combine(given, usual) : given;
        string[] known = ["name", "input", "folder", .. table is null ? (string[])[] : ["row", .. table.Columns]];
        foreach (var part in Parts().Matches(_pattern).Select(m => m.Groups[1].Value))
        {
            if (!known.Contains(part))
                throw CliException.Usage(
                    $"--output {_pattern}: unknown placeholder {{{part}}}. Placeholders: {string.Join(", ", known.Select(k => $"{{{k}}}"))}.");
        }
    }

    /// <param name="input">The first input.</param>
    /// <param name="row">The number of the row, from 1.</param>
    /// <param name="table">The table, or null.</param>
    public string For(string input, int row, CsvTable? table)
    {
        var name = Path.GetFileNameWithoutExtension(GzipReader.PlainName(input));
        var values = new Dictionary<string, string>(StringComparer.Ordinal)
        {
            ["input"] = name, ["name"] = name, ["folder"] = Path.GetDirectoryName(input) is { Length: > 0 } folder ? folder : ".",
        };
        if (table is not null)
        {
            var digits = Basics.NumberFormatter.Format(table.Rows.Count).Length;
            values["row"] = Basics.NumberFormatter.Format(row).PadLeft(digits, '0');
            for (var i = 0; i < table.Columns.Count; i++) values[table.Columns[i]] = Plain(table.Rows[row - 1][i]);
        }
        return Parts().Replace(_pattern, part => values[part.Groups[1].Value]);
    }

    public override string ToString() => _pattern;

    // A value is part of a name and cannot change the folder.
    private static string Plain(string value)
    {
        var plain = string.Concat(value.Select(c => c < ' ' || "/\\:*?\"<>|".Contains(c, StringComparison.Ordinal) ? '_' : c));
        return plain is "." or ".." ? "_" : plain;
    }

    [GeneratedRegex(@"\{([^{}]*)\}")]
    private static partial Regex Parts();
}
