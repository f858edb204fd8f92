namespace Caterpillar.Checks;

/// <summary>Findings of the checks before G-code is written, and the reason that overrides them.</summary>
internal sealed class WriteGuard(IReadOnlyList<Diagnostic> findings, string? reason)
{
    private readonly Diagnostic[] _errors = findings.Where(d => d.Severity == Severity.Error).ToArray();

    /// <summary>Number of findings that would have stopped the file and are overridden.</summary>
    public int Overridden => _errors.Sum(e => e.Count);

    /// <summary>True if a finding stops the file.</summary>
    public bool Refuses => _errors.Length > 0 && !IsReason(reason);

    /// <summary>True if a reason has words. A reason without letters ("1", "!!!") does not help later readers of the file.</summary>
    public static bool IsReason(string? reason) => reason is not null && reason.Any(char.IsLetter);

    /// <summary>The diagnostics of a refused file, with other errors.</summary>
    public IReadOnlyList<Diagnostic> Refusal(IReadOnlyList<Diagnostic> others)
    {
        var list = new DiagnosticList();
        list.AddRange(findings);
        list.AddRange(others);
        list.Add(Severity.Error, SafeWriter.Refused, reason is null || IsReason(reason) ? "Nothing was written." : "An override needs a reason in words.");
        return list.ToList();
    }

    /// <summary>The diagnostics of a written file, with other notes. Overridden errors are warnings.</summary>
    public IReadOnlyList<Diagnostic> Notes(IReadOnlyList<Diagnostic> others)
    {
        var list = new DiagnosticList();
        list.AddRange(findings.Select(d => Shifted(d.Severity == Severity.Error ? d with { Severity = Severity.Warning } : d)));
        list.AddRange(others);
        return list.ToList();
    }

    /// <summary>The reason and the overridden errors, as comments for the file; none without errors.</summary>
    public IReadOnlyList<string> Comments()
    {
        if (_errors.Length == 0) return [];
        var words = string.Join(" ", reason!.Split([' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries));
        return ["Written despite these findings. Reason: " + words, .. _errors.Select(e => Shifted(e).ToString())];
    }

    // The comments, the reason and one for each error, stand before everything that the lines of the findings are counted in.
    private Diagnostic Shifted(Diagnostic finding)
    {
        var shift = _errors.Length > 0 ? _errors.Length + 1 : 0;
        return finding.WithSource(s => s?.Line is { } line && s.File is null ? s with { Line = line + shift } : s);
    }
}
