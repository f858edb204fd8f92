using Caterpillar.Checks;

namespace Caterpillar.Cli;

/// <summary>A G-code file that was written, and what the checks found in it.</summary>
internal sealed record WrittenFile(WrittenGCode GCode, IReadOnlyList<Diagnostic> Findings);
