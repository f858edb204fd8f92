namespace Caterpillar.GH.Components.GCode;

/// <summary>Turns a design into machine moves.</summary>
public sealed class PlanToolpathComponent() : CaterpillarComponent(
    "Plan Toolpath", "Plan", "Turns print paths and other steps into a toolpath: adds travel moves, Z-hop, retraction and E.", Panel.GCode)
{
    public override Guid ComponentGuid => new("3f0184a5-8769-4bde-bc26-3f46d7e01ed3");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Flattened(new StepParam(), "Steps", "S", "Print paths, travel moves and events, in order. Branches are joined in order.");
        ports.Setup("Default: as the print paths were made with, else generic.");
        ports.Choice("Mode", "Mo", "What planning adds: everything in the settings (Printer), or nothing (As Drawn).", PlanPolicy.Printer);
        ports.Choice("Sort", "So", "Order of paths within the groups of a slicer. Other paths keep their order.", SortRule.Tour);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "All moves in order: extrusions, travel moves and retractions.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var goos = run.Some<StepGoo>(0);
        var setup = SetupPort.Of(run, 1, goos.Select(g => g.Setup));
        var steps = run.Steps(goos, setup);
        var options = new PlanOptions { Policy = run.Choice<PlanPolicy>(2), Sort = new SortOptions(run.Choice<SortRule>(3)) };
        var toolpath = run.Require(run.Work("Planning", [steps, setup, options],
            (progress, cancel) => Planner.Plan(steps.Steps, setup, options, progress, cancel)));
        run.Set(0, new ToolpathGoo(toolpath, setup));
        run.Summarize($"{NumberFormatter.Format(toolpath.Count)} moves");
    }
}
