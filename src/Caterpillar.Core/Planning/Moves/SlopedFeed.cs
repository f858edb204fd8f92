namespace Caterpillar.Planning;

/// <summary>The speed of moves that rise or fall, so that each axis holds it, and what that costs.</summary>
/// <param name="most">Maximum speed of each axis, mm/s; null = the printer decides.</param>
/// <param name="rounded">The last decimal of coordinates in the file, mm.</param>
internal sealed class SlopedFeed(AxisValues? most, double rounded)
{
    // Within this share the speed stays that of the move before: the material flows evenly along stretches of about equal slope.
    private const double Even = 0.9;
    private double _last;
    private double _least = double.PositiveInfinity;
    private double _seconds;
    private int _moves;

    /// <summary>The speed of a move, mm/s, at most the one that is wanted.</summary>
    public double Of(Vec3 from, Vec3 to, double length, double wanted)
    {
        if (most is not { } axes || from.Z == to.Z) return wanted;
        var path = to - from;
        var held = Math.Min(Held(path.Z, axes.Z), Math.Min(Held(path.X, axes.X), Held(path.Y, axes.Y)));
        if (!(held < wanted))
        {
            _last = 0;
            return wanted;
        }
        if (!(_last <= held && _last >= Even * held)) _last = held;
        // Shorter ones vanish in the file.
        if (length < rounded) return _last;
        _moves++;
        _least = Math.Min(_least, _last);
        _seconds += length / _last - length / wanted;
        return _last;

        // Coordinates are rounded at both ends.
        double Held(double along, double limit) => limit * length / (Math.Abs(along) + rounded);
    }

    /// <summary>One note with what it costs.</summary>
    public void Report(DiagnosticList diagnostics)
    {
        if (_moves == 0) return;
        diagnostics.Add(Severity.Note, "plan.axis_slowed", $"Rising and falling extrusions are slowed down to what the axes hold (Z {Text(most!.Value.Z)} "
            + $"mm/s), at least {Text(_least)} mm/s. This takes {NumberFormatter.Format((long)Math.Ceiling(_seconds))} s.", null, _moves);
    }

    private static string Text(double value) => NumberFormatter.Format(value, 1);
}
