using Caterpillar.Geometry;
using Caterpillar.GH.Base;

namespace Caterpillar.GH.Components.Design;

/// <summary>A closed ring of straight strings (Kanada's circle).</summary>
public sealed class CircleTraceComponent() : TraceComponent("Circle Trace", "Circle", "Closed ring of straight strings (Kanada's circle).", bead: 2)
{
    public override Guid ComponentGuid => new("5a1d7e36-0c9f-4b28-9e64-8d3f2a7b1c31");

    private protected override void ShapePorts(InputPorts ports) => ports.Number("Radius", "R", "Radius, in mm.");

    private protected override Shape ShapeOf(Run run)
    {
        var radius = run.Positive(1);
        return new Shape([radius], (trace, strings) => trace.Circle(Vec3.Zero, radius, strings));
    }
}

/// <summary>A flat spiral of straight strings (Kanada's spiral).</summary>
public sealed class SpiralTraceComponent() : TraceComponent("Spiral Trace", "Spiral", "Flat spiral of straight strings (Kanada's spiral).", bead: 3)
{
    public override Guid ComponentGuid => new("c83b5f12-7e4a-4d06-8b95-1f6e9d0a2c32");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Number("Radius", "R", "Radius of the outermost turn, in mm.");
        ports.Number("Pitch", "P", "Distance between turns, in mm.");
    }

    private protected override void MorePorts(InputPorts ports) => ports.Boolean("Inward", "I", "Start at the radius instead of the center.", false);

    private protected override Shape ShapeOf(Run run)
    {
        var (radius, pitch, inwards) = (run.Positive(1), run.Positive(2), run.Get<bool>(5));
        return new Shape([radius, pitch, inwards], (trace, strings) => trace.Spiral(Vec3.Zero, radius, pitch, strings, inwards));
    }
}

/// <summary>Skirt loops around a part.</summary>
public sealed class SkirtTraceComponent() : TraceComponent(
    "Skirt Trace", "Skirt", "Skirt loops around a part, from the outside in, that prime the nozzle.", bead: 4)
{
    public override Guid ComponentGuid => new("1b9a6e47-5d20-4e8f-9c36-8f7d0a2b5e09");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Number("Radius", "R", "Radius of the innermost loop, in mm.");
        ports.Integer("Loop Count", "Lo", "Number of skirt loops.", 1);
        ports.Number("Pitch", "P", "Distance between loops, in mm.", 0.5);
    }

    private protected override Shape ShapeOf(Run run)
    {
        var (radius, loops, pitch) = (run.Positive(1), run.Get<int>(2), run.Positive(3));
        if (loops is < 1 or > 1000) throw new InputProblem("Loop Count must be 1 to 1000.");
        return new Shape([radius, loops, pitch], (trace, strings) => trace.Skirt(Vec3.Zero, radius, loops, pitch, strings));
    }
}
