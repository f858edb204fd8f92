namespace Caterpillar.GH.Components.Path;

/// <summary>Slows small layers down.</summary>
public sealed class CoolLayersComponent() : PathShapingComponent(
    "Cool Layers", "Cool", "Slows down small layers so that they cool before the next one. Speeds are never raised.")
{
    public override Guid ComponentGuid => new("d5f90b3e-26c1-4a8d-9e47-0f7b3d6a1c43");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        ports.Number("Minimum Layer Time", "T", "Minimum layer time, in seconds. 0 = off. Paths without a layer form one layer for each height.", 5);
        ports.Boolean("Speed By Length", "K", "Limit the speed of each segment, in mm/s, to its length in mm plus 1 (Kanada's rule).", false);
        ports.Number("Minimum Speed", "M", "Minimum speed, in mm/s. Speeds are not lowered below it.", 5);
        ports.Number("Maximum Segment Rate", "R", "Maximum number of segments per second. Higher rates give a warning. 0 = off.", 100);
    }

    private protected override void Solve(Run run)
    {
        var before = run.Paths(0);
        var cooling = new Cooling
        {
            MinLayerTime = run.NotNegative(1),
            SpeedByLength = run.Get<bool>(2),
            MinPrintSpeed = run.Positive(3),
            ReferenceSpeed = SpeedOf(before),
            MaxSegmentsPerSecond = run.NotNegative(4),
        };
        var shaped = run.Work("Cooling layers", [cooling, before],
            (_, cancel) => Shaped.Of(cooling.Apply(before.Paths, cancel), Frame.World));
        SetPaths(run, before, shaped);
    }
}
