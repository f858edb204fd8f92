namespace Caterpillar.Checks;

/// <summary>The speed that the axes and the extruder allow a move, as the firmware shares it out: see <see cref="CornerRules"/>.</summary>
internal sealed class AxisShares(Printer printer)
{
    // What rounding in a file may change: coordinates in mm, E in its unit.
    private readonly double _roundedXyz = Math.Pow(10, -printer.DecimalsXyz);
    private readonly double _roundedE = Math.Pow(10, -printer.DecimalsE);
    private readonly Kinematics? _kinematics = printer.Kinematics;
    private readonly bool _isHead = printer.Cornering == Cornering.SquareCornerVelocity;

    /// <summary>mm/s; an arc is taken by its chord in Z and by the slower of X and Y.</summary>
    /// <param name="move">The move; one in place is one of the extruder alone.</param>
    /// <param name="filament">mm of filament that it pushes, or pulls where negative.</param>
    /// <param name="limits">The limits in force.</param>
    public double MaxSpeed(in CheckedMove move, double filament, MachineLimits limits)
    {
        var leans = _kinematics is not null && (move.StartTurns != move.EndTurns || (move.EndTurns != Vec3.Zero && move.Length > 0));
        var along = leans ? RotaryColumns.Share(move.Length, move.StartTurns.DistanceTo(move.EndTurns)) : move.Length;
        if (!(along > 0)) return filament == 0 ? double.MaxValue : limits[MotionLimit.SpeedE];
        var most = leans ? Leaning(move, along, limits) : Upright(move, limits);
        // Klipper limits the extruder only where it works alone or pulls back.
        return filament > 0 && _isHead ? most : Math.Min(most, Axis(filament, along, limits[MotionLimit.SpeedE], _roundedE));
    }

    private double Upright(in CheckedMove move, MachineLimits limits)
    {
        var path = move.End - move.Start;
        var most = path == Vec3.Zero ? Math.Min(limits[MotionLimit.SpeedX], limits[MotionLimit.SpeedY])
            : _isHead ? Axis(path.Z, move.Length, limits[MotionLimit.SpeedZ], _roundedXyz) : Slides(path, move.Length, limits);
        return _isHead ? Math.Min(most, limits[MotionLimit.Speed]) : most;
    }

    // mm/s of the tip, or degrees/s where it stands.
    private double Leaning(in CheckedMove move, double along, MachineLimits limits)
    {
        var most = Slides(_kinematics!.Machine(move.End, move.EndTurns) - _kinematics.Machine(move.Start, move.StartTurns), along, limits);
        foreach (var axis in _kinematics.Axes)
            most = Math.Min(most, Axis(axis.Of(move.EndTurns) - axis.Of(move.StartTurns), along, axis.MaxSpeed, _roundedXyz));
        return most;
    }

    private double Slides(Vec3 path, double along, MachineLimits limits) => Math.Min(Axis(path.Z, along, limits[MotionLimit.SpeedZ], _roundedXyz),
        Math.Min(Axis(path.X, along, limits[MotionLimit.SpeedX], _roundedXyz), Axis(path.Y, along, limits[MotionLimit.SpeedY], _roundedXyz)));

    // If an axis moves by a few of the last decimals, its share is not known better. Nor is the length of a move of several axes.
    private static double Axis(double along, double length, double most, double rounded)
    {
        var path = Math.Abs(along) < 20 * rounded ? Math.Abs(along) - rounded : Math.Abs(along);
        return path > 0 ? most * (path < length ? length + rounded : length) / path : double.MaxValue;
    }
}
