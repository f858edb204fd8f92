namespace Caterpillar.Basics;

/// <summary>How serious a <see cref="Diagnostic"/> is.</summary>
public enum Severity
{
    /// <summary>For information. The result is complete.</summary>
    Note,

    /// <summary>The result exists, but needs attention.</summary>
    Warning,

    /// <summary>The result is missing or must not be used.</summary>
    Error,
}

/// <summary>
/// Source of a <see cref="Diagnostic"/>. Any part may be missing. Lines and columns count from 1; steps, moves and layers from 0. The origin is the
/// source in the design: a line of a script, an entry of a curve file, an object and its layer.
/// </summary>
public sealed record SourceLocation(
    string? File = null, int? Line = null, int? Column = null, string? Key = null, int? Step = null, int? Move = null, SourceLocation? Origin = null,
    int? Layer = null)
{
    /// <summary>For example <c>part.gcode:12:4</c>, <c>ender3.json: layer_height_mm</c>, <c>vase.stl, layer 12</c> or <c>move 731</c>.</summary>
    public override string ToString()
    {
        var text = new StringBuilder();
        if (Origin is not null) text.Append(Origin).Append(" -> ");
        var begin = text.Length;
        text.Append(LongWords.OneLine(File));
        if (Line is { } line) text.Append(text.Length > begin ? ":" : "line ").Append(NumberFormatter.Format(line));
        if (Column is { } column) text.Append(':').Append(NumberFormatter.Format(column));
        if (Key is not null) text.Append(text.Length > begin ? ": " : "").Append(LongWords.Shorten(LongWords.OneLine(Key)));
        if (Layer is { } layer) text.Append(text.Length > begin ? ", " : "").Append("layer ").Append(NumberFormatter.Format(layer));
        if (Step is { } step) text.Append(text.Length > begin ? ", " : "").Append("step ").Append(NumberFormatter.Format(step));
        if (Move is { } move) text.Append(text.Length > begin ? ", " : "").Append("move ").Append(NumberFormatter.Format(move));
        return text.ToString();
    }
}

/// <summary>A problem in the input: what is wrong and where. Problems of the same kind are reported once, with a count.</summary>
/// <param name="Severity">How serious it is.</param>
/// <param name="Code">Kind of problem as <c>subject.problem</c>, for example <c>bed.outside</c> or <c>mesh.naked_edges</c>.</param>
/// <param name="Message">A sentence, with units.</param>
/// <param name="Source">Location of the first occurrence.</param>
/// <param name="Count">Number of occurrences.</param>
public sealed record Diagnostic(Severity Severity, string Code, string Message, SourceLocation? Source = null, int Count = 1)
{
    /// <summary>A sentence for the user, with units. Long quotations are shortened.</summary>
    public string Message { get; init; } = LongWords.Shorten(Message);

    /// <summary>The worst of several occurrences, if known and not the first.</summary>
    public Diagnostic? Worst { get; init; }

    /// <summary>Occurrences as a share of all moves, 0 to 1. 0 = unknown.</summary>
    public double Share { get; init; }

    /// <summary>The same with another source, also for the worst.</summary>
    internal Diagnostic WithSource(Func<SourceLocation?, SourceLocation?> change)
        => this with { Source = change(Source), Worst = Worst?.WithSource(change) };

    /// <summary>For example <c>part.stl: warning mesh.naked_edges: 12 naked edges. (3 times)</c>.</summary>
    public override string ToString()
    {
        var text = new StringBuilder();
        var source = Source?.ToString();
        if (!string.IsNullOrEmpty(source)) text.Append(source).Append(": ");
        text.Append(Severity switch { Severity.Error => "error ", Severity.Warning => "warning ", _ => "note " });
        text.Append(Code).Append(": ").Append(Message);
        if (Count > 1) text.Append(" (").Append(NumberFormatter.Format(Count)).Append(" times").Append(ShareText()).Append(WorstText()).Append(')');
        return text.ToString();
    }

    private string ShareText() => Share >= 0.0005 ? $", {NumberFormatter.Format(Share * 100, 1)} % of the moves" : "";

    private string WorstText() => Worst is null ? "" : $", the worst: {(Worst.Source is { } place ? place + ": " : "")}{Worst.Message}";
}
