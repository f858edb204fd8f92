using Caterpillar.Basics;

namespace Caterpillar.Turtles;

/// <summary>The lines that a program prints.</summary>
internal sealed class ScriptPrints
{
    /// <summary>The most lines that a program may print; more are counted.</summary>
    public const int Max = 10_000;

    private readonly List<Diagnostic> _lines = [];
    private long _more;

    public void Add(string text, SourceLocation place)
    {
        if (_lines.Count < Max) _lines.Add(new Diagnostic(Severity.Note, TurtleScript.PrintCode, text, place));
        else _more++;
    }

    /// <summary>Line by line, and how many are left out.</summary>
    public IEnumerable<Diagnostic> All()
    {
        foreach (var line in _lines) yield return line;
        if (_more > 0)
        {
            yield return new Diagnostic(Severity.Note, "turtle.print_limit",
                $"{NumberFormatter.Format(_more)} more lines are not shown: a program prints up to {NumberFormatter.Format(Max)}.");
        }
    }
}
