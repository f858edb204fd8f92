namespace Caterpillar.GH.Components.Design;

/// <summary>Base of the components that make one command.</summary>
public abstract class TurtleCommandComponent(string name, string nickname, string description)
    : ChosenPortsComponent(name, nickname, description, Panel.Design, GH_Exposure.secondary)
{
    private protected sealed override void Outputs(OutputPorts ports) => ports.Add(new TurtleCommandParam(), "Command", "C", "Command, for Turtle Program.");

    private protected sealed override void Solve(Run run) => run.Set(0, new TurtleCommandGoo { Value = Command(run) });

    private protected abstract TurtleCommand Command(Run run);

    private protected static TurtleCommand Together(List<TurtleCommand> commands) => commands.Count == 1 ? commands[0] : TurtleCommand.Repeat(1, commands);
}

/// <summary>What Turtle Move does.</summary>
public enum TurtleMoveKind
{
    Forward,
    Backward,
    WithoutPrinting,
    ForwardAndUp,
    Lift,
    LiftWorld,
    GoTo,
    Jump,
    Arc,
    Circle,
    Polygon,
}

/// <summary>A move of the turtle.</summary>
public sealed class TurtleMoveComponent() : TurtleCommandComponent(
    "Turtle Move", "TMove", "Moves the turtle. With the pen down it prints, except for lifts, jumps and moves without printing.")
{
    public override Guid ComponentGuid => new("3a5d0f91-8c7e-4d54-9d0e-7b2f6c1a4e15");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Kind of move.", TurtleMoveKind.Forward);
        ports.For("Kind", [TurtleMoveKind.Forward, TurtleMoveKind.Backward, TurtleMoveKind.WithoutPrinting, TurtleMoveKind.ForwardAndUp, TurtleMoveKind.Lift,
            TurtleMoveKind.LiftWorld], () => ports.Number("Distance", "D", "Distance, in mm.", 10));
        ports.For("Kind", [TurtleMoveKind.Arc, TurtleMoveKind.Circle], () => ports.Number("Radius", "R", "Radius, in mm.", 10));
        ports.For("Kind", [TurtleMoveKind.Arc], () => ports.Angle("Angle", "A", "Angle of the arc, in degrees. Positive = to the left.", 90));
        ports.For("Kind", [TurtleMoveKind.ForwardAndUp, TurtleMoveKind.Arc], () => ports.Number("Height", "H", "Rise, in mm.", 0));
        ports.For("Kind", [TurtleMoveKind.Arc, TurtleMoveKind.Circle], () => ports.Integer("Count", "N", "Number of segments. 0 = automatic.", 0));
        ports.For("Kind", [TurtleMoveKind.Polygon], () =>
        {
            ports.Number("Side Length", "S", "Length of a side, in mm.", 10);
            ports.Integer("Side Count", "Sc", "Number of sides.", 6);
        });
        ports.For("Kind", [TurtleMoveKind.GoTo, TurtleMoveKind.Jump], () => ports.Add(new Param_Point(), "Point", "Pt", "Target."));
    }

    private protected override TurtleCommand Command(Run run)
    {
        var kind = run.Choice<TurtleMoveKind>(run["Kind"]);
        var d = run.Finite(run["Distance"]);
        switch (kind)
        {
            case TurtleMoveKind.Forward: return TurtleCommand.Of(TurtleAction.Forward, d);
            case TurtleMoveKind.Backward: return TurtleCommand.Of(TurtleAction.Backward, d);
            case TurtleMoveKind.WithoutPrinting: return TurtleCommand.Of(TurtleAction.Move, d);
            case TurtleMoveKind.ForwardAndUp: return TurtleCommand.Of(TurtleAction.ForwardLift, d, run.Finite(run["Height"]));
            case TurtleMoveKind.Lift: return TurtleCommand.Of(TurtleAction.Lift, d);
            case TurtleMoveKind.LiftWorld: return TurtleCommand.Of(TurtleAction.LiftWorld, d);
            case TurtleMoveKind.Polygon: return TurtleCommand.Of(TurtleAction.Polygon, run.Get<int>(run["Side Count"]), run.Finite(run["Side Length"]));
            case TurtleMoveKind.GoTo or TurtleMoveKind.Jump:
                var point = run.MaybePoint(run["Point"]) ?? throw run.Missing(run["Point"]);
                return TurtleCommand.Of(kind == TurtleMoveKind.GoTo ? TurtleAction.Position : TurtleAction.Jump, point.X, point.Y, point.Z);
        }
        var (radius, count) = (run.Finite(run["Radius"]), run.Get<int>(run["Count"]));
        return kind == TurtleMoveKind.Circle ? TurtleCommand.Of(TurtleAction.Circle, radius, count)
            : TurtleCommand.Of(TurtleAction.Arc, radius, run.Finite(run["Angle"]), run.Finite(run["Height"]), count);
    }
}

/// <summary>How the turtle turns.</summary>
public enum TurtleRotateKind
{
    Turn,
    SetHeading,
    ChangeHeading,
}

/// <summary>A turn of the turtle.</summary>
public sealed class TurtleRotateComponent() : TurtleCommandComponent(
    "Turtle Rotate", "TRotate",
        "Turns the turtle. Positive yaw turns left, positive pitch raises the nose, positive roll raises the left side. The order is yaw, pitch, roll.")
{
    public override Guid ComponentGuid => new("c1b64e0a-37f5-4a0b-8f66-2f6d8f0b5d16");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Angle("Yaw", "Y", "Rotation about the up axis, in degrees.", 0);
        ports.Angle("Pitch", "P", "Rotation about the left axis, in degrees.", 0);
        ports.Angle("Roll", "R", "Rotation about the forward axis, in degrees.", 0);
        ports.Choice("Kind", "K", "Turn about the turtle's own axes, set the heading in world axes, or add to the angles of the heading.",
            TurtleRotateKind.Turn);
    }

    private protected override TurtleCommand Command(Run run)
    {
        var (yaw, pitch, roll) = (run.Finite(0), run.Finite(1), run.Finite(2));
        switch (run.Choice<TurtleRotateKind>(3))
        {
            case TurtleRotateKind.SetHeading: return TurtleCommand.Of(TurtleAction.Heading, yaw, pitch, roll);
            case TurtleRotateKind.ChangeHeading: return TurtleCommand.Of(TurtleAction.ChangeHeading, yaw, pitch, roll);
        }
        var turns = new List<TurtleCommand>();
        if (yaw != 0 || (pitch == 0 && roll == 0)) turns.Add(TurtleCommand.Of(TurtleAction.Yaw, yaw));
        if (pitch != 0) turns.Add(TurtleCommand.Of(TurtleAction.Pitch, pitch));
        if (roll != 0) turns.Add(TurtleCommand.Of(TurtleAction.Roll, roll));
        return Together(turns);
    }
}

/// <summary>Pen up or down.</summary>
public sealed class TurtlePenComponent() : TurtleCommandComponent(
    "Turtle Pen", "TPen", "Puts the pen down to print, or lifts it. Plan Toolpath adds the retractions.")
{
    public override Guid ComponentGuid => new("5e2c9f37-d1a8-4f39-9b7d-b0d7a3f24c17");

    private protected override void Inputs(InputPorts ports) => ports.Boolean("Down", "D", "Put the pen down. Moves print until it is lifted.", true);

    private protected override TurtleCommand Command(Run run) => TurtleCommand.Of(run.Get<bool>(0) ? TurtleAction.PenDown : TurtleAction.PenUp);
}

/// <summary>How an extrusion is given.</summary>
public enum TurtleExtrusionKind
{
    FilamentPerMm,
    Area,
    WidthAndHeight,
}

/// <summary>Extrusion and speed of the turtle.</summary>
public sealed class TurtleExtrusionComponent() : TurtleCommandComponent(
    "Turtle Extrusion", "TExtrude", "Sets the extrusion and the speed of the following moves.")
{
    public override Guid ComponentGuid => new("a84f1b2d-6e3c-47d0-8a19-5c9e0d7f1b18");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Extrusion by filament per mm of path, by area of the cross-section, or by width and height.",
            TurtleExtrusionKind.FilamentPerMm);
        ports.Number("Value", "V", "Filament in mm per mm of path, area in mm², or width in mm.", 0.05);
        ports.Number("Height", "H", "Bead height, in mm. 0 = unknown.", 0);
        ports.Number("Speed", "S", "Speed of the following moves, in mm/s. Default: unchanged.", optional: true);
    }

    private protected override TurtleCommand Command(Run run)
    {
        var value = run.Finite(1);
        var height = run.Finite(2);
        if (value < 0 || height < 0) throw new InputProblem("Value and Height must be 0 or more.");
        var commands = new List<TurtleCommand>
        {
            run.Choice<TurtleExtrusionKind>(0) switch
            {
                TurtleExtrusionKind.FilamentPerMm => TurtleCommand.Of(TurtleAction.Density, value),
                TurtleExtrusionKind.Area => TurtleCommand.Of(TurtleAction.Area, value, height),
                _ => TurtleCommand.Of(TurtleAction.Bead, value, height > 0 ? height
                    : throw new InputProblem("Height must be greater than zero for Width And Height.")),
            },
        };
        if (run.MaybeValue<double>(3) is not null) commands.Add(TurtleCommand.Of(TurtleAction.Speed, run.Positive(3)));
        return Together(commands);
    }
}

/// <summary>Kinds of events.</summary>
public enum TurtleEventKind
{
    Extrude,
    Dwell,
    Pause,
    NozzleTemperature,
    BedTemperature,
    Fan,
    Tool,
    Comment,
    RawLine,
    Layer,
    NextLayer,
    Color,
    Name,
    Push,
    Pop,
}

/// <summary>An event, a tag, or a branching point.</summary>
public sealed class TurtleEventComponent() : TurtleCommandComponent(
    "Turtle Event", "TEvent", "Adds an event, a tag for the following moves, or a branching point.")
{
    public override Guid ComponentGuid => new("f3d7c8e1-0b5a-4c92-a7e4-9a1c6b2d8f19");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Choice("Kind", "K", "Kind of event.", TurtleEventKind.Dwell);
        ports.Number("Value", "V", "Filament in mm, milliseconds, temperature in °C (waits until reached), or fan speed from 0 to 1. "
            + "Also tool or layer number, or height of the next layer in mm.", 0);
        ports.Text("Text", "T", "Message of a pause, comment, line of G-code, name, or color as #rrggbb.", "");
    }

    private protected override TurtleCommand Command(Run run)
    {
        var value = run.Finite(1);
        var text = run.Get<string>(2);
        var kind = run.Choice<TurtleEventKind>(0);
        // Actions have the same names.
        var action = kind == TurtleEventKind.RawLine ? TurtleAction.Raw : (TurtleAction)Enum.Parse(typeof(TurtleAction), kind.ToString());
        return kind switch
        {
            TurtleEventKind.Pause or TurtleEventKind.Comment or TurtleEventKind.RawLine or TurtleEventKind.Color or TurtleEventKind.Name
                => TurtleCommand.Of(action, text),
            TurtleEventKind.Push or TurtleEventKind.Pop => TurtleCommand.Of(action),
            _ => TurtleCommand.Of(action, value),
        };
    }
}

/// <summary>Repeats commands.</summary>
public sealed class TurtleRepeatComponent() : TurtleCommandComponent("Turtle Repeat", "TRepeat", "Repeats commands, as one command.")
{
    public override Guid ComponentGuid => new("08e5b6a9-4f2d-4e71-b3c8-d4f6a7012e1a");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new TurtleCommandParam(), "Commands", "C", "Turtle commands, in order.", GH_ParamAccess.list);
        ports.Integer("Count", "N", "Number of repetitions.", 4);
    }

    private protected override TurtleCommand Command(Run run)
    {
        var count = run.Get<int>(1);
        return TurtleCommand.Repeat(count >= 0 ? count : throw new InputProblem("Count must be 0 or more."), run.List<TurtleCommand>(0));
    }
}
