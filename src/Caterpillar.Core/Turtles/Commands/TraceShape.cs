namespace Caterpillar.Turtles;

/// <summary>A shape made of strings (Kanada 2016, section 3.3) around the turtle, from a command.</summary>
internal sealed class TraceShape(double strings, Action<Trace> draw)
{
    /// <summary>Memory of one string until it is a move, bytes.</summary>
    public const int StringBytes = 250;

    /// <summary>About how many strings it has.</summary>
    public double Strings { get; } = double.IsNaN(strings) ? 0 : strings;

    /// <summary>The shape of a command with its numbers, or null if the command is not a trace.</summary>
    /// <exception cref="ArgumentException">A number is not an integer.</exception>
    public static TraceShape? Of(TurtleAction action, int count, double[] v) => action >= TurtleAction.CircleTrace ? Make(action, count, v) : null;

    private static TraceShape? Make(TurtleAction action, int count, double[] v)
    {
        int Strings(int index) => count > index ? TurtleCommand.Integer(v[index]) : Trace.DefaultStringsPerTurn;
        FlowRamp? Ramp(int index) => count > index && v[index] < 1 ? new FlowRamp(v[index]) : null;
        switch (action)
        {
            case TurtleAction.CircleTrace:
                return new TraceShape(Strings(1), t => t.Circle(Vec3.Zero, v[0], Strings(1)));
            case TurtleAction.SpiralTrace:
                return new TraceShape(Turns(v[0], v[1]) * Strings(2), t => t.Spiral(Vec3.Zero, v[0], v[1], Strings(2)));
            case TurtleAction.HelixTrace:
                return new TraceShape(Turns(v[1], v[2]) * Strings(3), t => t.Helix(Vec3.Zero, v[0], v[1], v[2], Strings(3), Ramp(4)));
            case TurtleAction.ConeTrace:
                return new TraceShape(Turns(v[2], v[3]) * Strings(4), t => t.Cone(Vec3.Zero, v[0], v[1], v[2], v[3], Strings(4), Ramp(5)));
            case TurtleAction.CylinderTrace:
                return new TraceShape(Math.Max(1, Turns(v[1], v[2])) * Turns(v[0], v[3]) * Strings(4),
                    t => t.Cylinder(Vec3.Zero, v[0], v[1], v[2], v[3], Strings(4)));
            case TurtleAction.SkirtTrace:
                return new TraceShape((count > 1 ? v[1] : 1) * Trace.DefaultStringsPerTurn,
                    t => t.Skirt(Vec3.Zero, v[0], count > 1 ? TurtleCommand.Integer(v[1]) : 1, count > 2 ? v[2] : 0.5));
            default:
                return null;
        }
    }

    /// <summary>The strings, about the origin.</summary>
    /// <exception cref="ArgumentException">A size is not above 0.</exception>
    public Trace Make(Bead bead, CancellationToken cancel)
    {
        var trace = new Trace(bead.Area) { Cancel = cancel }.SetSpeed(bead.Speed);
        draw(trace);
        return trace;
    }

    // What is not above 0 is refused when the shape is made.
    private static double Turns(double length, double pitch) => length > 0 && pitch > 0 ? length / pitch : 0;
}
