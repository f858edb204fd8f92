namespace Caterpillar.GH.Components.Path;

/// <summary>Base of the components that change the shape or the beads of print paths: paths first, paths and diagnostics out.</summary>
public abstract class PathShapingComponent(string name, string nickname, string description)
    : ChosenPortsComponent(name, nickname, description, Panel.Path, GH_Exposure.secondary)
{
    private protected sealed override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths, in the same order. Null if the result is invalid.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    /// <summary>Speed of paths that have none of their own, mm/s: that of their setup.</summary>
    private protected static double SpeedOf(PathList paths) => (paths.Goos[0].Setup?.Settings ?? new PrintSettings()).PrintSpeed;

    /// <summary>The new paths with the groups of the old ones.</summary>
    private protected static void SetPaths(Run run, PathList before, Shaped shaped)
    {
        run.Report(shaped.Diagnostics);
        run.SetList(0, run.Cached([before, shaped], () => shaped.Paths.Select((path, i) => path is null ? null : before.Goos[i].With(path)).ToArray()));
    }

    /// <summary>Paths in the coordinates of a frame. Unchanged for the world frame.</summary>
    private protected static PrintPath[] ToLocal(IEnumerable<PrintPath> paths, Frame frame)
        => frame == Frame.World ? paths.ToArray() : paths.Select(p => p.Transformed(Affine.ToFrame(frame))).ToArray();

    private protected static PrintPath ToWorld(PrintPath path, Frame frame) => frame == Frame.World ? path : path.Transformed(Affine.FromFrame(frame));

    /// <summary>The result for the paths.</summary>
    private protected sealed record Shaped(IReadOnlyList<PrintPath?> Paths, IReadOnlyList<Diagnostic> Diagnostics)
    {
        public static Shaped Of(Result<IReadOnlyList<PrintPath>> result, Frame frame)
            => new(result.Value?.Select(p => ToWorld(p, frame)).ToArray() ?? [], result.Diagnostics);
    }
}
