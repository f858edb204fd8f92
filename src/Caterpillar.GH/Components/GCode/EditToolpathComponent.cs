using System;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Components.GCode;

/// <summary>Changes speed and flow of some moves.</summary>
public sealed class EditToolpathComponent() : CaterpillarComponent(
    "Edit Toolpath", "EditTP", "Changes speed and flow of the moves of some roles, layers or places; Grasshopper's own Move and Scale change the rest.", Panel.GCode)
{
    public override Guid ComponentGuid => new("6d772550-a4bb-485d-addc-16452e9b9ef2");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath to change, planned or decoded.");
        MoveFilterPorts.Declare(ports);
        ports.Number("Speed Factor", "S", "Speed of the chosen moves, as a factor of what it was.", 1);
        ports.Number("Flow Factor", "Fl", "Material of the chosen moves, as a factor of what it was.", 1);
        ports.OptionalInteger("Pause Layer", "P", "Number of the layer, from 0, before which the machine pauses; without it there is no pause.");
    }

    private protected override void Outputs(OutputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "The changed toolpath.");

    private protected override void Solve(Run run)
    {
        var goo = run.Get<ToolpathGoo>(0);
        var filter = MoveFilterPorts.Read(run, 1);
        var (speed, flow) = (run.Positive(5), run.Finite(6));
        var edited = goo.Value;
        if (speed != 1) edited = edited.ScaleSpeed(filter, speed);
        if (flow != 1) edited = edited.ScaleFlow(filter, flow);
        if (run.MaybeValue<int>(7) is { } layer)
        {
            var paused = edited.InsertAtLayer(layer, new PauseEvent());
            if (ReferenceEquals(paused, edited)) run.Report(GH_RuntimeMessageLevel.Warning, "There is no such layer to pause at.");
            edited = paused;
        }
        run.Set(0, goo.With(edited));
    }
}
