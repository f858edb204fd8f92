using System;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

namespace Caterpillar.GH.Components.Design;

/// <summary>A flat spiral of straight strings (Kanada's spiral).</summary>
public sealed class SpiralTraceComponent() : TraceComponent("Spiral Trace", "Spiral", "A flat spiral of straight strings (Kanada's spiral).")
{
    public override Guid ComponentGuid => new("c83b5f12-7e4a-4d06-8b95-1f6e9d0a2c32");

    private protected override void Inputs(InputPorts ports)
    {
        PlanePort(ports);
        ports.Number("Radius", "R", "Radius of the outermost turn, in mm.");
        ports.Number("Pitch", "P", "Distance between the turns, in mm.");
        StrandPorts(ports);
        ports.Boolean("Inward", "I", "True starts at the radius, false in the middle.", false);
    }

    private protected override void Solve(Run run)
    {
        var (radius, pitch, inwards) = (run.Positive(1), run.Positive(2), run.Get<bool>(5));
        Build(run, 3, [radius, pitch, inwards], (trace, strings) => trace.Spiral(Vec3.Zero, radius, pitch, strings, inwards));
    }
}
