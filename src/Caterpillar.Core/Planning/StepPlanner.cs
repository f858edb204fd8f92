namespace Caterpillar.Planning;

/// <summary>Goes through ordered steps once, batch by batch, and writes their moves.</summary>
internal sealed class StepPlanner
{
    private readonly PlanRules _rules;
    private readonly DiagnosticList _diagnostics;
    private readonly MoveEmitter _emitter;
    private readonly TravelPlanner _travel;
    private readonly PathPrinter _printer;
    private readonly OverrideState _overrides;
    private readonly PlanReport _counts;
    private readonly Deposit? _deposit;
    private readonly ReturnPath? _returnPath;
    private readonly SlowedRoles _slowed = new();
    private readonly SlopedFeed _feed;
    private readonly List<SourceLocation?> _places = [];

    // The steps of this batch, and their layers; the layers of the batch before.
    private OrderedStep[] _steps = [];
    private LayerClock? _clock;

    // True where the last path goes on in the next one.
    private bool _goesOn;

    // True after retraction for a drawn travel, until something is printed.
    private bool _prepared;

    public StepPlanner(
        PlanRules rules, PlanOptions options, bool returns, Action<Toolpath>? take, PlanReport counts, DiagnosticList diagnostics)
    {
        _rules = rules;
        _diagnostics = diagnostics;
        _counts = counts;
        _emitter = new MoveEmitter(rules, options, take, counts);
        if (returns) _returnPath = new ReturnPath(rules);
        if (returns || (rules.Settings.ZHopType == ZHopType.AbovePath && !rules.AddsNothing)) _deposit = new Deposit(rules.Cell, hasCells: false);
        var obstacle = rules.AddsNothing ? null : options.Obstacle;
        if (obstacle is not null)
        {
            if (_deposit is not null) Obstacle.AddTo(_deposit, obstacle);
            _returnPath?.Avoid(obstacle);
            _emitter.Reached(obstacle.Bounds.Max.Z);
        }
        _travel = new TravelPlanner(rules, _emitter, counts, _deposit) { RisesFirst = obstacle is not null };
        _feed = new SlopedFeed(rules.AddsNothing ? null : rules.Printer.MaxSpeed, rules.Rounded);
        _printer = new PathPrinter(rules, _emitter, counts, _deposit, _slowed, _feed);
        _overrides = new OverrideState(rules, _emitter);
        if (rules.Motion is not null) _emitter.BeforeTravel = _overrides.Travel;
        _emitter.StateTool();
        if (rules.FirmwareRetraction is { } retraction) _emitter.Event(retraction);
    }

    /// <summary>Writes the moves of the next steps.</summary>
    public void Add(OrderedStep[] steps, IProgress<double>? progress, CancellationToken cancel)
    {
        var below = _clock;
        _steps = steps;
        if (_rules.Waits || _rules.Tools.Any(t => t.Material is { FanLayerTime: > 0 })) _clock = new LayerClock(steps, _rules);
        NotePlaces();
        for (var i = 0; i < _steps.Length; i++)
        {
            if ((i & 255) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)i / _steps.Length);
            }
            _emitter.Source = _steps[i].Source;
            _emitter.Line = _steps[i].Step.Source?.Line ?? 0;
            switch (_steps[i].Step)
            {
                case PathStep step:
                    if (i == 0 && below is not null) WaitFor(below, below.Count - 1);
                    else if (_clock is not null && _clock.Changes(i)) WaitFor(_clock, i - 1);
                    Path(i, step, _clock?.TimeOf(i) ?? double.PositiveInfinity);
                    break;
                case TravelStep travel: Travel(travel, i); break;
                case EventStep step: Event(step.Event); break;
            }
        }
    }

    /// <summary>The moves of all steps. Adds the remaining diagnostics.</summary>
    public Toolpath Build()
    {
        _overrides.End();
        _slowed.Report(_diagnostics);
        _feed.Report(_diagnostics);
        if (_overrides.CouldNotRevert)
            _diagnostics.Add(Severity.Note, "plan.override_kept",
                "A path overrides a setting whose default is unknown. The new value stays in effect after the path.");
        if (_emitter.PrintedRetracted)
        {
            _diagnostics.Add(
                Severity.Warning, "plan.printed_retracted",
                    "Paths start while filament is retracted, so their first E only deretracts it. Deretract before printing.");
        }
        return _emitter.Build(_places.Exists(p => p is not null) ? _places : null);
    }

    private void NotePlaces()
    {
        foreach (var step in _steps) _places.Add(null);
        foreach (var step in _steps) _places[step.Source] = step.Step.Source;
    }

    private void Path(int index, PathStep step, double layerTime)
    {
        var path = _steps[index].Path!;
        var length = path.Length;
        if (!(length > 0))
        {
            _diagnostics.Add(Severity.Warning, "plan.empty_path", "A path has no length and is skipped.", new SourceLocation(Step: _emitter.Source));
            return;
        }
        _counts.Paths++;
        _emitter.EnterLayer(path.Layer);
        if (path.Tool != _emitter.Tool) SwitchTool(path.Tool, path);
        var flows = _goesOn && _emitter.Retracted == 0 && _emitter.Position.DistanceTo(path.Start) <= TravelPlanner.Touching;
        _goesOn = step.GoesOn && IsNext(index, path.End);
        _travel.To(path.Start, direct: !_prepared, step.Region);
        _overrides.Apply(path, layerTime);
        _travel.Restore();
        _printer.Print(path, length, flows, _goesOn, ReferenceEquals(path, step.Path) ? step.Lines : null);
        _returnPath?.Print(path);
        _travel.Printed(path, step.Region);
        _prepared = false;
    }

    // The next step begins there, as far as it is known: the layer above is another batch.
    private bool IsNext(int index, Vec3 end)
        => index + 1 == _steps.Length || (_steps[index + 1].Path is { } next && next.Start.DistanceTo(end) <= TravelPlanner.Touching);

    // Time that a finished layer lacks for cooling: the head waits above it, or beside it.
    private void WaitFor(LayerClock clock, int last)
    {
        const double Aside = 10;
        var missing = _rules.Settings.MinLayerTime - clock.TimeOf(last);
        if (!_rules.Waits || !(missing > 0) || !_emitter.IsPlaced) return;
        _travel.RetractFor(double.PositiveInfinity);
        var at = _emitter.Position;
        var up = at.WithZ(Math.Max(at.Z, _emitter.Highest) + _rules.Clearance);
        if (up.Z <= _rules.Printer.BuildBounds.Max.Z) _emitter.Travel(up, _rules.Printer.ZHopSpeed);
        if (_rules.Settings.LayerTimeWait == LayerTimeWait.NextTo)
        {
            var box = clock.BoxOf(last);
            double left = box.Min.X - Aside, right = box.Max.X + Aside;
            var x = left >= _rules.Printer.BuildBounds.Min.X ? left : right <= _rules.Printer.BuildBounds.Max.X ? right : at.X;
            _emitter.Travel(_emitter.Position with { X = x }, _rules.Settings.TravelSpeed);
        }
        _counts.Waits++;
        _emitter.Dwell(new DwellEvent(Math.Ceiling(missing * 1000) / 1000));
    }

    private void Travel(TravelStep travel, int index)
    {
        _counts.DrawnTravels++;
        if (!_prepared && _emitter.IsPlaced && !_rules.AddsNothing) _travel.RetractFor(LengthToNextPrint(index));
        _prepared = true;
        if (travel.Intent == TravelIntent.Return && _returnPath is not null && _emitter.IsPlaced)
        {
            Return(travel);
            return;
        }
        var first = !_emitter.IsPlaced && _travel.RisesFirst ? 1 : 0;
        if (first > 0) _travel.To(travel.Points[0], direct: false, null);
        for (var i = first; i < travel.Points.Count; i++)
        {
            var point = travel.Points[i];
            _emitter.Travel(point, travel.Speed > 0 ? travel.Speed : _rules.Settings.TravelSpeed);
            _returnPath?.Visit(point);
        }
    }

    // Back along the branch if that path is free and faster than up, over and down; else over the top.
    private void Return(TravelStep travel)
    {
        var goal = travel.Points[travel.Points.Count - 1];
        var from = _emitter.Position;
        var back = _returnPath!.BackTo(goal);
        if (from.DistanceTo(goal) <= TravelPlanner.Touching) return;
        if (_returnPath.Blocked(from, goal) is { } blocked)
        {
            _counts.BlockedReturns++;
            _diagnostics.Add(
                Severity.Warning, "plan.blocked_return", $"The head cannot return from {from} to {goal}: at {blocked} it hits what is printed next to it. "
                + "Draw steep branches last.", (travel.Source ?? new SourceLocation()) with { Step = _emitter.Source });
        }
        else if (back is not null && ReturnPath.Length(from, back) / _rules.Settings.TravelSpeed < _travel.TimeOver(goal)
            && _returnPath.Along(from, back) == HeadContact.None)
        {
            _counts.ReturnsAlong++;
            foreach (var point in back) _emitter.Travel(point, _rules.Settings.TravelSpeed);
            return;
        }
        else
        {
            _counts.ReturnsOver++;
        }
        _travel.Over(goal, safely: true);
    }

    // The total length without printing from here, mm; infinite if nothing is printed after it.
    private double LengthToNextPrint(int index)
    {
        var at = _emitter.Position;
        var length = 0.0;
        for (; index < _steps.Length; index++)
        {
            switch (_steps[index].Step)
            {
                case PathStep:
                    return length + at.DistanceTo(_steps[index].Path!.Start);
                case EventStep { Event: ExtrudeEvent { Volume: > 0 } }:
                    return length;
                case TravelStep travel:
                    foreach (var point in travel.Points)
                    {
                        length += at.DistanceTo(point);
                        at = point;
                    }
                    break;
            }
        }
        return double.PositiveInfinity;
    }

    private void Event(PrinterEvent what)
    {
        switch (what)
        {
            case ExtrudeEvent extrude:
                Extrude(extrude);
                return;
            case ToolEvent tool:
                if (tool.Tool != _emitter.Tool) SwitchTool(tool.Tool, null);
                return;
            case DwellEvent dwell:
                _emitter.Dwell(dwell);
                return;
        }
        _overrides.Note(what);
        _emitter.Event(what);
    }

    private void Extrude(ExtrudeEvent extrude)
    {
        if (extrude.IsDot) _travel.Restore();
        var tool = _emitter.ToolRules;
        var e = tool.EOf(extrude.Volume);
        if (e < 0) _emitter.Retract(-e, extrude.Speed > 0 ? extrude.Speed : tool.RetractSpeed);
        else if (e > 0) Prime(e, extrude.Speed > 0 ? extrude.Speed : tool.DeretractionSpeed);
    }

    private void Prime(double e, double speed)
    {
        _emitter.Prime(e, speed);
        _travel.Primed();
        _prepared = false;
    }

    // Where the tool heats up, it drips: on the purge tower, if that comes next.
    private void SwitchTool(int tool, PrintPath? next)
    {
        if (_emitter.IsPlaced)
        {
            _travel.RetractFor(double.PositiveInfinity);
            if (next is { Role: Role.PrimeTower })
            {
                _travel.To(next.Start, direct: false, null);
                if (_emitter.Retracted == 0) _travel.RetractFor(double.PositiveInfinity);
            }
        }
        _overrides.SwitchTool(tool, next);
    }
}
