namespace Caterpillar.GH.Components.GCode;

/// <summary>A toolpath as checked G-code.</summary>
internal static class WrittenToolpath
{
    /// <summary>The setup to write for. Nothing is written for a printer that nobody chose.</summary>
    /// <exception cref="InputProblem">No setup is known.</exception>
    public static PrintSetup SetupOf(Run run, int input, ToolpathGoo toolpath)
    {
        if (toolpath.Setup is null && (input < 0 || run.Maybe<PrintSetup>(input) is null))
            throw new InputProblem("Setup is missing. The toolpath was not planned with one: connect Print Setup.") { IsMissing = true };
        return SetupPort.Of(run, input, toolpath);
    }

    /// <summary>The document. Unedited lines of a decoded file stay as they are, unless all is rewritten.</summary>
    public static Result<GCodeDocument> Write(
        ToolpathGoo toolpath, PrintSetup setup, string? reason, bool rewriteAll, EditOptions code, IProgress<double> progress, CancellationToken cancel)
        => rewriteAll || toolpath.DecodedGCode is not { } file
            ? SafeWriter.ToDocument(toolpath.Value, setup, reason, progress, cancel, isChecked: setup.Equals(toolpath.CheckedWith))
            : SafeWriter.ToDocument(file, toolpath.Value, setup, reason, code, progress, cancel);
}
