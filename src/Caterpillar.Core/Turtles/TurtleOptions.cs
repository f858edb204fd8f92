using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Turtles;

/// <summary>How a turtle begins. The defaults are those of ExtruderTurtle (Pezzuti Dyer and Buechley 2022, section 3).</summary>
public sealed record TurtleOptions
{
    /// <summary>Where it stands and looks: X is forward, Y left, Z up; mm.</summary>
    public Frame Start { get; init; } = Frame.World;

    /// <summary>The law by which mm of filament become strands; for a print that of its setup.</summary>
    public ExtrusionModel Extrusion { get; init; } = new(ExtrusionUnit.Mm, 1.75);

    /// <summary>mm of filament per mm of path.</summary>
    public double Density { get; init; } = ExtrusionModel.DefaultFactor;

    /// <summary>The strand at first, in place of the density; one without a speed goes at the rate. Null for the density.</summary>
    public Bead? Bead { get; init; }

    /// <summary>mm/min.</summary>
    public double Rate { get; init; } = 1000;

    /// <summary>Unit of all angles that the turtle takes and gives.</summary>
    public AngleUnit AngleUnit { get; init; }

    /// <summary>Chords of arcs and circles keep within this distance of them, mm, where no number of segments is given.</summary>
    public double ArcTolerance { get; init; } = 0.01;

    /// <summary>Keeps the pose behind every command, for previews; see <see cref="Turtle.Poses"/>.</summary>
    public bool KeepPoses { get; init; }
}

/// <summary>Unit of angles.</summary>
public enum AngleUnit : byte
{
    Degrees,
    Radians,
}
