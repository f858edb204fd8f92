namespace Caterpillar.Checks;

/// <summary>
/// Speeds and accelerations beyond the axes and the extruder, limits that the file raises above those of the printer, more material than hot end and material
/// allow, missing tools.
/// </summary>
internal sealed class RateCheck(IReadOnlyList<ToolpathTool> tools, PrintSetup setup, Findings findings) : MoveCheck
{
    private const double Rounding = 1.001;
    private readonly Printer _printer = setup.Printer;
    private readonly AxisShares _shares = new(setup.Printer);

    // Of the printer, and as the file has set them by now.
    private readonly MachineLimits _own = new(setup.Printer);
    private readonly MachineLimits _limits = new(setup.Printer);
    private readonly double[] _filamentPerE = MotionPlanner.FilamentPerE(tools, setup);
    private readonly double[] _maxFlows = [.. Enumerable.Range(0, setup.Printer.ToolCount).Select(tool => setup.OfTool(tool).MaxFlow)];
    private bool _raised;
    private int _tool;

    // What rounding in a file may change: coordinates in mm, E, speeds in mm/s.
    private readonly double _roundedXyz = Math.Pow(10, -setup.Printer.DecimalsXyz);
    private readonly double _roundedE = Math.Pow(10, -setup.Printer.DecimalsE);
    private readonly double _roundedF = Math.Pow(10, -setup.Printer.DecimalsF) / 60;

    public override IReadOnlyList<string> Codes =>
    [
        CheckCodes.Flow, CheckCodes.Speed, CheckCodes.TravelSpeed, CheckCodes.Acceleration, CheckCodes.Raised, CheckCodes.Tool,
    ];

    public override void Event(MoveEvent what)
    {
        _limits.Apply(what.Event);
        switch (what.Event)
        {
            case AccelerationEvent set:
                CheckAcceleration(what, set.Value, MostAcceleration(MotionLimit.PrintAcceleration));
                break;
            case LimitEvent { Limit: <= MotionLimit.AccelerationE } set:
                CheckAcceleration(what, set.Value, MostAcceleration(set.Limit));
                break;
            case ToolEvent set:
                _tool = set.Tool;
                break;
            case NozzleTemperatureEvent { Celsius: > 0 } set when (set.Tool ?? _tool) is >= 0 and var tool && tool < _maxFlows.Length:
                _maxFlows[tool] = setup.OfTool(tool).MaxFlowAt(set.Celsius);
                break;
            case LimitEvent set:
                if (!Counts(set.Limit) || !(set.Value > _own[set.Limit])) break;
                _raised |= set.Limit is MotionLimit.Speed or <= MotionLimit.SpeedE;
                ReportRaised(what, set);
                break;
        }
    }

    public override void Move(in CheckedMove move)
    {
        if (move.Tool >= _printer.ToolCount) ReportTool(move);
        if (!move.StartKnown) return;
        var filament = move.E * _filamentPerE[Math.Min(Math.Max(move.Tool, 0), _filamentPerE.Length - 1)];
        var most = _shares.MaxSpeed(move, filament, _limits);
        // Travels are slowed down without harm; an extrusion printed more slowly is not the one that was asked for.
        if (move.Speed > most + _roundedF) ReportSpeed(move, most, "The printer will slow down.");
        else if (_raised && _shares.MaxSpeed(move, filament, _own) is var own && move.Speed > own + _roundedF)
            ReportSpeed(move, own, "The file has raised this limit.");
        if (!(move.Length > 0)) return;
        var flow = move.Deposited / move.Length * Math.Min(move.Speed, most);
        // In short and in slow moves the last decimals count for more.
        var least = (move.Deposited - _roundedE * move.Pushed / move.E) / (move.Length + 2 * _roundedXyz) * Math.Min(move.Speed - _roundedF / 2, most);
        var allowed = _maxFlows[Math.Min(Math.Max(move.Tool, 0), _maxFlows.Length - 1)];
        if (least > allowed * Rounding) ReportFlow(flow, allowed, move.Index);
    }

    private double MostAcceleration(MotionLimit limit) => limit switch
    {
        MotionLimit.AccelerationX => _printer.MaxAcceleration.X,
        MotionLimit.AccelerationY => _printer.MaxAcceleration.Y,
        MotionLimit.AccelerationZ => _printer.MaxAcceleration.Z,
        MotionLimit.PrintAcceleration or MotionLimit.TravelAcceleration => Math.Max(_printer.MaxAcceleration.X, _printer.MaxAcceleration.Y),
        _ => _printer.MaxAcceleration.E,
    };

    // Of the limits for corners only those of the firmware's own rule.
    private bool Counts(MotionLimit limit) => limit switch
    {
        >= MotionLimit.JerkX and <= MotionLimit.JerkE or MotionLimit.HeadJerk => _printer.Cornering == Cornering.Jerk,
        MotionLimit.JunctionDeviation => _printer.Cornering == Cornering.JunctionDeviation,
        MotionLimit.SquareCornerVelocity or MotionLimit.Speed => _printer.Cornering == Cornering.SquareCornerVelocity,
        MotionLimit.MinimumCruiseRatio => false,
        _ => true,
    };

    private void CheckAcceleration(MoveEvent what, double value, double most)
    {
        if (!(value > most)) return;
        findings.Add(CheckCodes.Acceleration, what.Move,
            () => $"The acceleration is set to {Figures.Short(value)} mm/s², but {_printer.Title} allows only {Figures.Short(most)} mm/s². Lower it.");
    }

    private void ReportRaised(MoveEvent what, LimitEvent set)
        => findings.Add(CheckCodes.Raised, () => findings.PlaceOfEvent(what), () =>
        {
            var unit = set.Limit == MotionLimit.JunctionDeviation ? "mm" : "mm/s";
            return $"{Name(set.Limit)} is raised to {Figures.Short(set.Value)} {unit}, but {_printer.Title} "
                + $"has {Figures.Short(_own[set.Limit])} {unit}. Lower it.";
        });

    private static string Name(MotionLimit limit) => limit switch
    {
        <= MotionLimit.SpeedE => $"The maximum speed of {"XYZE"[limit - MotionLimit.SpeedX]}",
        <= MotionLimit.JerkE => $"The jerk of {"XYZE"[limit - MotionLimit.JerkX]}",
        MotionLimit.JunctionDeviation => "The junction deviation",
        MotionLimit.HeadJerk => "The jerk of X and Y",
        MotionLimit.SquareCornerVelocity => "The square corner velocity",
        _ => "The maximum speed of the print head",
    };

    private void ReportTool(in CheckedMove move)
    {
        var tool = move.Tool;
        findings.Add(CheckCodes.Tool, move.Index,
            () => $"Move uses tool {NumberFormatter.Format(tool)}, but {_printer.Title} has {PlanRun.OnlyTools(_printer.ToolCount)}.");
    }

    private void ReportSpeed(in CheckedMove move, double most, string consequence)
    {
        var (speed, inPlace) = (move.Speed, !(move.Length > 0));
        findings.Add(move.Kind == MoveKind.Print ? CheckCodes.Speed : CheckCodes.TravelSpeed, move.Index,
            () => $"{(inPlace ? "An extruder move" : "A move")} has a speed of {Figures.Short(speed)} mm/s, but {_printer.Title} allows only "
                + $"{Figures.Short(most)} mm/s{(inPlace ? "" : " in this direction")}. {consequence}", speed / most);
    }

    private void ReportFlow(double flow, double most, int move)
        => findings.Add(CheckCodes.Flow, move,
            () => $"A move needs a flow of {Figures.Short(flow)} mm³/s, but the maximum is {Figures.Short(most)} mm³/s. "
                + "Lower speed, width or layer height.", flow);
}
