namespace Caterpillar.Cli;

/// <summary>One call of a batch.</summary>
/// <param name="Number">Its place in the whole list, from 1.</param>
/// <param name="Inputs">The files it reads.</param>
/// <param name="Cells">Its row of the table; empty without one.</param>
/// <param name="Output">What it writes; null where it writes no file.</param>
/// <param name="Words">The command line after the verb, but for output and threads.</param>
internal sealed record BatchJob(int Number, IReadOnlyList<string> Inputs, IReadOnlyList<string> Cells, string? Output, IReadOnlyList<string> Words);
