namespace Caterpillar.Machines;

/// <summary>
/// What the lines that fill an area look like. A percentage lays down the same length of extrusion with all of them but lightning, formulas and the user's
/// curves.
/// </summary>
public enum InfillPattern : byte
{
    /// <summary>Parallel lines; the direction turns from layer to layer.</summary>
    Lines,

    /// <summary>Parallel lines, each printed after its neighbor on one side, so that a skin looks even.</summary>
    Monotonic,

    /// <summary>Two families of lines at right angles in every layer: the rotated web of Caterpillar 2019.</summary>
    Grid,

    /// <summary>Three families of lines, 60° apart, that meet in common points.</summary>
    Triangles,

    /// <summary>Cubes that stand on a corner: three families of lines that shift from layer to layer.</summary>
    Cubic,

    /// <summary>Schoen's minimal surface: waves that alternate between two directions and support each other.</summary>
    Gyroid,

    /// <summary>Hexagons, drawn without crossings.</summary>
    Honeycomb,

    /// <summary>Loops along the boundary.</summary>
    Concentric,

    /// <summary>Hilbert's curve, which fills the plane with a single line.</summary>
    Hilbert,

    /// <summary>Trees that support the top skins and grow out of the walls; regions far below a skin stay empty.</summary>
    Lightning,

    /// <summary>The zero set of a formula in x, y and z.</summary>
    Formula,

    /// <summary>Curves of the user, cut at the boundary.</summary>
    Curves,
}
