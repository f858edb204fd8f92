using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.GCode;

/// <summary>Turns a design into machine moves.</summary>
public sealed class PlanToolpathComponent() : CaterpillarComponent(
    "Plan Toolpath", "Plan", "Turns print paths and other steps into a toolpath: adds travels, lifts, retractions and amounts of material.", Panel.GCode)
{
    // Deviation of the facets of a curved obstacle, mm.
    private const double ObstacleTolerance = 0.1;

    public override Guid ComponentGuid => new("3f0184a5-8769-4bde-bc26-3f46d7e01ed3");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Flattened(new StepParam(), "Steps", "S", "Print paths, travels and events in the order of the design; branches are joined in order.");
        ports.Add(new PrinterParam(), "Printer", "P", "Target printer, or the name of its profile.");
        ports.Add(new MaterialParam(), "Material", "M", "Material, or the name of its profile; by default that of the printer.", optional: true);
        ports.Add(new SettingsParam(), "Settings", "Se", "Print settings, or the name of their profile; by default those of the printer.",
            optional: true);
        ports.Choice("Mode", "Mo", "What planning may add: everything in the settings (Printer), or nothing (As Drawn).",
            PlanPolicy.Printer);
        ports.Choice("Sort", "So", "How paths are sorted inside the groups of a slicer; other paths keep their order.", SortRule.Tour);
        ports.Geometry("Obstacles", "O",
            "Objects on the bed that are printed on, in document units: travels stay above them, the first one rises before it goes there, and the checks know "
            + "of them.",
            GH_ParamAccess.list, optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "What the printer does, move by move.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var steps = run.Steps(0);
        if (steps.Steps.Length == 0) throw run.Missing(0);
        var setup = SetupPorts.For(run, run.Get<Printer>(1), run.Maybe<Material>(2), run.Maybe<PrintSettings>(3));
        object[] obstacles = Array.ConvertAll(run.Models(6, ObstacleTolerance), m => (object)m.Triangles);
        // Those who check and write the toolpath know of them from its setup.
        setup = setup with { PrintedOn = Joined(run, obstacles) };
        var options = new PlanOptions { Policy = run.Choice<PlanPolicy>(4), Sort = new SortOptions(run.Choice<SortRule>(5)) };
        var toolpath = run.Require(run.Work("Planning", [steps, setup, options],
            (progress, cancel) => Planner.Plan(steps.Steps, setup, options, progress, cancel)));
        run.Set(0, new ToolpathGoo(toolpath, setup));
        run.Summarize($"{NumberFormatter.Format(toolpath.Count)} moves");
    }

    // The same mesh for the same obstacles: what follows is not computed again.
    private static TriMesh? Joined(Run run, object[] obstacles) => obstacles.Length == 0 ? null
        : run.Work("Joining", obstacles, (_, _) => TriMesh.Merge(obstacles.Cast<TriMesh>()));
}
