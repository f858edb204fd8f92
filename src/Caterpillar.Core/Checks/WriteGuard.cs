using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>The checks before G-code is written, and whether a reason overrides what they found.</summary>
internal sealed class WriteGuard
{
    private readonly Diagnostic[] _errors;
    private readonly IReadOnlyList<Diagnostic> _findings;
    private readonly string? _reason;

    private WriteGuard(IReadOnlyList<Diagnostic> findings, string? reason)
    {
        _findings = findings;
        _reason = reason;
        _errors = findings.Where(d => d.Severity == Severity.Error).ToArray();
    }

    /// <summary>Number of findings that would have stopped the file and are overridden.</summary>
    public int Overridden => _errors.Sum(e => e.Count);

    /// <summary>True where a finding stops the file.</summary>
    public bool Refuses => _errors.Length > 0 && !IsReason;

    // A word has a letter; "1" or "!!!" say nothing to the one who reads the file later.
    private bool IsReason => _reason is not null && _reason.Any(char.IsLetter);

    public static WriteGuard Check(Toolpath toolpath, PrintSetup setup, string? reason, IProgress<double>? progress, CancellationToken cancel)
        => new(LimitCheck.Run(toolpath, setup, progress, cancel), reason);

    /// <summary>What to say where nothing is written, with what else went wrong.</summary>
    public IReadOnlyList<Diagnostic> Refusal(IReadOnlyList<Diagnostic> others)
    {
        var list = new DiagnosticList();
        list.AddRange(_findings);
        list.AddRange(others);
        list.Add(Severity.Error, SafeWriter.Refused, _reason is null || IsReason ? "Nothing was written." : "An override needs a reason in words.");
        return list.ToList();
    }

    /// <summary>What to say where it is written, with what else was noticed: overridden errors are warnings.</summary>
    public IReadOnlyList<Diagnostic> Remarks(IReadOnlyList<Diagnostic> others)
    {
        var list = new DiagnosticList();
        list.AddRange(_findings.Select(d => d.Severity == Severity.Error ? d with { Severity = Severity.Warning } : d));
        list.AddRange(others);
        return list.ToList();
    }

    /// <summary>The reason and what it overrides, as comments for the file; none where nothing was found.</summary>
    public IReadOnlyList<string> Comments()
    {
        if (_errors.Length == 0) return [];
        var reason = string.Join(" ", _reason!.Split([' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries));
        return ["Written in spite of these findings. Reason: " + reason, .. _errors.Select(e => e.ToString())];
    }
}
