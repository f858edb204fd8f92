namespace Caterpillar.Turtles;

/// <summary>One move of a turtle's history.</summary>
/// <param name="From">Start, mm.</param>
/// <param name="To">End, mm.</param>
/// <param name="Prints">True if the move printed.</param>
/// <param name="Filament">E in mm of filament. It can be negative in place (From equals To).</param>
/// <param name="Rate">F in mm/min; 0 = chosen by planning.</param>
public readonly record struct TurtleMove(Vec3 From, Vec3 To, bool Prints, double Filament, double Rate)
{
    /// <summary>Length in mm.</summary>
    public double Length => From.DistanceTo(To);
}

/// <summary>The moves of a turtle with their E and F, as drawn.</summary>
public static class TurtleHistory
{
    /// <summary>All segments, travels and extrusions in place, in order.</summary>
    /// <param name="steps">Steps of a turtle.</param>
    /// <param name="filamentDiameter">Diameter of the filament, mm.</param>
    /// <param name="start">Starting point of the turtle, mm. The first travel begins here.</param>
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
