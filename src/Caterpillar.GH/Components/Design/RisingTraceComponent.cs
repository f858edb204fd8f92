namespace Caterpillar.GH.Components.Design;

/// <summary>Traces that rise.</summary>
public enum RisingTraceKind
{
    Helix,
    Cylinder,
    Cone,
}

/// <summary>Which ends of a helix have reduced flow.</summary>
public enum TraceRamp
{
    None,
    Start,
    End,
    Both,
}

/// <summary>A hollow or filled cylinder, or a cone.</summary>
public sealed class RisingTraceComponent() : TraceComponent(
    "Rising Trace", "Rising", "Hollow cylinder (helix) or cone as one string without layers or seams, or filled cylinder of stacked spirals (after Kanada).")
{
    public override Guid ComponentGuid => new("2f9e6a84-b57c-4e13-a0d8-7c4b1e5f3d33");

    private protected override void ShapePorts(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Kind of trace.", RisingTraceKind.Helix);
        ports.For("Kind", [RisingTraceKind.Helix, RisingTraceKind.Cylinder], () => ports.Number("Radius", "R", "Radius, in mm."));
        ports.For("Kind", [RisingTraceKind.Cone], () =>
        {
            ports.Number("Bottom Radius", "R", "Radius at the bottom, in mm. 0 = tip.");
            ports.Number("Top Radius", "T", "Radius at the top, in mm. 0 = tip.");
        });
        ports.Number("Height", "H", "Height, in mm.");
        ports.Number("Pitch", "P", "Rise per turn, or distance between stacked spirals, in mm. Default: layer height of the setup.", optional: true);
        ports.For("Kind", [RisingTraceKind.Cylinder],
            () => ports.Number("Horizontal Pitch", "Hp", "Distance between the turns of a spiral, in mm. Default: line width of the setup.", optional: true));
        ports.For("Kind", [RisingTraceKind.Helix, RisingTraceKind.Cone], () =>
        {
            ports.Choice("Ramp", "Ra", "Ends with reduced flow. At the start, the gap to the bed grows from 0 during the first turn. "
                + "At the end, the last turn ends level.", TraceRamp.None);
            ports.For("Ramp", [TraceRamp.Start, TraceRamp.End, TraceRamp.Both],
                () => ports.Number("Minimum Flow", "L", "Flow ratio at the very end of a ramp, from 0 to 1.", 0.2));
        });
    }

    private protected override Shape ShapeOf(Run run)
    {
        var kind = run.Choice<RisingTraceKind>(run["Kind"]);
        var (height, pitch) = (run.Positive(run["Height"]), PositiveOr(run, "Pitch", s => s.LayerHeight));
        if (kind == RisingTraceKind.Cone)
        {
            var (bottom, top, ends) = (run.Finite(run["Bottom Radius"]), run.Finite(run["Top Radius"]), RampOf(run));
            return new Shape([bottom, top, height, pitch, ends], (trace, strings) => trace.Cone(Vec3.Zero, bottom, top, height, pitch, strings, ends));
        }
        var radius = run.Positive(run["Radius"]);
        if (kind == RisingTraceKind.Cylinder)
        {
            var across = PositiveOr(run, "Horizontal Pitch", s => s.LineWidth);
            return new Shape([kind, radius, height, pitch, across], (trace, strings) => trace.Cylinder(Vec3.Zero, radius, height, pitch, across, strings));
        }
        var ramp = RampOf(run);
        return new Shape([kind, radius, height, pitch, ramp], (trace, strings) => trace.Helix(Vec3.Zero, radius, height, pitch, strings, ramp));
    }

    private static FlowRamp? RampOf(Run run)
    {
        var ramp = run.Choice<TraceRamp>(run["Ramp"]);
        var least = run.Finite(run["Minimum Flow"]);
        return ramp == TraceRamp.None ? null : new FlowRamp(least, ramp != TraceRamp.End, ramp != TraceRamp.Start);
    }
}
