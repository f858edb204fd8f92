using Caterpillar.Geometry;
using Caterpillar.GH.Base;

namespace Caterpillar.GH.Components.Design;

/// <summary>A hollow cylinder as one string, without layers or seams (Kanada's helix).</summary>
public sealed class HelixTraceComponent() : TraceComponent(
    "Helix Trace", "Helix", "Hollow cylinder as one string, without layers or seams (Kanada's helix).", bead: 4)
{
    public override Guid ComponentGuid => new("2f9e6a84-b57c-4e13-a0d8-7c4b1e5f3d33");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Number("Radius", "R", "Radius, in mm.");
        ports.Number("Height", "H", "Height, in mm.");
        ports.Number("Pitch", "P", "Rise per turn, in mm.");
    }

    private protected override void MorePorts(InputPorts ports) => RampPorts(ports);

    private protected override Shape ShapeOf(Run run)
    {
        var (radius, height, pitch) = (run.Positive(1), run.Positive(2), run.Positive(3));
        var ramp = RampOf(run);
        return new Shape([radius, height, pitch, ramp?.Minimum, ramp?.Start, ramp?.End],
            (trace, strings) => trace.Helix(Vec3.Zero, radius, height, pitch, strings, ramp));
    }
}

/// <summary>A filled cylinder of stacked flat spirals, alternately outward and inward (Kanada's cylinder).</summary>
public sealed class CylinderTraceComponent() : TraceComponent(
    "Cylinder Trace", "Cylinder", "Filled cylinder of stacked flat spirals, alternately outward and inward (Kanada's cylinder).", bead: 5)
{
    public override Guid ComponentGuid => new("96d4c2b7-1a8e-4f75-b3e9-0e5d7f6c4e34");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Number("Radius", "R", "Radius, in mm.");
        ports.Number("Height", "H", "Height, in mm.");
        ports.Number("Vertical Pitch", "V", "Distance between spirals, in mm.");
        ports.Number("Horizontal Pitch", "P", "Distance between the turns of a spiral, in mm.");
    }

    private protected override Shape ShapeOf(Run run)
    {
        var (radius, height, vertical, horizontal) = (run.Positive(1), run.Positive(2), run.Positive(3), run.Positive(4));
        return new Shape([radius, height, vertical, horizontal],
            (trace, strings) => trace.Cylinder(Vec3.Zero, radius, height, vertical, horizontal, strings));
    }
}

/// <summary>A hollow cone, or its frustum, as one string: a helix whose radius changes with the height.</summary>
public sealed class ConeTraceComponent() : TraceComponent(
    "Cone Trace", "Cone", "Hollow cone or frustum as one string: a helix whose radius changes with the height.", bead: 5)
{
    public override Guid ComponentGuid => new("e07a3d59-4c6b-4182-9f0d-3b8e5c1a6f35");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Number("Bottom Radius", "R", "Radius at the bottom, in mm. 0 = tip.");
        ports.Number("Top Radius", "T", "Radius at the top, in mm. 0 = tip.");
        ports.Number("Height", "H", "Height, in mm.");
        ports.Number("Pitch", "P", "Rise per turn, in mm.");
    }

    private protected override void MorePorts(InputPorts ports) => RampPorts(ports);

    private protected override Shape ShapeOf(Run run)
    {
        var (bottom, top, height, pitch) = (run.Finite(1), run.Finite(2), run.Positive(3), run.Positive(4));
        var ramp = RampOf(run);
        return new Shape([bottom, top, height, pitch, ramp?.Minimum, ramp?.Start, ramp?.End],
            (trace, strings) => trace.Cone(Vec3.Zero, bottom, top, height, pitch, strings, ramp));
    }
}
