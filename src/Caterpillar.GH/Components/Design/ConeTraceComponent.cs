using System;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

namespace Caterpillar.GH.Components.Design;

/// <summary>A hollow cone, or its frustum, as one string: a helix whose radius changes with the height.</summary>
public sealed class ConeTraceComponent()
    : TraceComponent("Cone Trace", "Cone", "A hollow cone, or its frustum, as one string: a helix whose radius changes with the height.")
{
    public override Guid ComponentGuid => new("e07a3d59-4c6b-4182-9f0d-3b8e5c1a6f35");

    private protected override void Inputs(InputPorts ports)
    {
        PlanePort(ports);
        ports.Number("Bottom Radius", "R", "Radius of the wall at the bottom, in mm; 0 for a tip.");
        ports.Number("Top Radius", "T", "Radius of the wall at the top, in mm; 0 for a tip.");
        ports.Number("Height", "H", "Height of the cone, in mm.");
        ports.Number("Pitch", "P", "Rise per turn, in mm.");
        StrandPorts(ports);
        RampPorts(ports);
    }

    private protected override void Solve(Run run)
    {
        var (bottom, top, height, pitch) = (run.Finite(1), run.Finite(2), run.Positive(3), run.Positive(4));
        var ramp = RampOf(run, 7);
        Build(run, 5, [bottom, top, height, pitch, ramp?.Minimum, ramp?.Start, ramp?.End],
            (trace, strings) => trace.Cone(Vec3.Zero, bottom, top, height, pitch, strings, ramp));
    }
}
