using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Turtles;

/// <summary>The initial state of a turtle. The defaults are those of ExtruderTurtle (Pezzuti Dyer and Buechley 2022, section 3).</summary>
public sealed record TurtleOptions
{
    /// <summary>Initial pose: X is forward, Y left, Z up; mm.</summary>
    public Frame Start { get; init; } = Frame.World;

    /// <summary>The extrusion model that converts mm of filament to extrusions; for a print that of its setup.</summary>
    public ExtrusionModel Extrusion { get; init; } = new(ExtrusionUnit.Mm, 1.75);

    /// <summary>mm of filament per mm of path.</summary>
    public double Density { get; init; } = ExtrusionModel.DefaultFactor;

    /// <summary>The initial extrusion, instead of the density; one without a speed uses the rate. Null for the density.</summary>
    public Bead? Bead { get; init; }

    /// <summary>Shape of extrusions that are given by width and height; for a print that of its settings.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Rectangle;

    /// <summary>Initial speed of moves with the pen down, mm/min.</summary>
    public double Rate { get; init; } = 1000;

    /// <summary>The most mm/s of a move straight up or down that lays nothing, as the printer's Z axis allows; infinite for no limit.</summary>
    public double MaxLiftSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Unit of all angles of the turtle.</summary>
    public AngleUnit AngleUnit { get; init; }

    /// <summary>Maximum deviation of chords from arcs and circles, mm, if no number of segments is given.</summary>
    public double ArcTolerance { get; init; } = 0.01;

    /// <summary>Keeps the pose after every command, for previews; see <see cref="Turtle.Poses"/>.</summary>
    public bool KeepPoses { get; init; }

    /// <summary>A turtle for a print: the extrusion model and extrusion shape of its setup, lifts as fast as the printer can.</summary>
    public static TurtleOptions For(PrintSetup setup)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return new TurtleOptions
        {
            Extrusion = setup.Extrusion,
            Shape = setup.Settings.BeadShape,
            MaxLiftSpeed = setup.Printer.MaxSpeed.Z > 0 ? setup.Printer.MaxSpeed.Z : double.PositiveInfinity,
        };
    }
}

/// <summary>Unit of angles.</summary>
public enum AngleUnit : byte
{
    /// <summary>360 to a full turn.</summary>
    Degrees,

    /// <summary>2π to a full turn.</summary>
    Radians,
}
