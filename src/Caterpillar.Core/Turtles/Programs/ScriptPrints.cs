namespace Caterpillar.Turtles;

/// <summary>The lines that a program prints.</summary>
internal sealed class ScriptPrints
{
    /// <summary>Maximum number of printed lines. More are only counted.</summary>
    public const int Max = 10_000;

    private readonly List<Diagnostic> _lines = [];
    private long _more;

    public void Add(string text, SourceLocation place)
    {
        if (_lines.Count < Max) _lines.Add(new Diagnostic(Severity.Note, TurtleScript.PrintCode, text, place));
        else _more++;
    }

    /// <summary>The lines, and the number of lines that are left out.</summary>
    public IEnumerable<Diagnostic> All()
    {
        foreach (var line in _lines) yield return line;
        if (_more > 0)
        {
            yield return new Diagnostic(Severity.Note, "turtle.print_limit",
                $"Lines not shown: {NumberFormatter.Format(_more)}. A program can print up to {NumberFormatter.Format(Max)} lines.");
        }
    }
}
