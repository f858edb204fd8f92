namespace Caterpillar.Machines;

/// <summary>Infill pattern. At the same density all patterns have the same length of extrusion, except lightning, formula and curves.</summary>
public enum InfillPattern : byte
{
    /// <summary>Parallel lines that rotate from layer to layer.</summary>
    Lines,

    /// <summary>Parallel lines, printed in order from one side to the other for an even surface.</summary>
    Monotonic,

    /// <summary>Lines in two perpendicular directions in every layer: the rotated web of Caterpillar 2019.</summary>
    Grid,

    /// <summary>Lines in three directions, 60° apart, that meet in common points.</summary>
    Triangles,

    /// <summary>Cubes on a corner: lines in three directions that shift from layer to layer.</summary>
    Cubic,

    /// <summary>Schoen's gyroid: waves that alternate between two directions.</summary>
    Gyroid,

    /// <summary>Hexagons without crossing lines.</summary>
    Honeycomb,

    /// <summary>Loops parallel to the boundary.</summary>
    Concentric,

    /// <summary>Hilbert curve: one line that fills the area.</summary>
    Hilbert,

    /// <summary>Trees that grow out of the walls and support top surfaces only. The rest stays empty.</summary>
    Lightning,

    /// <summary>The zero set of a formula in x, y and z.</summary>
    Formula,

    /// <summary>Your own curves, cut at the boundary.</summary>
    Curves,
}
