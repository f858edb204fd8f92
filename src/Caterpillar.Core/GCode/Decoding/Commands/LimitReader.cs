namespace Caterpillar.GCode;

/// <summary>
/// Commands that set limits of the motion (M201, M203, M204, M205, M566, SET_VELOCITY_LIMIT) and the firmware retraction (M207, M208, SET_RETRACTION).
/// </summary>
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
            case 2070 when _rules.RetractionSettings is RetractionCommands.Marlin or RetractionCommands.RepRapFirmware:
                Retraction(line);
                return true;
            case 2080 when _rules.RetractionSettings == RetractionCommands.Marlin:
                SetRetraction("M208", new RetractionEvent(null, null, Word(line, 'S', 1), Word(line, 'F', 60)));
                return true;
            case 2010 or 2020 when _rules.Limits == LimitCommands.Repetier:
                var slower = Math.Min(line.Get('X', double.MaxValue), line.Get('Y', double.MaxValue));
                Named(slower, code == 2010 ? MotionLimit.PrintAcceleration : MotionLimit.TravelAcceleration);
                return true;
            case 2070 when _rules.Limits == LimitCommands.Repetier:
                Limit(line, 'X', MotionLimit.HeadJerk, 1);
                return true;
            case 2040 when _rules.Limits != LimitCommands.Repetier:
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

    /// <summary>SET_RETRACTION. The function returns the number of a word.</summary>
    public void TakeRetraction(Func<string, double?> word)
    {
        SetRetraction("SET_RETRACTION", new RetractionEvent(
            word("RETRACT_LENGTH"), word("RETRACT_SPEED"), word("UNRETRACT_EXTRA_LENGTH"), word("UNRETRACT_SPEED")));
        machine.State.Retraction = machine.State.Retraction with { IsRetracted = false };
    }

    // M207. Tools are taken to have the same settings.
    private void Retraction(ParsedLine line)
    {
        if (line.TryGet('P', out var tool) && tool != machine.State.Tool) return;
        var both = _rules.RetractionSettings == RetractionCommands.RepRapFirmware;
        SetRetraction("M207", new RetractionEvent(
            Word(line, 'S', 1), Word(line, 'F', 60), both ? Word(line, 'R', 1) : null, both ? Word(line, 'T', 60) ?? Word(line, 'F', 60) : null));
        if (Word(line, 'Z', 1) is not (>= 0 and < 1e3 and var lift)) return;
        if (_rules.RetractionLifts) machine.State.Retraction = machine.State.Retraction with { Lift = lift };
        else if (lift > 0) machine.Log.NotFollowed("M207 Z");
    }

    private double? Word(ParsedLine line, char letter, double unit) => line.TryGet(letter, out var value) ? value * machine.State.Modes.Unit / unit : null;

    private void SetRetraction(string name, RetractionEvent what)
    {
        if (!IsNumber(what.Length, 0) || !IsNumber(what.Speed, 0) || !IsNumber(what.Extra, -1e9) || !IsNumber(what.Back, 0)) return;
        if (what != new RetractionEvent(null, null, null, null)) _moves.AddEvent(what);
        if (machine.State.Retraction.IsRetracted)
            machine.Diagnostics.Warn("gcode.retraction_changed", $"{name} between G10 and G11: in {_rules.Title}, G11 may restore another amount than G10 has "
                + "retracted, or none. Set the retraction before G10 or after G11.");
    }

    private static bool IsNumber(double? value, double least) => value is null || (value >= least && value < 1e9);

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
