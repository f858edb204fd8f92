using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

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
    {
        if (frame == Frame.World) return paths.ToArray();
        var map = new Affine(new Vec3(frame.X.X, frame.Y.X, frame.Z.X), new Vec3(frame.X.Y, frame.Y.Y, frame.Z.Y), new Vec3(frame.X.Z, frame.Y.Z, frame.Z.Z),
            frame.ToLocal(Vec3.Zero));
        return paths.Select(p => p.Transformed(map)).ToArray();
    }

    private protected static PrintPath ToWorld(PrintPath path, Frame frame) => frame == Frame.World ? path : path.Transformed(Affine.FromFrame(frame));

    /// <summary>The result for the paths.</summary>
    private protected sealed record Shaped(IReadOnlyList<PrintPath?> Paths, IReadOnlyList<Diagnostic> Diagnostics)
    {
        public static Shaped Of(Result<IReadOnlyList<PrintPath>> result, Frame frame)
            => new(result.Value?.Select(p => ToWorld(p, frame)).ToArray() ?? [], result.Diagnostics);
    }
}
