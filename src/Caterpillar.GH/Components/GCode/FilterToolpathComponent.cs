namespace Caterpillar.GH.Components.GCode;

/// <summary>Keeps some moves of a toolpath, or removes them.</summary>
public sealed class FilterToolpathComponent() : CaterpillarComponent(
    "Filter Toolpath", "FilterT",
        "Keeps or removes the moves that Move Filter selects. Travel moves and retractions are repaired at the cuts.", Panel.GCode, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("3db465e0-e208-4bcc-8814-4b292260c251");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Filter();
        ports.Boolean("Remove", "Re", "Remove the selected moves instead of keeping only them.", false);
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath of the moves that remain.");

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var filter = run.Filter();
        var remove = run.Get<bool>(2);
        var edited = run.Work("Filtering", [goo.Value, remove, filter], (_, cancel) => remove ? goo.Value.Remove(filter, cancel)
            : goo.Value.Keep(filter, cancel));
        run.Set(0, goo.With(edited));
        run.Summarize($"{NumberFormatter.Format(edited.Count)} moves");
    }
}
