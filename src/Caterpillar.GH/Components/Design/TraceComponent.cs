namespace Caterpillar.GH.Components.Design;

/// <summary>Base of the traces: the ports of the shape, then plane, bead, segments and setup.</summary>
public abstract class TraceComponent(string name, string nickname, string description)
    : ChosenPortsComponent(name, nickname, description, Panel.Design, GH_Exposure.tertiary)
{
    private protected sealed override void Inputs(InputPorts ports)
    {
        ShapePorts(ports);
        ports.Add(new Param_Plane(), "Plane", "Pl",
            "Base plane: the center is at its origin, the axis along Z, the start along X. Default: World XY.", optional: true);
        ports.Bead();
        ports.Integer("Segments Per Turn", "N", "Number of segments per turn.", Trace.DefaultStringsPerTurn);
        ports.Setup("Used for the default bead. Default: generic.");
    }

    private protected sealed override void Outputs(OutputPorts ports) => ports.Add(new PrintPathParam(), "Print Path", "P", "Print path of the trace.");

    private protected abstract void ShapePorts(InputPorts ports);

    private protected abstract Shape ShapeOf(Run run);

    /// <summary>A length greater than zero, by default that of the settings.</summary>
    private protected static double PositiveOr(Run run, string port, Func<PrintSettings, double> fallback)
        => run.MaybeValue<double>(run[port]) is null ? fallback(SetupPort.Of(run, run["Setup"]).Settings) : run.Positive(run[port]);

    private protected sealed override void Solve(Run run)
    {
        var (key, draw) = ShapeOf(run);
        var frame = run.FrameOf(run["Plane"]);
        var (extrusion, setup) = SetupPort.Bead(run, run["Bead"], run["Setup"]);
        var strings = run.Get<int>(run["Segments Per Turn"]);
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
