namespace Caterpillar.GH.Components.Setup;

/// <summary>Makes all components of a definition wait for their results, for whoever reads them at the end of a solution.</summary>
public sealed class WaitForResultsComponent() : CaterpillarComponent(
    "Wait For Results", "Wait", "Makes each solution of this definition wait until all results are there. Needed for solvers, animations and recorders, "
        + "which read results at the end of a solution. Disable the component to work in the background again.", Panel.Setup, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("c0d6a7ee-3f0f-4a51-8a55-1d7f4a2b9c3e");

    internal override bool LetsAllWait => true;

    private protected override void Inputs(InputPorts ports)
    {
    }

    private protected override void Outputs(OutputPorts ports)
    {
    }

    private protected override void Solve(Run run) => run.Summarize("all results");
}
