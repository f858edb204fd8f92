namespace Caterpillar.Slicing;

/// <summary>The walls of a region.</summary>
/// <param name="Paths">In no order of printing.</param>
/// <param name="Inside">Area left for infill, bounded by the inner edge of the innermost walls.</param>
/// <param name="TooThin">Area that is too narrow for a bead.</param>
internal sealed record WallResult(IReadOnlyList<WallPath> Paths, Region Inside, IReadOnlyList<ThinPlace> TooThin);

/// <summary>A part of a region that is too thin for the narrowest bead.</summary>
/// <param name="Place">A point of it, mm.</param>
/// <param name="Area">mm².</param>
internal readonly record struct ThinPlace(Vec3 Place, double Area);
