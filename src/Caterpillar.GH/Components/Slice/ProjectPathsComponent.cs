namespace Caterpillar.GH.Components.Slice;

/// <summary>Puts paths that were made for a level bed onto an object.</summary>
public sealed class ProjectPathsComponent() : CaterpillarComponent(
    "Project Paths", "Project", "Projects print paths for a level bed at Z = 0 onto an object. Heights above the bed become heights above "
        + "its surface.", Panel.Slice, GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("a9d6b1f0-84c7-4e2b-bd35-7f1e0c9a5d64");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Geometry("Geometry", "G", "Objects to print on: meshes, Breps, SubDs, extrusions or surfaces. Default: what the setup prints "
            + "on.", GH_ParamAccess.list, optional: true);
        ports.Setup("Used for tolerance and maximum slope, which its print head limits. Default: as the print paths were made with, else generic.");
        ports.Number("Offset", "O", "Distance of the paths above the surface, in mm. Negative values press them onto it.", 0);
        ports.Boolean("Partial", "Pa", "Leave out parts that are beyond the surface or too steep, instead of refusing the paths.", false);
        ports.MeshTolerance();
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths on the surface. Paths that leave it are split.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var goos = run.Some<PrintPathGoo>(0);
        var setup = SetupPort.Of(run, 2, goos.Select(g => g.Setup));
        var (offset, partial) = (run.Finite(3), run.Get<bool>(4));
        var onto = run.Models(1, run.Positive(5));
        if (onto.Length == 0 && setup.PrintedOn is null) throw run.Missing(1);
        object[] paths = goos.Select(g => (object)g.Value).ToArray();
        var result = run.Work("Projecting", [paths, onto, offset, setup, partial], (progress, cancel) =>
        {
            var surface = PlanSurface.Of(ModelMesh.Joined(onto) ?? setup.PrintedOn!).Moved(new Vec3(0, 0, Math.Max(0, offset)));
            var steps = goos.Select(g => (Step)g.ToStep()).ToArray();
            return SurfaceProjection.Project(steps, surface, setup, Math.Max(0, -offset), partial, progress, cancel);
        });
        run.SetList(0, run.Require(result).OfType<PathStep>().Select(s => new PrintPathGoo(s, setup)));
    }
}
