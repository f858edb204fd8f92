namespace Caterpillar.Machines;

/// <summary>What the lines that fill an area look like. Whatever the pattern, the same percentage lays down the same length of strand.</summary>
public enum InfillPattern : byte
{
    /// <summary>Parallel lines; the direction turns from layer to layer.</summary>
    Lines,

    /// <summary>Parallel lines, each printed after its neighbors on one side, so that a skin shines evenly.</summary>
    Monotonic,

    /// <summary>Two families of lines at right angles in every layer: the rotated web of Caterpillar 2019.</summary>
    Grid,

    /// <summary>Three families of lines, 60° apart, that meet in points.</summary>
    Triangles,

    /// <summary>Cubes that stand on a corner: three families of lines that move on from layer to layer.</summary>
    Cubic,

    /// <summary>Schoen's minimal surface: waves that turn from one direction to the other and carry each other.</summary>
    Gyroid,

    /// <summary>Hexagons, drawn without crossings.</summary>
    Honeycomb,

    /// <summary>Loops along the boundary.</summary>
    Concentric,

    /// <summary>Hilbert's curve, which fills the plane with a single line.</summary>
    Hilbert,

    /// <summary>Trees that hold up the top skins and grow out of the walls; what is far below a skin stays empty.</summary>
    Lightning,

    /// <summary>The places where a formula in x, y and z is zero.</summary>
    Formula,

    /// <summary>Curves of the user, cut at the boundary.</summary>
    Curves,
}
