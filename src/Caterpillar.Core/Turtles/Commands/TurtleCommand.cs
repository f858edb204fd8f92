namespace Caterpillar.Turtles;

/// <summary>One command as a value: an action, its numbers, and its text or body. Immutable.</summary>
public sealed class TurtleCommand
{
    /// <summary>Maximum number of values of a command.</summary>
    internal const int MaxValues = 6;

    private readonly double[] _values;

    private TurtleCommand(TurtleAction action, double[] values, string text, IReadOnlyList<TurtleCommand> body)
        => (Action, _values, Text, Body) = (action, values, text, body);

    /// <summary>The action of the command.</summary>
    public TurtleAction Action { get; }

    /// <summary>The numbers of the command. NaN keeps a coordinate.</summary>
    public IReadOnlyList<double> Values => _values;

    /// <summary>The text of the command, or empty.</summary>
    public string Text { get; }

    /// <summary>The commands of a repetition.</summary>
    public IReadOnlyList<TurtleCommand> Body { get; }

    /// <summary>A command from numbers.</summary>
    /// <exception cref="ArgumentException">The number of values is wrong, or a value is not finite. NaN is allowed for position and jump.</exception>
    public static TurtleCommand Of(TurtleAction action, params double[] values) => Of(action, "", values);

    /// <summary>A command from text and numbers.</summary>
    /// <inheritdoc cref="Of(TurtleAction, double[])" path="/exception"/>
    public static TurtleCommand Of(TurtleAction action, string text, params double[] values)
    {
        var info = TurtleCommands.Of(action);
        if (values is null || values.Length < (text.Length > 0 && action == TurtleAction.Color ? 0 : info.Required) || values.Length > info.Values.Count)
            throw new ArgumentException($"Wrong number of values. The command is: {info.Usage}.", nameof(values));
        for (var i = 0; i < values.Length; i++)
        {
            if (double.IsInfinity(values[i]) || (double.IsNaN(values[i]) && !(info.MayKeep && i < 3)))
                throw new ArgumentException("A value is not finite.", nameof(values));
        }
        return new TurtleCommand(action, (double[])values.Clone(), text ?? "", []);
    }

    /// <summary>Repeats commands.</summary>
    /// <param name="count">0 or more.</param>
    /// <param name="body">The commands to repeat.</param>
    public static TurtleCommand Repeat(long count, IEnumerable<TurtleCommand> body)
    {
        if (count < 0) throw new ArgumentOutOfRangeException(nameof(count), "The number of repetitions must be 0 or more.");
        return new TurtleCommand(TurtleAction.Repeat, [count], "", (body ?? throw new ArgumentNullException(nameof(body))).ToArray());
    }

    /// <summary>Executes the command. <see cref="TurtleProgram"/> executes repetitions.</summary>
    /// <exception cref="ArgumentException">A value is invalid for the turtle.</exception>
    /// <exception cref="InvalidOperationException">A pop without a push, a start after the first move, or a repetition.</exception>
    public void Apply(Turtle turtle)
    {
        if (Action == TurtleAction.Repeat) throw new InvalidOperationException("A repetition can only run in a program.");
        if (TraceShape.Of(Action, _values.Length, _values) is { } shape) turtle.Draw(shape.Make(turtle.Bead, default));
        else Apply(turtle, Action, _values.Length, _values, Text);
    }

    /// <summary>The command as a line of a script.</summary>
    public override string ToString()
    {
        if (Action == TurtleAction.Repeat) return $"repeat {NumberFormatter.Format(_values[0], 12)} [ {string.Join("; ", Body)} ]";
        var words = new List<string> { TurtleCommands.Of(Action).Name };
        if (Text.Length > 0) words.Add("\"" + Text + "\"");
        words.AddRange(_values.Select(v => double.IsNaN(v) ? "keep" : NumberFormatter.Format(v, 12)));
        return string.Join(" ", words);
    }

    internal static void Apply(Turtle t, TurtleAction action, int count, double[] values, string text)
    {
        double a = At(values, 0), b = At(values, 1), c = At(values, 2), d = At(values, 3);
        switch (action)
        {
            case TurtleAction.Start: t.StartAt(a, b, count > 2 ? c : 0); break;
            case TurtleAction.Forward when count > 1: t.Forward(a, b); break;
            case TurtleAction.Forward: t.Forward(a); break;
            case TurtleAction.Backward: t.Backward(a); break;
            case TurtleAction.Move: t.Move(a); break;
            case TurtleAction.ForwardLift: t.ForwardLift(a, b); break;
            case TurtleAction.Lift: t.Lift(a); break;
            case TurtleAction.LiftWorld: t.LiftWorld(a); break;
            case TurtleAction.Yaw: t.Left(a); break;
            case TurtleAction.Right: t.Right(a); break;
            case TurtleAction.Pitch: t.PitchUp(a); break;
            case TurtleAction.PitchDown: t.PitchDown(a); break;
            case TurtleAction.Roll: t.RollRight(a); break;
            case TurtleAction.RollLeft: t.RollLeft(a); break;
            case TurtleAction.TurnAround: t.TurnAround(); break;
            case TurtleAction.Heading: t.SetHeading(a, count > 1 ? b : 0, count > 2 ? c : 0); break;
            case TurtleAction.ChangeHeading: t.ChangeHeading(a, count > 1 ? b : 0, count > 2 ? c : 0); break;
            case TurtleAction.Face: t.Face(new Geometry.Vec3(a, b, c)); break;
            case TurtleAction.Level: t.Level(); break;
            case TurtleAction.Position: t.GoTo(Keep(a), Keep(b), count > 2 ? Keep(c) : null); break;
            case TurtleAction.Jump:
                t.Jump(Keep(a), Keep(b), count > 2 ? Keep(c) : null);
                if (count > 3) t.SetHeading(d);
                break;
            case TurtleAction.Arc: t.Arc(a, b, count > 2 ? c : 0, count > 3 ? Integer(d) : 0); break;
            case TurtleAction.Circle: t.Circle(a, count > 1 ? Integer(b) : 0); break;
            case TurtleAction.CircleAround: t.CircleAround(a, count > 1 ? Integer(b) : 0); break;
            case TurtleAction.Polygon: t.Polygon(Integer(a), b); break;
            case TurtleAction.Push: t.Push(); break;
            case TurtleAction.Pop: t.Pop(); break;
            case TurtleAction.PenUp: t.PenUp(); break;
            case TurtleAction.PenDown: t.PenDown(); break;
            default: ApplyPrinter(t, action, count, a, b, c, text); break;
        }
    }

    private static void ApplyPrinter(Turtle t, TurtleAction action, int count, double a, double b, double c, string text)
    {
        switch (action)
        {
            case TurtleAction.Density: t.SetDensity(a); break;
            case TurtleAction.Area: t.SetArea(a, count > 1 ? b : 0); break;
            case TurtleAction.Bead: t.SetBead(a, b, count > 2 ? c : 1); break;
            case TurtleAction.Rate: t.SetRate(a); break;
            case TurtleAction.Speed: t.SetSpeed(a); break;
            case TurtleAction.TravelRate: t.SetTravelSpeed(a / 60); break;
            case TurtleAction.TravelSpeed: t.SetTravelSpeed(a); break;
            case TurtleAction.Extrude: t.Extrude(a); break;
            case TurtleAction.Dwell: t.Dwell(a); break;
            case TurtleAction.Pause: t.Pause(text); break;
            case TurtleAction.NozzleTemperature: t.NozzleTemperature(a); break;
            case TurtleAction.SetNozzleTemperature: t.NozzleTemperature(a, wait: false); break;
            case TurtleAction.BedTemperature: t.BedTemperature(a); break;
            case TurtleAction.SetBedTemperature: t.BedTemperature(a, wait: false); break;
            case TurtleAction.Fan: t.Fan(a); break;
            case TurtleAction.Mix: t.Mix(a); break;
            case TurtleAction.Acceleration: t.Acceleration(a); break;
            case TurtleAction.Tool: t.Tool(Integer(a)); break;
            case TurtleAction.Comment: t.Comment(text); break;
            case TurtleAction.Raw: t.Raw(text); break;
            case TurtleAction.Layer: t.Layer(Integer(a), count > 1 ? b : 0); break;
            case TurtleAction.NextLayer: t.NextLayer(count > 0 ? a : 0); break;
            case TurtleAction.Color: Color(t, count, a, b, c, text); break;
            case TurtleAction.Name: t.Name(text); break;
            case TurtleAction.Role: t.As(RoleOf(text)); break;
            case TurtleAction.Degrees: t.AngleUnit = AngleUnit.Degrees; break;
            case TurtleAction.Radians: t.AngleUnit = AngleUnit.Radians; break;
            default: throw new ArgumentOutOfRangeException(nameof(action));
        }
    }

    private static void Color(Turtle t, int count, double a, double b, double c, string text)
    {
        if (text.Length > 0)
        {
            var hex = text.StartsWith("#", StringComparison.Ordinal) ? text.Substring(1) : text;
            if (hex.Length != 6 || !int.TryParse(hex, System.Globalization.NumberStyles.AllowHexSpecifier, System.Globalization.CultureInfo.InvariantCulture,
                out var rgb))
                throw new ArgumentException("A color must have the form \"#rrggbb\".", nameof(text));
            t.Color(rgb);
        }
        else if (count == 3) t.Color(Integer(a), Integer(b), Integer(c));
        else if (count == 0) t.Color(null);
        else throw new ArgumentException("A color needs three numbers.", nameof(count));
    }

    private static Role RoleOf(string text)
    {
        var names = Enum.GetNames(typeof(Role)).Select(Words.Snake).ToArray();
        var index = Array.IndexOf(names, Words.Snake(text));
        if (index < 0) throw new ArgumentException($"Unknown role '{text}'.{SpellingSuggestion.Hint(text, names)}", nameof(text));
        return (Role)Enum.GetValues(typeof(Role)).GetValue(index)!;
    }

    private static double? Keep(double value) => double.IsNaN(value) ? null : value;

    internal static int Integer(double value)
        => Math.Abs(value) <= 1e9 && value == Math.Floor(value) ? (int)value
            : throw new ArgumentOutOfRangeException(nameof(value), $"Found {NumberFormatter.Format(value, 12)}, expected an integer.");

    private static double At(double[] values, int index) => index < values.Length ? values[index] : double.NaN;
}
