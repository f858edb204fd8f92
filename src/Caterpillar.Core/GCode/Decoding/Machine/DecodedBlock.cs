using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>A full block of moves, handed over while the rest of the file is still being read.</summary>
/// <param name="Columns">Its moves.</param>
/// <param name="Layers">The layer of each move, as it is numbered by then.</param>
/// <param name="First">The number of its first move.</param>
/// <param name="Events">What happens before its moves, since the block before.</param>
/// <param name="Start">Where the first move of the file begins, mm; null if unknown.</param>
/// <param name="Thicknesses">Thickness of each layer, mm, of those that are printed; null while the file has not said it for all of them.</param>
internal sealed record DecodedBlock(ToolpathColumns Columns, int[] Layers, int First, MoveEvent[] Events, Vec3? Start, double[]? Thicknesses);
