namespace Caterpillar.Turtles;

/// <summary>The initial state of a turtle. The defaults are from ExtruderTurtle (Pezzuti Dyer and Buechley 2022, section 3).</summary>
public sealed record TurtleOptions
{
    /// <summary>Initial pose, mm. X is forward, Y left, Z up.</summary>
    public Frame Start { get; init; } = Frame.World;

    /// <summary>The extrusion model that converts mm of filament to extrusions. For a print, use the model of its setup.</summary>
    public ExtrusionModel Extrusion { get; init; } = new(ExtrusionUnit.Mm, 1.75);

    /// <summary>Initial bead. A bead without a speed moves at 1000 mm/min. Null = 0.05 mm of filament per mm of path.</summary>
    public Bead? Bead { get; init; }

    /// <summary>Bead shape of extrusions that are set by width and height. For a print, use the shape of its settings.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Rectangle;

    /// <summary>Maximum speed of travel moves straight up or down, mm/s, as the printer's Z axis allows. Infinite = no limit.</summary>
    public double MaxLiftSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Keep the pose after every move and turn for previews. See <see cref="Turtle.Poses"/>.</summary>
    public bool KeepPoses { get; init; }

    /// <summary>Options for a print: the extrusion model and bead shape of its setup, and the maximum Z speed of its printer.</summary>
    public static TurtleOptions For(PrintSetup setup)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return new TurtleOptions
        {
            Extrusion = setup.Extrusion,
            Shape = setup.Settings.BeadShape,
            MaxLiftSpeed = setup.Printer.MaxSpeed.Z,
        };
    }
}

/// <summary>Unit of angles.</summary>
public enum AngleUnit : byte
{
    /// <summary>A full turn is 360.</summary>
    Degrees,

    /// <summary>A full turn is 2π.</summary>
    Radians,
}
