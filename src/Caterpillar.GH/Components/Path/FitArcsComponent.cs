namespace Caterpillar.GH.Components.Path;

/// <summary>Replaces runs of segments with arcs.</summary>
public sealed class FitArcsComponent() : CaterpillarComponent(
    "Fit Arcs", "FitArcs",
        "Replaces straight segments with flat or helical arcs within a tolerance, for smaller and smoother G-code.", Panel.Path, GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("ce1b33da-ca9c-4052-913f-de8e63260a7c");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Number("Tolerance", "T", "Maximum distance between an arc and the segments it replaces, in mm.", 0.02);
    }

    private protected override void Outputs(OutputPorts ports)
        => ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths with arcs.", GH_ParamAccess.list);

    private protected override void Solve(Run run)
    {
        var paths = run.Paths(0);
        var tolerance = run.Positive(1);
        var fitted = run.Work("Fitting arcs", [tolerance, paths], (progress, cancel) => Fit(paths.Goos, tolerance, progress, cancel));
        run.SetList(0, fitted.Paths);
        run.Summarize($"{NumberFormatter.Format(fitted.Before)} → {NumberFormatter.Format(fitted.After)} segments");
    }

    private static Fitted Fit(IReadOnlyList<PrintPathGoo> paths, double tolerance, IProgress<double> progress, CancellationToken cancel)
    {
        var fitted = new PrintPathGoo[paths.Count];
        for (var i = 0; i < fitted.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            fitted[i] = paths[i].With(PathArcs.Fit(paths[i].Value, tolerance));
            progress.Report((i + 1.0) / fitted.Length);
        }
        return new Fitted(fitted, paths.Sum(p => (long)p.Value.SegmentCount), fitted.Sum(p => (long)p.Value.SegmentCount));
    }

    private sealed record Fitted(PrintPathGoo[] Paths, long Before, long After);
}
