namespace Caterpillar.Checks;

/// <summary>What the decoder notices in a file that is written, without what the checks say themselves.</summary>
internal static class DecodingNotes
{
    private static readonly string[] SaidByChecks = [CommandLog.NotUnderstood, "gcode.ignored"];

    /// <summary>The diagnostics of a file. Those that it had before it was edited are known already.</summary>
    public static IEnumerable<Diagnostic> Of(DecodedGCode file, DecodedGCode? before)
        => file.Problems.Where(d => !SaidByChecks.Contains(d.Code) && !(before?.Problems.Any(b => b.Code == d.Code && b.Count >= d.Count) ?? false));
}
