namespace Caterpillar.GCode;

/// <summary>A full block of moves, delivered while the rest of the file is still read.</summary>
/// <param name="Columns">Its moves.</param>
/// <param name="First">The number of its first move.</param>
/// <param name="Events">Its events, from the end of the previous block on.</param>
/// <param name="Start">Start of the first move of the file, mm. Null if unknown.</param>
/// <param name="Thicknesses">Thickness of each printed layer, mm. Null while the file has not stated all of them.</param>
internal sealed record DecodedBlock(ToolpathColumns Columns, int First, MoveEvent[] Events, Vec3? Start, double[]? Thicknesses);
