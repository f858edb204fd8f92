using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Turtles;

/// <summary>One move of a turtle's history.</summary>
/// <param name="From">Start, mm.</param>
/// <param name="To">End, mm.</param>
/// <param name="Prints">True if it deposited an extrusion.</param>
/// <param name="Filament">E: mm of filament; in place (From equals To) it may be negative.</param>
/// <param name="Rate">F: mm/min; 0 if planning chooses.</param>
public readonly record struct TurtleMove(Vec3 From, Vec3 To, bool Prints, double Filament, double Rate)
{
    /// <summary>Length in mm.</summary>
    public double Length => From.DistanceTo(To);
}

/// <summary>The moves of steps with their E and F, as drawn.</summary>
public static class TurtleHistory
{
    /// <summary>Every segment, travel and extrusion in place, in order. A first travel that states where the turtle started begins there.</summary>
    /// <param name="steps">Steps of a turtle.</param>
    /// <param name="filamentDiameter">mm.</param>
    /// <param name="start">Where the turtle started.</param>
    public static IReadOnlyList<TurtleMove> Of(IReadOnlyList<Step> steps, double filamentDiameter = 1.75, Vec3 start = default)
    {
        if (steps is null) throw new ArgumentNullException(nameof(steps));
        if (!(filamentDiameter > 0)) throw new ArgumentOutOfRangeException(nameof(filamentDiameter), "The filament diameter must be above 0 mm.");
        var filament = Math.PI * (filamentDiameter / 2) * (filamentDiameter / 2);
        var moves = new List<TurtleMove>();
        var at = start;
        foreach (var step in steps)
        {
            switch (step)
            {
                case PathStep { Path: var path }:
                    for (var i = 0; i < path.SegmentCount; i++)
                    {
                        var bead = path.BeadOf(i);
                        var to = path.EndOf(i);
                        moves.Add(new TurtleMove(path.Points[i], to, true, path.LengthOf(i) * bead.Area / filament, bead.Speed * 60));
                        at = to;
                    }
                    break;
                case TravelStep travel:
                    foreach (var point in travel.Points)
                    {
                        if (point != at) moves.Add(new TurtleMove(at, point, false, 0, travel.Speed * 60));
                        at = point;
                    }
                    break;
                case EventStep { Event: ExtrudeEvent extrude }:
                    moves.Add(new TurtleMove(at, at, false, extrude.Volume / filament, extrude.Speed * 60));
                    break;
            }
        }
        return moves;
    }
}
