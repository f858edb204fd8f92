using Caterpillar.Geometry;
using Caterpillar.GH.Base;

namespace Caterpillar.GH.Components.Design;

/// <summary>Flat round traces.</summary>
public enum RoundTraceKind
{
    Circle,
    Spiral,
    Skirt,
}

/// <summary>A flat ring, spiral or skirt of straight strings.</summary>
public sealed class RoundTraceComponent() : TraceComponent(
    "Round Trace", "Round", "Closed ring, flat spiral, or skirt loops around a part from the outside in, of straight strings (after Kanada).")
{
    public override Guid ComponentGuid => new("5a1d7e36-0c9f-4b28-9e64-8d3f2a7b1c31");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Kind of trace.", RoundTraceKind.Circle);
        ports.Number("Radius", "R", "Radius of the ring, of the outermost turn, or of the innermost loop, in mm.");
        ports.For("Kind", [RoundTraceKind.Spiral, RoundTraceKind.Skirt],
            () => ports.Number("Pitch", "P", "Distance between turns or loops, in mm. Default: line width of the setup.", optional: true));
        ports.For("Kind", [RoundTraceKind.Spiral], () => ports.Boolean("Inward", "I", "Start at the radius instead of the center.", false));
        ports.For("Kind", [RoundTraceKind.Skirt], () => ports.Integer("Loop Count", "Lo", "Number of skirt loops.", 1));
    }

    private protected override Shape ShapeOf(Run run)
    {
        var kind = run.Choice<RoundTraceKind>(run["Kind"]);
        var radius = run.Positive(run["Radius"]);
        var (pitch, inward, loops) = (PositiveOr(run, "Pitch", s => s.LineWidth), run.Get<bool>(run["Inward"]), run.Get<int>(run["Loop Count"]));
        if (loops is < 1 or > 1000) throw new InputProblem("Loop Count must be 1 to 1000.");
        return new Shape([kind, radius, pitch, inward, loops], (trace, strings) => _ = kind switch
        {
            RoundTraceKind.Circle => trace.Circle(Vec3.Zero, radius, strings),
            RoundTraceKind.Spiral => trace.Spiral(Vec3.Zero, radius, pitch, strings, inward),
            _ => trace.Skirt(Vec3.Zero, radius, loops, pitch, strings),
        });
    }
}
