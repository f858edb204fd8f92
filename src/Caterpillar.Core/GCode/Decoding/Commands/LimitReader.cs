using Caterpillar.Flavors;

namespace Caterpillar.GCode;

/// <summary>Commands that set limits of the motion: M201, M203, M204, M205, M566, SET_VELOCITY_LIMIT.</summary>
internal sealed class LimitReader(Machine machine)
{
    private const string Axes = "XYZE";
    private readonly FlavorRules _rules = machine.Rules;
    private readonly MoveRecorder _moves = machine.Moves;

    /// <summary>Reads an M command, given ten times its number. False if it is none of these.</summary>
    public bool Take(int code, ParsedLine line)
    {
        switch (code)
        {
            case 2040:
                Accelerations(line);
                return true;
            case 2010 when _rules.Limits is LimitCommands.Marlin or LimitCommands.RepRapFirmware:
                AxisLimits(line, MotionLimit.AccelerationX, 1);
                return true;
            case 2030 when _rules.Limits is LimitCommands.Marlin or LimitCommands.RepRapFirmware:
                AxisLimits(line, MotionLimit.SpeedX, _rules.Limits == LimitCommands.RepRapFirmware ? 1.0 / 60 : 1);
                return true;
            case 2050 when _rules.Limits == LimitCommands.Marlin:
                AxisLimits(line, MotionLimit.JerkX, 1);
                Limit(line, 'J', MotionLimit.JunctionDeviation, 1);
                return true;
            case 5660 when _rules.Limits == LimitCommands.RepRapFirmware:
                AxisLimits(line, MotionLimit.JerkX, 1.0 / 60);
                return true;
            default:
                return false;
        }
    }

    /// <summary>SET_VELOCITY_LIMIT. The function returns the number of a word.</summary>
    public void TakeVelocityLimit(Func<string, double?> word)
    {
        Named(word("VELOCITY"), MotionLimit.Speed);
        if (word("ACCEL") is > 0 and < 1e9 and var acceleration) _moves.AddEvent(new AccelerationEvent(acceleration));
        Named(word("SQUARE_CORNER_VELOCITY"), MotionLimit.SquareCornerVelocity);
        Named(word("MINIMUM_CRUISE_RATIO"), MotionLimit.MinimumCruiseRatio);
    }

    private void Accelerations(ParsedLine line)
    {
        var both = line.TryGet('S', out var s);
        if (_rules.Limits == LimitCommands.Klipper && !both)
        {
            // P and T count only together.
            both = line.TryGet('P', out var p) & line.TryGet('T', out var t);
            s = Math.Min(p, t);
        }
        else if (_rules.Limits == LimitCommands.None && !both)
        {
            both = line.TryGet('P', out s);
        }
        if (both && s is > 0 and < 1e9) _moves.AddEvent(new AccelerationEvent(s));
        if (_rules.Limits is not (LimitCommands.Marlin or LimitCommands.RepRapFirmware)) return;
        Limit(line, 'P', MotionLimit.PrintAcceleration, 1);
        Limit(line, 'T', MotionLimit.TravelAcceleration, 1);
        if (_rules.Limits == LimitCommands.Marlin) Limit(line, 'R', MotionLimit.RetractionAcceleration, 1);
    }

    private void AxisLimits(ParsedLine line, MotionLimit first, double unit)
    {
        for (var i = 0; i < Axes.Length; i++) Limit(line, Axes[i], first + i, unit);
    }

    private void Limit(ParsedLine line, char letter, MotionLimit limit, double unit)
    {
        if (line.TryGet(letter, out var value) && value is >= 0 and < 1e9) _moves.AddEvent(new LimitEvent(limit, value * unit));
    }

    private void Named(double? value, MotionLimit limit)
    {
        if (value is >= 0 and < 1e9 and var known) _moves.AddEvent(new LimitEvent(limit, known));
    }
}
