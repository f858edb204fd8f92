namespace Caterpillar.GH.Components.Path;

/// <summary>Gives print paths beads that fill the gap below them.</summary>
public sealed class GapBeadComponent() : CaterpillarComponent(
    "Gap Bead", "Gap", "Gives print paths beads that fill the gap to earlier paths, a surface or the bed below them.", Panel.Path)
{
    // Deviation of the facets of a curved surface, mm.
    private const double Tolerance = 0.05;

    public override Guid ComponentGuid => new("7c3b1f86-2d94-4c0e-8f6a-0e5a9d41b2c7");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Geometry("Geometry", "G", "Objects below the paths: meshes, Breps, SubDs, extrusions or surfaces. Default: what the setup prints "
            + "on.", GH_ParamAccess.list, optional: true);
        ports.Setup("Used for the limits of the gap. Default: as the print paths were made with, else generic.");
        ports.Number("Minimum Gap", "Min",
            "Minimum gap, in mm. Smaller gaps are printed as if they were this high. Default: a quarter of the layer height.", optional: true);
        ports.Number("Maximum Gap", "Max",
            "Maximum gap, in mm. Larger gaps are printed as if they were this high. Default: twice the layer height.", optional: true);
        ports.Number("Width", "W", "Line width, in mm. 0 = width of each bead.", 0);
        ports.Boolean("Bed", "B", "Fill the gap to the bed (Z = 0) as well.", true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths with new beads. Segments over an uneven gap are divided.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var paths = run.Paths(0);
        _ = run.Units;
        var below = run.Models(1, Tolerance);
        var setup = SetupPort.Of(run, 2, paths.Goos.Select(g => g.Setup));
        var gap = GapBead.For(setup.Settings) with { Width = run.Finite(5), Bed = run.Get<bool>(6) ? 0 : null };
        if (run.MaybeValue<double>(3) is not null) gap = gap with { MinGap = run.Positive(3) };
        if (run.MaybeValue<double>(4) is not null) gap = gap with { MaxGap = run.Positive(4), AirGap = Math.Max(gap.AirGap, 2 * run.Positive(4)) };
        if (gap.MinGap > gap.MaxGap) throw new InputProblem("Minimum Gap must not be greater than Maximum Gap.");
        var result = run.Work("Measuring gaps", [paths, .. below, gap, setup.PrintedOn],
            (progress, cancel) => (gap with { Surface = below.Length == 0 ? setup.PrintedOn : ModelMesh.Joined(below) }).Apply(paths.Paths, progress, cancel));
        var shaped = run.Require(result);
        run.SetList(0, run.Cached([paths, shaped], () => shaped.Select((path, i) => paths.Goos[i].With(path)).ToArray()));
    }
}
