using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>A strand of infill.</summary>
/// <param name="Points">mm, at the height of the request; a closed line does not repeat its first point.</param>
/// <param name="Closed">A loop.</param>
/// <param name="Flow">Per segment the share of the requested strand's area to deposit, or null where that is 1 throughout.</param>
internal sealed record InfillLine(Vec3[] Points, bool Closed, double[]? Flow = null)
{
    /// <summary>Length in mm of a strand of the full area with the same volume.</summary>
    public double Length
    {
        get
        {
            var sum = 0.0;
            for (var i = Closed ? 0 : 1; i < Points.Length; i++)
            {
                // Segment i − 1 ends at point i; the one that closes a loop is the last.
                var segment = i == 0 ? Points.Length - 1 : i - 1;
                sum += Points[i].DistanceTo(Points[i == 0 ? Points.Length - 1 : i - 1]) * (Flow is null ? 1 : Flow[segment]);
            }
            return sum;
        }
    }
}
