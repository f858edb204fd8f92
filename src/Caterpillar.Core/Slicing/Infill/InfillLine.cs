using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>A strand of infill.</summary>
/// <param name="Points">mm, at the height of the request; a closed line does not repeat its first point.</param>
/// <param name="Closed">A loop.</param>
/// <param name="Flow">Per segment the share of the requested strand's area to deposit, or null where that is 1 throughout.</param>
internal sealed record InfillLine(Vec3[] Points, bool Closed, double[]? Flow = null);
