namespace Caterpillar.GH.Components.Simulate;

/// <summary>Checks a toolpath against a printer.</summary>
public sealed class CheckComponent() : CaterpillarComponent(
    "Check", "Check", "Checks a toolpath against its printer: positions, collisions, extrusions, speeds, flow and temperatures.", Panel.Simulate,
    GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("5f3ef7a5-7d2b-4d0f-b2f4-6a2f4b0c8d04");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Setup("Default: as used for planning, else the limits in the file.");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam { Hidden = true }, "Checked Toolpath", "T", "Toolpath, if no check found an error. Otherwise null.");
        ports.Add(new Param_Boolean(), "OK", "OK", "True if no check found an error.");
        ports.Diagnostics();
        ports.Add(new Param_Point(), "Points", "P", "First position of each problem.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var setup = SetupPort.Of(run, 1, goo);
        var findings = run.Work("Checking", [goo.Value, goo.DecodedGCode, setup], (progress, cancel) => Findings(goo, setup, progress, cancel));
        var passed = findings.All(f => f.Severity != Severity.Error);
        run.Set(0, passed ? goo.Checked(setup) : null);
        run.Set(1, passed);
        run.Report(findings);
        run.SetList(3, findings.Where(f => f.Source?.Move is not null).Select(f => RhinoGeometry.ToPoint(goo.Value[f.Source!.Move!.Value].End, run.Units)));
        run.Summarize(passed ? "OK" : $"{NumberFormatter.Format(findings.Where(f => f.Severity == Severity.Error).Sum(f => f.Count))} errors");
    }

    // A file as it was read heats by itself; an edit of it is checked move by move.
    private static IReadOnlyList<Diagnostic> Findings(ToolpathGoo goo, PrintSetup setup, IProgress<double> progress, System.Threading.CancellationToken cancel)
        => goo.DecodedGCode is not { } file ? PrintCheck.Run(goo.Value, setup, progress, cancel)
            : ReferenceEquals(file.Toolpath, goo.Value) ? PrintCheck.Run(file, setup, progress, cancel)
            : PrintCheck.Run(goo.Value, PrintCheck.SetupForFile(setup, goo.Value), progress, cancel);
}
