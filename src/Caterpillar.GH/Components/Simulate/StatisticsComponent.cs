namespace Caterpillar.GH.Components.Simulate;

/// <summary>Time and material of a print.</summary>
public sealed class StatisticsComponent() : CaterpillarComponent(
    "Statistics", "Stats", "Print time and material of a toolpath, by the accelerations and cornering of its printer.", Panel.Simulate, GH_Exposure.secondary)
{
    public override Guid ComponentGuid => new("0a6f6d0e-94d1-4b0f-8a77-2f0f3b8f9b03");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Setup("Default: as used for planning, else the limits in the file.");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Number("Time", "T", "Print time, in seconds.");
        ports.Number("Filament", "F", "Extruded filament, in mm (or mm³ for volumetric E).");
        ports.Number("Volume", "V", "Volume of the extrusions, in mm³. Null if the filament diameter is unknown.");
        ports.Number("Mass", "M", "Mass of the extrusions, in grams. Null if unknown.");
        ports.Number("Cost", "C", "Cost of the material, in the currency of its profile. Null if unknown.");
        ports.Number("Print Length", "L", "Total length of extrusions, in mm.");
        ports.Number("Travel Length", "Tr", "Total length of travel moves, in mm.");
        ports.Integer("Retraction Count", "R", "Number of retractions.");
        ports.Number("Peak Flow", "Q", "Maximum volumetric flow, in mm³/s. Null if unknown.");
        ports.Number("Layer Times", "Lt", "Time of each layer, in seconds.", GH_ParamAccess.list);
        ports.Text("Summary", "S", "Statistics as text, with the time of each role.", GH_ParamAccess.list);
    }

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var setup = SetupPort.Of(run, 1, goo);
        var s = run.Work("Timing", [goo.Value, setup], (progress, cancel) => PrintStatistics.Of(goo.Value, setup, progress, cancel));
        run.SetAll(s.Duration, s.Filament, s.Volume, s.Mass, s.Cost, s.PrintLength, s.TravelLength, s.Retractions, s.GreatestFlow);
        run.SetList(9, s.Layers.Select(l => l.Time));
        run.SetList(10, Lines(s, setup).ToArray());
        run.Summarize($"{N(s.Duration / 60, 1)} min");
    }

    private static IEnumerable<string> Lines(PrintStatistics s, PrintSetup setup)
    {
        yield return $"{N(s.Duration, 1)} s by the limits of {setup.Printer.Title}: {N(s.PrintTime, 1)} s printing, {N(s.TravelTime, 1)} s traveling, "
            + $"{N(s.ExtruderTime, 1)} s retracting, {N(s.Waits.Total, 1)} s waiting";
        yield return $"{N(s.Filament, 1)} mm of filament" + (s.Volume is { } volume ? $", {N(volume / 1000, 2)} cm³" : "")
            + (s.Mass is { } mass ? $", {N(mass, 2)} g" : "");
        yield return $"{N(s.PrintLength / 1000, 2)} m printed, {N(s.TravelLength / 1000, 2)} m traveled, {N(s.Retractions, 0)} retractions, {N(s.Moves, 0)} "
            + $"moves";
        if (s.GreatestFlow is { } flow)
            yield return $"Maximum flow {N(flow, 2)} mm³/s in move {N(s.GreatestFlowMove, 0)}, maximum speed {N(s.GreatestSpeed, 1)} mm/s";
        foreach (var role in s.Roles) yield return $"{role.Role}: {N(role.Time, 1)} s, {N(role.Length / 1000, 2)} m";
    }

    private static string N(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
