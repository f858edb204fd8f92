using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.Shaping;

namespace Caterpillar.GH.Components.Path;

/// <summary>Slows small layers down.</summary>
public sealed class CoolLayersComponent() : PathShapingComponent(
    "Cool Layers", "Cool", "Slows small layers down so that they cool before the next one. Speeds are only lowered.")
{
    public override Guid ComponentGuid => new("d5f90b3e-26c1-4a8d-9e47-0f7b3d6a1c43");

    private protected override void Inputs(InputPorts ports)
    {
        PathsPort(ports);
        ports.Number("Min Layer Time", "T", "Minimum time for a layer, in seconds; 0 for none. Paths without a layer form one layer for each height.", 5);
        ports.Boolean("Speed By Length", "K", "True also limits the speed of each segment, in mm/s, to its length in mm plus 1 (Kanada's rule).", false);
        ports.Number("Min Speed", "M", "Speeds are not lowered below this, in mm/s.", 5);
        ports.Number("Reference Speed", "V", "Speed in mm/s of paths that use the speed of the print settings.", 60);
        ports.Number("Max Segment Rate", "R", "Number of segments per second above which there is a warning; 0 for none.", 100);
    }

    private protected override void Solve(Run run)
    {
        var before = PathsOf(run);
        var cooling = new Cooling
        {
            MinLayerTime = AtLeast0(run, 1),
            SpeedByLength = run.Get<bool>(2),
            MinPrintSpeed = run.Positive(3),
            ReferenceSpeed = run.Positive(4),
            MaxSegmentsPerSecond = AtLeast0(run, 5),
        };
        var shaped = run.Work("Cool Layers", [cooling, before],
            (_, cancel) => Shaped.Of(cooling.Apply(before.Paths, cancel), Frame.World));
        SetPaths(run, before, shaped);
    }

    private static double AtLeast0(Run run, int input)
        => run.Finite(input) is >= 0 and var value ? value : throw new InputProblem("Times and rates must be 0 or more.");
}
