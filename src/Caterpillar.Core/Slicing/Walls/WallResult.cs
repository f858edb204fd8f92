using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>The walls of a region.</summary>
/// <param name="Paths">In no order of printing.</param>
/// <param name="Inside">What is left for infill; its border is the inner edge of the innermost walls.</param>
/// <param name="TooThin">What no bead fits into.</param>
internal sealed record WallResult(IReadOnlyList<WallPath> Paths, Region Inside, IReadOnlyList<ThinPlace> TooThin);

/// <summary>A part of a region that is too thin for the narrowest bead.</summary>
/// <param name="Place">A point of it, mm.</param>
/// <param name="Area">mm².</param>
internal readonly record struct ThinPlace(Vec3 Place, double Area);
