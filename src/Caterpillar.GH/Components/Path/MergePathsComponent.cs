namespace Caterpillar.GH.Components.Path;

/// <summary>Joins paths whose ends touch.</summary>
public sealed class MergePathsComponent() : CaterpillarComponent(
    "Merge Paths", "Merge", "Joins print paths whose ends touch, if their role, layer, tool and name are equal. Also joins segments that are too "
        + "short to print smoothly.", Panel.Path, GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("53edb3ac-450f-4275-a38f-0ca4dd43c9b1");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Number("Tolerance", "T", "Maximum gap to close, in mm.", 0.01);
        ports.Number("Minimum Length", "M", "Shorter segments are joined to the next one, with the mean area of both, in mm. 0 = keep all.", 0);
        ports.Boolean("Reverse", "Re", "Reverse paths if that makes them fit.", false);
    }

    private protected override void Outputs(OutputPorts ports)
        => ports.Add(new PrintPathParam(), "Print Paths", "P", "Joined print paths.", GH_ParamAccess.list);

    private protected override void Solve(Run run)
    {
        var paths = run.Paths(0);
        var (tolerance, least, reverse) = (run.Finite(1), run.NotNegative(2), run.Get<bool>(3));
        var merged = run.Work("Merging", [paths, tolerance, least, reverse],
            (_, _) => PathMerging.Merge(paths.Paths, tolerance, reverse).Select(p => new PrintPathGoo(PathMerging.JoinShort(p, least), paths.Goos[0].Setup))
                .ToArray());
        run.SetList(0, merged);
        run.Summarize($"{NumberFormatter.Format(paths.Count)} → {NumberFormatter.Format(merged.Length)} paths");
    }
}
