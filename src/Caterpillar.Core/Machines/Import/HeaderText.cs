namespace Caterpillar.Machines;

/// <summary>A header or footer: its valid lines, facts and errors.</summary>
internal sealed class HeaderText(string file, DiagnosticList problems)
{
    private readonly List<HeaderLine> _lines = [];

    public HeaderFacts Facts { get; } = new();

    /// <summary>The lines. Invalid lines are kept as comments. The second side of a merge conflict is dropped.</summary>
    public IReadOnlyList<HeaderLine> Lines => _lines;

    public static HeaderText Read(string text, string file, DiagnosticList problems)
    {
        var header = new HeaderText(file, problems);
        header.Read(text.Split(["\r\n", "\n", "\r"], StringSplitOptions.None));
        return header;
    }

    public SourceLocation Place(int line, int? column = null) => new(file, line, column);

    private void Read(string[] texts)
    {
        // The first side of a merge conflict counts.
        var side = 0;
        var count = texts.Length;
        while (count > 0 && texts[count - 1].Trim().Length == 0) count--;
        for (var i = 0; i < count; i++)
        {
            var text = texts[i].TrimEnd();
            if (IsMarker(text, '<') || (IsMarker(text, '=') && side > 0) || IsMarker(text, '>'))
            {
                side = text[0] switch { '<' => 1, '=' => 2, _ => 0 };
                problems.Add(Severity.Warning, "header.merge_conflict",
                    "Merge conflict markers. The first version of each conflict is used.", Place(i + 1));
                continue;
            }
            if (side == 2) continue;
            var line = HeaderLine.Read(text);
            if (line.Error is { } error)
            {
                problems.Add(Severity.Warning, error.Code, error.Message + " The line is kept as a comment.", Place(i + 1, error.Column));
                line = HeaderLine.Read("; invalid: " + text.Trim());
            }
            Facts.Follow(line);
            _lines.Add(line);
        }
    }

    private static bool IsMarker(string text, char c) => text.StartsWith(new string(c, 7), StringComparison.Ordinal) && (text.Length == 7 || text[7] == ' ');
}
