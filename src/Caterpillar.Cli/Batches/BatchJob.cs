namespace Caterpillar.Cli;

/// <summary>One run of a batch.</summary>
/// <param name="Number">Its number in the whole list, from 1.</param>
/// <param name="Inputs">Its input files.</param>
/// <param name="Cells">Its row of the table; empty without one.</param>
/// <param name="Output">Its output file, or null.</param>
/// <param name="Words">Its command line, without verb, output and threads.</param>
internal sealed record BatchJob(int Number, IReadOnlyList<string> Inputs, IReadOnlyList<string> Cells, string? Output, IReadOnlyList<string> Words);
