using System;
using System.Collections.Generic;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.Machines;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.Setup;

/// <summary>Print settings from a profile and some values of one's own.</summary>
public sealed class ConstructPrintSettingsComponent() : ProfileComponent(
    "Construct Print Settings", "Settings", "How to print: the settings of a profile, with the values given here instead of its own.")
{
    public override Guid ComponentGuid => new("eb1bc290-3166-4963-b83d-d36f484b35cb");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new SettingsParam(), "Base", "B", "Settings to begin with, or the name of their profile; without it the standard ones.", optional: true);
        ports.OptionalNumber("Layer Height", "H", "Height of a layer, in mm; without it that of the base.");
        ports.OptionalNumber("Line Width", "W", "Width of a line, in mm; without it that of the base.");
        ports.OptionalNumber("Print Speed", "P", "Speed of the head while it prints, in mm/s; without it that of the base.");
        ports.OptionalNumber("Travel Speed", "T", "Speed of the head while it does not print, in mm/s; without it that of the base.");
        ports.OptionalNumber("Subdivision Distance", "S", "Distance of points on curved paths, in mm; without it that of the base.");
        ports.Text("Overrides", "O", "Other values to change as key=value, for example wall_count=3 or infill_percent=15; keys carry their unit.",
            access: GH_ParamAccess.list, optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new SettingsParam(), "Settings", "S", "The print settings.");
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var texts = new List<string>();
        var settings = run.Maybe<PrintSettings>(0) ?? run.Accept(Profiles.Library.Settings("standard"), texts);
        if (settings is not null)
        {
            settings = settings with
            {
                LayerHeight = run.MaybeValue<double>(1) ?? settings.LayerHeight,
                LineWidth = run.MaybeValue<double>(2) ?? settings.LineWidth,
                PrintSpeed = run.MaybeValue<double>(3) ?? settings.PrintSpeed,
                TravelSpeed = run.MaybeValue<double>(4) ?? settings.TravelSpeed,
                SubdivisionDistance = run.MaybeValue<double>(5) ?? settings.SubdivisionDistance,
            };
            settings = run.Accept((new PrintSetup() with { Settings = settings }).With(run.List<string>(6)), texts)?.Settings;
        }
        run.Set(0, settings is null ? null : new SettingsGoo(settings));
        run.SetList(1, texts);
    }
}
