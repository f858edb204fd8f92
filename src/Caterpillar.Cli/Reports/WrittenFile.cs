namespace Caterpillar.Cli;

/// <summary>A written G-code file and the findings of the checks.</summary>
internal sealed record WrittenFile(WrittenGCode GCode, IReadOnlyList<Diagnostic> Findings);
