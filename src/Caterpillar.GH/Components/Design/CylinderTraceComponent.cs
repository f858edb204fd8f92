using System;
using Caterpillar.GH.Base;
using Caterpillar.Geometry;

namespace Caterpillar.GH.Components.Design;

/// <summary>A filled cylinder of stacked flat spirals, alternately outward and inward (Kanada's cylinder).</summary>
public sealed class CylinderTraceComponent()
    : TraceComponent("Cylinder Trace", "Cylinder", "A filled cylinder of stacked flat spirals, alternately outward and inward (Kanada's cylinder).")
{
    public override Guid ComponentGuid => new("96d4c2b7-1a8e-4f75-b3e9-0e5d7f6c4e34");

    private protected override void Inputs(InputPorts ports)
    {
        PlanePort(ports);
        ports.Number("Radius", "R", "Radius of the cylinder, in mm.");
        ports.Number("Height", "H", "Height of the cylinder, in mm.");
        ports.Number("Vertical Pitch", "V", "Distance between the spirals, in mm.");
        ports.Number("Horizontal Pitch", "P", "Distance between the turns of a spiral, in mm.");
        StrandPorts(ports);
    }

    private protected override void Solve(Run run)
    {
        var (radius, height, vertical, horizontal) = (run.Positive(1), run.Positive(2), run.Positive(3), run.Positive(4));
        Build(run, 5, [radius, height, vertical, horizontal], (trace, strings) => trace.Cylinder(Vec3.Zero, radius, height, vertical, horizontal, strings));
    }
}
