using System;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

namespace Caterpillar.GH.Components.Design;

/// <summary>Rings around a part that prime the flow.</summary>
public sealed class SkirtTraceComponent()
    : TraceComponent("Skirt Trace", "Skirt", "Rings around a part, from the outside in, that prime the flow before it starts.")
{
    public override Guid ComponentGuid => new("1b9a6e47-5d20-4e8f-9c36-8f7d0a2b5e09");

    private protected override void Inputs(InputPorts ports)
    {
        PlanePort(ports);
        ports.Number("Radius", "R", "Radius of the innermost ring, in mm.");
        ports.Integer("Ring Count", "Lo", "Number of rings.", 1);
        ports.Number("Pitch", "P", "Distance between the rings, in mm.", 0.5);
        StrandPorts(ports);
    }

    private protected override void Solve(Run run)
    {
        var (radius, loops, pitch) = (run.Positive(1), run.Get<int>(2), run.Positive(3));
        if (loops is < 1 or > 1000) throw new InputProblem("Ring Count must be 1 to 1000.");
        Build(run, 4, [radius, loops, pitch], (trace, strings) => trace.Skirt(Vec3.Zero, radius, loops, pitch, strings));
    }
}
