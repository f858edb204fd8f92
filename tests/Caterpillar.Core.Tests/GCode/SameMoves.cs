using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests.GCode;

/// <summary>
/// Walks two toolpaths move by move. Homing moves are skipped: they follow from the position of the head (the event is compared, and the next move starts
/// there). A move that is written as nothing, because its length and its E are below the last decimal, may be missing in either.
/// </summary>
internal sealed partial class SameMoves
{
    private readonly Move[] _a;
    private readonly Move[] _b;
    private readonly Toolpath _expected;
    private readonly Toolpath _actual;
    private readonly MoveTolerance _t;
    private readonly bool[] _homeA;
    private readonly bool[] _homeB;
    private readonly Dictionary<int, int> _layerOf = [];
    private readonly Dictionary<string, string> _objectOf = [];
    private readonly Dictionary<int, int> _layerBack = [];
    private readonly List<PrinterEvent> _eventsA = [];
    private readonly List<PrinterEvent> _eventsB = [];
    private int _nextA;
    private int _nextB;
    private int _toolA;
    private int _toolB;
    private int _i;
    private int _j;
    private readonly Sums _sums;

    private SameMoves(Toolpath expected, Toolpath actual, MoveTolerance tolerance)
    {
        _expected = expected;
        _actual = actual;
        _t = tolerance;
        _a = expected.Moves().ToArray();
        _b = actual.Moves().ToArray();
        _homeA = HomingMoves(expected, _a);
        _homeB = HomingMoves(actual, _b);
        _sums = new Sums(Math.Max(expected.Tools.Count, actual.Tools.Count));
    }

    /// <summary>The first difference, or null.</summary>
    public static string? Difference(Toolpath expected, Toolpath actual, MoveTolerance? tolerance = null)
        => new SameMoves(expected, actual, tolerance ?? new MoveTolerance()).Walk();

    private string? Walk()
    {
        while (true)
        {
            while (_i < _a.Length && _homeA[_i]) SkipA();
            while (_j < _b.Length && _homeB[_j]) SkipB();
            if (_i == _a.Length && _j == _b.Length) break;
            if (_i < _a.Length && IsLostRetraction(_a[_i]))
            {
                SkipA();
                continue;
            }
            if (_i < _a.Length && _j < _b.Length && Alike(_a[_i], _b[_j])
                && (InStep(_a[_i], _b[_j]) || !(Vanishes(_a[_i], _t.Factor(_a[_i].Tool)) || Vanishes(_b[_j], 1))))
            {
                if (Match() is { } difference) return difference;
                continue;
            }
            if (_i < _a.Length && _t.Chords > 0 && _a[_i].Arc is { } && (_j == _b.Length || _b[_j].Arc is null))
            {
                if (Chain() is { } difference) return difference;
                continue;
            }
            if (_i < _a.Length && Vanishes(_a[_i], _t.Factor(_a[_i].Tool))) SkipA();
            else if (_j < _b.Length && Vanishes(_b[_j], 1)) SkipB();
            else return Said("differs");
        }
        TakeEvents();
        return Events();
    }

    private string? Match()
    {
        TakeEvents();
        if (Events() is { } events) return events;
        var a = _a[_i];
        var b = _b[_j];
        _sums.Expect(a.Tool, ExpectedE(a), a.Deposited * _t.Factor(a.Tool));
        _sums.Find(b.Tool, b.E, b.Deposited);
        if (_t.Tools && a.Tool != b.Tool) return Said("tool");
        if (Drift(a.Tool) is { } drift) return Said(drift);
        // What the firmware does in place by itself has a speed of its own.
        if (b.Speed > 0 && a.Speed > 0 && (a.E != 0 || a.Length > 1e-9) && Math.Abs(a.Speed - b.Speed) > _t.Speed && !IsStandIn(a)) return Said("speed");
        if (a.Kind == MoveKind.Print && b.Kind == MoveKind.Print && a.Role != b.Role && !(_t.UnknownRoles && a.Role == Role.Unspecified)) return Said("role");
        if (Layers(a, b) is { } layers) return layers;
        _i++;
        _j++;
        return null;
    }

    private bool InStep(Move a, Move b) => a.Tool == b.Tool && Math.Abs(_sums.E(a.Tool) + ExpectedE(a) - b.E) <= Slack(_sums.Largest(a.Tool));

    // E stands in another unit of the last place at 10⁶.
    private double Slack(double sum) => _t.Amounts ? 1.02 * _t.E * _t.LargestFactor + 1e-12 * Math.Abs(sum) : double.PositiveInfinity;

    private string? Drift(int tool)
    {
        if (Math.Abs(_sums.E(tool)) > Slack(_sums.Largest(tool))) return "sums of E drift apart by " + _sums.E(tool);
        // G10 and G11 of different tools have no balance that lengths could keep.
        return !(_t.RetractionLength > 0)
            && Math.Abs(_sums.Deposited(tool)) > 2 * Slack(_sums.Largest(tool)) ? "deposited sums drift apart by " + _sums.Deposited(tool) : null;
    }

    private double ExpectedE(Move move)
        => IsStandIn(move) ? (move.Kind == MoveKind.Retract ? -1 : 1) * _t.RetractionLength!.Value : move.E * _t.Factor(move.Tool);

    private bool IsFirmware(Move move) => move.E == 0 && move.Kind is MoveKind.Retract or MoveKind.Deretract && move.E == 0;

    private bool IsStandIn(Move move) => _t.RetractionLength > 0 && IsFirmware(move);

    private bool IsLostRetraction(Move move)
        => (_t.RetractionLength == 0 && IsFirmware(move)) || (!_t.Amounts && move.Kind is MoveKind.Retract or MoveKind.Deretract or MoveKind.Prime);

    private bool Alike(Move a, Move b)
    {
        if (a.End.DistanceTo(b.End) > _t.Xyz) return false;
        if (a.Kind != b.Kind && !MayChange(a, b)) return false;
        if (Math.Abs(ExpectedE(a) - b.E) > 2.04 * _t.E * _t.LargestFactor && _t.Amounts) return false;
        return a.Arc is null == b.Arc is null ? SameCurve(a, b) : Tiny(a);
    }

    // Less than a unit of E is written as none; a length of less than a unit as none.
    private bool MayChange(Move a, Move b)
    {
        if (!_t.Amounts) return (a.Kind == MoveKind.Print) == (b.Kind == MoveKind.Print);
        var small = (a.E != 0 || b.E != 0) && (Math.Abs(a.E * _t.Factor(a.Tool)) <= 1.02 * _t.E || Math.Abs(b.E) <= 1.02 * _t.E);
        // Rounded amounts of a retraction and its restore may leave a unit to print, or to be pushed forward first.
        var pushes = a.Kind is MoveKind.Print or MoveKind.MovingDeretract && b.Kind is MoveKind.Print or MoveKind.MovingDeretract
            || a.Kind is MoveKind.Prime or MoveKind.Deretract && b.Kind is MoveKind.Prime or MoveKind.Deretract;
        if (pushes && a.E != 0 && Math.Abs(a.Deposited * _t.Factor(a.Tool) - b.Deposited) <= 2.04 * _t.E) return true;
        return (small && a.Kind != MoveKind.Dwell && b.Kind != MoveKind.Dwell) || (a.E != 0 && Tiny(a)) || (b.E != 0 && Tiny(b))
            || (_t.RetractionLength > 0 && a.E >= 0 == b.E >= 0);
    }

    private bool Tiny(Move move) => move.Length <= 1.8 * _t.Xyz;

    private bool Vanishes(Move move, double factor)
        => Tiny(move) && (!_t.Amounts || Math.Abs(move.E * factor) <= 1.02 * _t.E)
            && move.Kind is not (MoveKind.Dwell or MoveKind.Retract or MoveKind.Deretract) | move.E != 0;

    private string? Layers(Move a, Move b)
    {
        if (_t.LayersOfExtrusions && (a.Kind != MoveKind.Print || b.Kind != MoveKind.Print)) return null;
        if (_t.SameLayers)
        {
            var x = a.Layer < 0 ? null : _expected.Layers[a.Layer];
            var y = b.Layer < 0 ? null : _actual.Layers[b.Layer];
            return x?.Index == y?.Index && SameObject(x?.Object ?? "", y?.Object ?? "") ? null : Said($"layer {x} became {y}");
        }
        if (_layerOf.TryGetValue(a.Layer, out var known) && known != b.Layer) return Said("layers are divided otherwise");
        if (_layerBack.TryGetValue(b.Layer, out var back) && back != a.Layer) return Said("layers are joined");
        _layerOf[a.Layer] = b.Layer;
        _layerBack[b.Layer] = a.Layer;
        return null;
    }

    // Flavors without commands for objects lose them, and others have numbers instead of names.
    private bool SameObject(string a, string b)
    {
        if (_t.Target is null) return a == b;
        if (_t.Target.ObjectMarks == ObjectMarking.None) return true;
        if (!_objectOf.TryGetValue(a, out var known)) _objectOf.Add(a, known = b);
        return known == b && a.Length == 0 == (b.Length == 0);
    }

    private void SkipA()
    {
        if (!_homeA[_i] && !IsLostRetraction(_a[_i]))
            _sums.Expect(_a[_i].Tool, _a[_i].E * _t.Factor(_a[_i].Tool), _a[_i].Deposited * _t.Factor(_a[_i].Tool));
        _i++;
    }

    private void SkipB()
    {
        _sums.Find(_b[_j].Tool, _b[_j].E, _b[_j].Deposited);
        _j++;
    }

    private void TakeEvents()
    {
        for (; _nextA < _expected.Events.Count && _expected.Events[_nextA].Move <= _i; _nextA++) Take(_eventsA, _expected.Events[_nextA].Event, ref _toolA);
        for (; _nextB < _actual.Events.Count && _actual.Events[_nextB].Move <= _j; _nextB++) Take(_eventsB, _actual.Events[_nextB].Event, ref _toolB);
    }

    private void Take(List<PrinterEvent> events, PrinterEvent what, ref int tool)
    {
        // The current tool is not a change.
        if (what is ToolEvent change)
        {
            if (!_t.Tools) return;
            if (change.Tool == tool) return;
            tool = change.Tool;
        }
        // Comments and lines of text are nothing that the machine does; the message of a pause is a comment.
        if (what is CommentEvent or RawEvent || (what is FanEvent && _t.Fan == FanScale.None)) return;
        if (_t.Target is { } target && what is NozzleTemperatureEvent or BedTemperatureEvent or AccelerationEvent or FinishMovesEvent or LimitEvent
            && !EventText.Lines(what, target).Any(l => FlavorCommands.Of(target).Find(l) is { IsKnown: true }))
        {
            return;
        }
        // Marlin has two commands for what is one elsewhere, and RepRapFirmware one speed for both directions.
        if (_t.Target is not null && what is RetractionEvent) return;
        events.Add(what is PauseEvent ? new PauseEvent() : what);
    }

    // M116, which waits for the temperatures set before, becomes a wait for each of them.
    private bool IsWaitForAll(PrinterEvent wait) => _t.Target is not null && !_eventsA.Contains(wait) && _expected.Events.Any(e => (e.Event, wait) switch
    {
        (NozzleTemperatureEvent set, NozzleTemperatureEvent { Wait: true } waits) => !set.Wait && e.Move <= _i && set.Celsius == waits.Celsius,
        (BedTemperatureEvent set, BedTemperatureEvent { Wait: true } waits) => !set.Wait && e.Move <= _i && set.Celsius == waits.Celsius,
        _ => false,
    });

    private string? Events()
    {
        if (_eventsB.Count > _eventsA.Count) _eventsB.RemoveAll(IsWaitForAll);
        var same = _eventsA.Count == _eventsB.Count;
        for (var k = 0; same && k < _eventsA.Count; k++) same = SameEvent(_eventsA[k], _eventsB[k]);
        var message = same ? null : Said("events " + string.Join(" ", _eventsA) + " became " + string.Join(" ", _eventsB));
        _eventsA.Clear();
        _eventsB.Clear();
        return message;
    }

    private bool SameEvent(PrinterEvent a, PrinterEvent b) => (a, b) switch
    {
        (FanEvent x, FanEvent y) when _t.Fan == FanScale.Switch => x.Speed > 0 == y.Speed > 0,
        (FanEvent x, FanEvent y) => Math.Abs(x.Speed - y.Speed) <= 0.5 / 255 + 1e-9,
        (DwellEvent x, DwellEvent y) => Math.Abs(x.Seconds - y.Seconds) <= 5.1e-4,
        (NozzleTemperatureEvent x, NozzleTemperatureEvent y) => x.Wait == y.Wait && (x.Tool == y.Tool || !_t.Tools) && Math.Abs(x.Celsius - y.Celsius) <= 0.051,
        (BedTemperatureEvent x, BedTemperatureEvent y) => x.Wait == y.Wait && Math.Abs(x.Celsius - y.Celsius) <= 0.051,
        (RetractionEvent x, RetractionEvent y) => Near(x.Length, y.Length) && Near(x.Speed, y.Speed) && Near(x.Extra, y.Extra) && Near(x.Back, y.Back),
        (AccelerationEvent x, AccelerationEvent y) => Math.Abs(x.Value - y.Value) <= 0.51,
        _ => a.Equals(b),
    };

    private static bool Near(double? a, double? b) => a is null == b is null && Math.Abs((a ?? 0) - (b ?? 0)) <= 1e-5;

    private static bool[] HomingMoves(Toolpath toolpath, Move[] moves)
    {
        var homing = new bool[moves.Length];
        foreach (var what in toolpath.Events)
        {
            if (what.Event is not HomeEvent home || what.Move >= moves.Length) continue;
            var m = moves[what.Move];
            homing[what.Move] |= m.Kind == MoveKind.Travel && m.E == 0
                && m.End == new Vec3(home.X ? 0 : m.Start.X, home.Y ? 0 : m.Start.Y, home.Z ? 0 : m.Start.Z);
        }
        return homing;
    }

    private string Said(string what)
        => what + ": move " + _i + " of " + _a.Length + " " + (_i < _a.Length ? _a[_i].ToString() : "(none)") + " against " + _j + " of " + _b.Length + " "
            + (_j < _b.Length ? _b[_j].ToString() : "(none)");

    /// <summary>How far the sums of each tool are apart: what was expected minus what was found.</summary>
    private sealed class Sums(int tools)
    {
        private readonly double[] _e = new double[Math.Max(tools, 1)];
        private readonly double[] _deposited = new double[Math.Max(tools, 1)];
        private readonly double[] _largest = new double[Math.Max(tools, 1)];

        public double E(int tool) => _e[tool];

        public double Deposited(int tool) => _deposited[tool];

        public double Largest(int tool) => _largest[tool];

        public void Expect(int tool, double e, double deposited)
        {
            _e[tool] += e;
            _deposited[tool] += deposited;
            _largest[tool] += Math.Abs(e);
        }

        public void Find(int tool, double e, double deposited)
        {
            _e[tool] -= e;
            _deposited[tool] -= deposited;
        }
    }
}
