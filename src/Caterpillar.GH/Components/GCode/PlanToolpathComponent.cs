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
    "Plan Toolpath", "Plan", "Turns print paths and other steps into a toolpath: adds travel moves, Z-hop, retraction and E.", Panel.GCode)
{
    // Deviation of the facets of a curved obstacle, mm.
    private const double ObstacleTolerance = 0.1;

    public override Guid ComponentGuid => new("3f0184a5-8769-4bde-bc26-3f46d7e01ed3");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Flattened(new StepParam(), "Steps", "S", "Print paths, travel moves and events, in order. Branches are joined in order.");
        ports.Add(new PrinterParam(), "Printer", "P", "Printer, or the name of a printer profile.");
        ports.Material("M", "Default: as in the printer profile.");
        ports.Settings("Se", "Default: as in the printer profile.");
        ports.Choice("Mode", "Mo", "What planning adds: everything in the settings (Printer), or nothing (As Drawn).", PlanPolicy.Printer);
        ports.Choice("Sort", "So", "Order of paths within the groups of a slicer. Other paths keep their order.", SortRule.Tour);
        ports.Geometry("Obstacles", "O", "Objects on the bed to print on. Travel moves stay above them, and the first one rises before it goes there. Checks "
            + "include them.", GH_ParamAccess.list, optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath.");
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
