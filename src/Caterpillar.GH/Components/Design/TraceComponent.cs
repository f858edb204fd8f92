using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Components.Design;

/// <summary>Which ends of a helix have reduced flow.</summary>
public enum TraceRamp
{
    None,
    Start,
    End,
    Both,
}

/// <summary>Base of the traces: a plane first, then the ports of the shape, a bead, and optional ports.</summary>
public abstract class TraceComponent(string name, string nickname, string description, int bead)
    : CaterpillarComponent(name, nickname, description, Panel.Design, GH_Exposure.tertiary)
{
    private protected sealed override void Inputs(InputPorts ports)
    {
        ports.Add(new Param_Plane(), "Plane", "Pl",
            "Base plane: the center is at its origin, the axis along Z, the start along X. Default: World XY.", optional: true);
        ShapePorts(ports);
        ports.Bead();
        ports.Integer("Segments Per Turn", "N", "Number of segments per turn.", Trace.DefaultStringsPerTurn);
        MorePorts(ports);
        ports.Setup("Used for the default bead. Default: generic.");
    }

    private protected sealed override void Outputs(OutputPorts ports) => ports.Add(new PrintPathParam(), "Print Path", "P", "Print path.");

    /// <summary>The ports of the shape, from 1 on.</summary>
    private protected abstract void ShapePorts(InputPorts ports);

    /// <summary>Ports after the bead and the number of strings.</summary>
    private protected virtual void MorePorts(InputPorts ports)
    {
    }

    private protected abstract Shape ShapeOf(Run run);

    private protected static void RampPorts(InputPorts ports)
    {
        ports.Choice("Ramp", "Ra", "Ends with reduced flow. At the start, the gap to the bed grows from 0 during the first turn. "
            + "At the end, the last turn ends level.", TraceRamp.None);
        ports.Number("Minimum Flow", "L", "Flow ratio at the very end of a ramp, from 0 to 1.", 0.2);
    }

    private protected FlowRamp? RampOf(Run run)
    {
        var ramp = run.Choice<TraceRamp>(bead + 2);
        var least = run.Finite(bead + 3);
        return ramp == TraceRamp.None ? null : new FlowRamp(least, ramp != TraceRamp.End, ramp != TraceRamp.Start);
    }

    private protected sealed override void Solve(Run run)
    {
        var (key, draw) = ShapeOf(run);
        var frame = run.FrameOf(0);
        var (extrusion, setup) = SetupPort.Bead(run, bead, Params.Input.Count - 1);
        var strings = run.Get<int>(bead + 1);
        var path = run.Work("Tracing", [frame, extrusion, strings, key], (_, _) =>
        {
            var trace = new Trace(extrusion.Area).SetSpeed(extrusion.Speed);
            draw(trace, strings);
            var path = trace.ToPaths().FirstOrDefault() ?? throw new InputProblem("The shape is smaller than one string. Make it larger.");
            if (extrusion.Height > 0) path = path.WithBeads(i => new Bead(path.BeadOf(i).Area, extrusion.Height, extrusion.Speed));
            return path.Transformed(Affine.FromFrame(frame));
        });
        run.Set(0, new PrintPathGoo(path, setup));
        run.Summarize($"{Basics.NumberFormatter.Format(path.SegmentCount)} segments");
    }

    /// <summary>A drawing with a number of strings per turn, and the values that it depends on.</summary>
    private protected sealed record Shape(object?[] Key, Action<Trace, int> Draw);
}
