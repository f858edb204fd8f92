using System;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.Machines;
using Caterpillar.Slicing;

namespace Caterpillar.GH.Components.Slice;

/// <summary>Cuts solids into planar layers and fills them.</summary>
public sealed class PlanarSlicerComponent() : SlicerComponent(
    "Planar Slicer", "Slice", "Cuts solids that stand on the bed (Z = 0) into planar layers and fills them with walls and infill.")
{
    public override Guid ComponentGuid => new("378f4dfe-ec2e-4716-a6dd-c0709743ec9b");

    private protected override void Inputs(InputPorts ports)
    {
        GeometryPort(ports);
        ports.Add(new SettingsParam(), "Settings", "S", "Print settings; the standard ones by default.", optional: true);
        TolerancePort(ports);
    }

    private protected override void Solve(Run run)
    {
        var tolerance = run.Positive(2);
        var settings = run.Maybe<PrintSettings>(1) ?? new PrintSettings();
        var models = Models(run, 0, tolerance);
        var solids = Named(models);
        var result = run.Work("Slicing", [settings, .. models], (progress, cancel) => PlanarSlicer.Slice(solids, settings, 0, progress, cancel));
        SetResult(run, models, solids, result);
    }
}
