namespace Caterpillar.GH.Components.GCode;

/// <summary>Puts toolpaths one after the other.</summary>
public sealed class MergeToolpathsComponent() : CaterpillarComponent(
    "Merge Toolpaths", "MergeT", "Puts toolpaths one after the other. In between, the head retracts, and travels over everything that is printed. The start "
        + "and end code of files is left out.", Panel.GCode, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("c58b0e17-4d2a-4f93-8b6e-d190a7f52c38");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpaths", "T", "Toolpaths, in printing order.", GH_ParamAccess.list);
        ports.Setup("Retraction, lift and speeds in between. Default: as the toolpaths were planned for, else generic.");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "All moves in one toolpath.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var goos = run.Some<ToolpathGoo>(0);
        var setup = SetupPort.Of(run, 1, goos.Select(g => g.Setup));
        var toolpaths = goos.Select(g => g.Value).ToArray();
        var merged = run.Require(run.Work("Merging", [.. toolpaths, setup], (progress, cancel) => Planner.Merge(toolpaths, setup, progress, cancel)));
        // Files without a setup stay those of a printer that nobody chose.
        var isKnown = run.Maybe<PrintSetup>(1) is not null || goos.Exists(g => g.Setup is not null);
        run.Set(0, new ToolpathGoo(merged, isKnown ? setup : null));
        run.Summarize($"{NumberFormatter.Format(merged.Count)} moves");
    }
}
