using System;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

namespace Caterpillar.GH.Components.Design;

/// <summary>A closed ring of straight strings (Kanada's circle).</summary>
public sealed class CircleTraceComponent() : TraceComponent("Circle Trace", "Circle", "A closed ring of straight strings (Kanada's circle).")
{
    public override Guid ComponentGuid => new("5a1d7e36-0c9f-4b28-9e64-8d3f2a7b1c31");

    private protected override void Inputs(InputPorts ports)
    {
        PlanePort(ports);
        ports.Number("Radius", "R", "Radius of the ring, in mm.");
        StrandPorts(ports);
    }

    private protected override void Solve(Run run)
    {
        var radius = run.Positive(1);
        Build(run, 2, [radius], (trace, strings) => trace.Circle(Vec3.Zero, radius, strings));
    }
}
