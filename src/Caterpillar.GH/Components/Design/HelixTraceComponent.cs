using System;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

namespace Caterpillar.GH.Components.Design;

/// <summary>A hollow cylinder as one string, without layers or seams (Kanada's helix).</summary>
public sealed class HelixTraceComponent()
    : TraceComponent("Helix Trace", "Helix", "A hollow cylinder as one string, without layers or seams (Kanada's helix).")
{
    public override Guid ComponentGuid => new("2f9e6a84-b57c-4e13-a0d8-7c4b1e5f3d33");

    private protected override void Inputs(InputPorts ports)
    {
        PlanePort(ports);
        ports.Number("Radius", "R", "Radius of the wall, in mm.");
        ports.Number("Height", "H", "Height of the wall, in mm.");
        ports.Number("Pitch", "P", "Rise per turn, in mm.");
        StrandPorts(ports);
        RampPorts(ports);
    }

    private protected override void Solve(Run run)
    {
        var (radius, height, pitch) = (run.Positive(1), run.Positive(2), run.Positive(3));
        var ramp = RampOf(run, 6);
        Build(run, 4, [radius, height, pitch, ramp?.Minimum, ramp?.Start, ramp?.End],
            (trace, strings) => trace.Helix(Vec3.Zero, radius, height, pitch, strings, ramp));
    }
}
