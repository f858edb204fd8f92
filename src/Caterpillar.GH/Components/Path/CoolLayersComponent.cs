using System;
using System.Linq;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;
using Caterpillar.Shaping;

namespace Caterpillar.GH.Components.Path;

/// <summary>Slows small layers down.</summary>
public sealed class CoolLayersComponent() : PathShapingComponent(
    "Cool Layers", "Cool", "Slows small layers down so that they cool before the next one comes. Speeds are only lowered.")
{
    public override Guid ComponentGuid => new("d5f90b3e-26c1-4a8d-9e47-0f7b3d6a1c43");

    private protected override void Inputs(InputPorts ports)
    {
        PathsPort(ports);
        ports.Number("Min Layer Time", "T", "Shortest time of a layer, in seconds; 0 for none. Paths without a layer are one layer for each height.", 5);
        ports.Boolean("Speed By Length", "K", "True also lets no segment be faster than its length in mm plus 1, in mm/s (Kanada's rule).", false);
        ports.Number("Min Speed", "M", "No speed is lowered below this, in mm/s.", 5);
        ports.Number("Reference Speed", "V", "Speed in mm/s of paths that leave it to the print settings.", 60);
        ports.Number("Max Segment Rate", "R", "Number of segments a second above which a warning comes; 0 for no warning.", 100);
    }

    private protected override void Solve(Run run)
    {
        var before = PathsOf(run);
        var cooling = new Cooling
        {
            MinLayerTime = AtLeast0(run, 1),
            SpeedByLength = run.Get<bool>(2),
            MinSpeed = run.Positive(3),
            ReferenceSpeed = run.Positive(4),
            MaxSegmentsPerSecond = AtLeast0(run, 5),
        };
        var shaped = run.Cached([cooling, .. before.Select(p => p.Value)],
            () => run.Work("Cool Layers", (_, cancel) => Shaped.Of(cooling.Apply(before.Select(p => p.Value).ToArray(), cancel), Frame.World)));
        SetPaths(run, before, shaped);
    }

    private static double AtLeast0(Run run, int input)
        => run.Finite(input) is >= 0 and var value ? value : throw new InputProblem("Times and rates must be 0 or more.");
}
