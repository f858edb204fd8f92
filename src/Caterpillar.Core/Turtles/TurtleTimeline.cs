namespace Caterpillar.Turtles;

/// <summary>A position along the steps of a turtle, by length: the pose there and the extrusions up to there.</summary>
public sealed class TurtleTimeline
{
    private readonly IReadOnlyList<TurtleMove> _moves;
    private readonly double[] _ends;

    /// <param name="steps">Steps of a turtle or of any other source.</param>
    public TurtleTimeline(IReadOnlyList<Step> steps)
    {
        if (steps is null) throw new ArgumentNullException(nameof(steps));
        _moves = TurtleHistory.Of(steps, start: First(steps));
        _ends = new double[_moves.Count];
        var sum = 0.0;
        for (var i = 0; i < _ends.Length; i++) _ends[i] = sum += _moves[i].Length;
    }

    /// <summary>The moves in order.</summary>
    public IReadOnlyList<TurtleMove> Moves => _moves;

    /// <summary>Length of all moves, mm.</summary>
    public double Length => _ends.Length == 0 ? 0 : _ends[_ends.Length - 1];

    /// <summary>
    /// The pose at a position along the path, 0 to 1, with X along the move and the wings level. Between two moves it is the pose of the first. Without moves
    /// it is the world frame.
    /// </summary>
    public Frame PoseAt(double part)
    {
        var (i, along) = At(part);
        if (i < 0) return Frame.World;
        var move = _moves[i];
        var yaw = 0.0;
        // Straight up and down, the turtle looks as it did on its last move in the plane.
        for (var k = i; k >= 0; k--)
        {
            var d = _moves[k].To - _moves[k].From;
            if (!(d.LengthXY > 1e-9)) continue;
            yaw = Basics.Angle.Atan2(d.Y, d.X);
            break;
        }
        var direction = move.To - move.From;
        var heading = direction.Length > 0 ? Heading.Towards(direction, yaw) : new Heading(yaw, 0, 0);
        return heading.ToFrame(Vec3.Lerp(move.From, move.To, along));
    }

    /// <summary>The move at a position along the path, 0 to 1, and the part of it that is done. −1 without moves.</summary>
    public (int Move, double Done) At(double part)
    {
        if (_moves.Count == 0) return (-1, 1);
        if (double.IsNaN(part)) throw new ArgumentOutOfRangeException(nameof(part), "A position along the path must be a number from 0 to 1.");
        var wanted = Math.Min(Math.Max(part, 0), 1) * Length;
        var i = Array.BinarySearch(_ends, wanted);
        if (i < 0) i = ~i;
        // Of several moves that end here, the first has a length.
        while (i > 0 && i < _ends.Length && _ends[i - 1] >= wanted) i--;
        i = Math.Min(i, _ends.Length - 1);
        while (i < _ends.Length - 1 && _moves[i].Length == 0) i++;
        var length = _moves[i].Length;
        return (i, length > 0 ? Math.Min(Math.Max((wanted - (_ends[i] - length)) / length, 0), 1) : 1);
    }

    private static Vec3 First(IReadOnlyList<Step> steps)
    {
        foreach (var step in steps)
        {
            if (step is PathStep path) return path.Path.Start;
            if (step is TravelStep travel) return travel.Points[0];
        }
        return Vec3.Zero;
    }
}
