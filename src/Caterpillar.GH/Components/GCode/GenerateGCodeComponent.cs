namespace Caterpillar.GH.Components.GCode;

/// <summary>Checks a toolpath and writes it as G-code.</summary>
public sealed class GenerateGCodeComponent() : CaterpillarComponent(
    "Generate G-code", "GCode", "Checks a toolpath against the printer and writes G-code. Toolpaths that could damage the machine are refused.", Panel.GCode,
    GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("a6c5f777-8567-40ff-8b2c-76e275996590");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Setup("Default: as used for planning.");
        ports.Text("Override Reason", "R", "Reason to ignore errors of the checks, written to the file as a comment. Empty = obey the checks.", "");
        ports.Boolean("Rewrite All", "A",
            "Rewrite a decoded file completely, with the printer's start and end G-code. Otherwise, unedited lines stay as they are.", false);
        ports.Text("Start G-code", "SC", "G-code that replaces everything before the first layer of a decoded file. Default: unchanged.", optional: true);
        ports.Text("End G-code", "EC", "G-code that replaces everything after the last layer of a decoded file. Default: unchanged.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new GCodeParam(), "G-code", "G", "G-code, as one value.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var reason = run.Maybe<string>(2);
        var setup = WrittenToolpath.SetupOf(run, 1, goo);
        if (string.IsNullOrWhiteSpace(reason)) reason = null;
        var rewriteAll = run.Get<bool>(3) || goo.DecodedGCode is null;
        var (start, end) = (run.Maybe<string>(4), run.Maybe<string>(5));
        if (rewriteAll && (start ?? end) is not null)
        {
            run.Report(GH_RuntimeMessageLevel.Warning,
                "Start G-code and End G-code have no effect: the file is rewritten with the G-code of its printer.");
        }
        var code = new EditOptions { Start = start is null ? null : Lines(start), End = end is null ? null : Lines(end) };
        var result = run.Work("Writing", [goo.Value, setup, reason, rewriteAll, start, end],
            (progress, cancel) => WrittenToolpath.Write(goo, setup, reason, rewriteAll, code, progress, cancel));
        var document = run.Accept(result);
        run.Set(0, document is null ? null : new GCodeGoo { Value = document });
        run.Summarize(document is null ? "refused" : $"{NumberFormatter.Format(document.LineCount)} lines");
    }

    // The lines of a text from a Panel, without empty lines at the end.
    private static string[] Lines(string text) => text.TrimEnd('\r', '\n').Split('\n').Select(line => line.TrimEnd('\r')).ToArray();
}
