using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.Machines;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Setup;

/// <summary>Print settings from a profile, with some values overridden.</summary>
public sealed class ConstructPrintSettingsComponent() : ProfileComponent(
    "Construct Print Settings", "Settings", "Creates print settings from a profile and some values of your own.")
{
    public override Guid ComponentGuid => new("eb1bc290-3166-4963-b83d-d36f484b35cb");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Settings("B", "Default: standard.", "Base");
        ports.OptionalNumber("Layer Height", "H", "Layer height, in mm. Default: as in Base.");
        ports.OptionalNumber("Line Width", "W", "Line width, in mm. Default: as in Base.");
        ports.OptionalNumber("Print Speed", "P", "Speed of printing moves, in mm/s. Default: as in Base.");
        ports.OptionalNumber("Travel Speed", "T", "Speed of travel moves, in mm/s. Default: as in Base.");
        ports.OptionalNumber("Subdivision Distance", "S", "Segment length of subdivided curves, in mm. Default: as in Base.");
        ports.Overrides("wall_count=3 or infill_density_percent=15");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new SettingsParam(), "Settings", "S", "Print settings.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var settings = run.Maybe<PrintSettings>(0) ?? run.Require(Profiles.Library.Settings("standard"));
        if (run.MaybeValue<double>(1) is { } height) settings = settings with { LayerHeight = height };
        if (run.MaybeValue<double>(2) is { } width) settings = settings with { LineWidth = width };
        settings = settings with
        {
            PrintSpeed = run.MaybeValue<double>(3) ?? settings.PrintSpeed,
            TravelSpeed = run.MaybeValue<double>(4) ?? settings.TravelSpeed,
            SubdivisionDistance = run.MaybeValue<double>(5) ?? settings.SubdivisionDistance,
        };
        run.Set(0, new SettingsGoo(run.Require((new PrintSetup() with { Settings = settings }).With(run.List<string>(6))).Settings));
    }
}
