namespace Caterpillar.Planning;

/// <summary>Travels between paths: retraction with balance, wipe, lift and descent.</summary>
internal sealed class TravelPlanner(PlanRules rules, MoveEmitter emitter, PlanReport counts, Deposit? deposit)
{
    private const double Flush = 1e-6;

    // Points closer than this are equal, mm: far below the resolution of any file or machine.
    internal const double Touching = 1e-6;

    // Rise that is level for a nozzle without an extrusion, mm: below what the checks let it touch.
    internal const double Flat = 0.03;

    // mm; the nozzle leaves a purge tower clean.
    private const double TowerWipe = 5;
    private readonly bool[] _hasPrinted = new bool[rules.Tools.Length];
    private readonly DetourFinder? _detours = deposit is not null && rules.Settings.Detour ? new DetourFinder(deposit, rules.Head) : null;
    private readonly CombPath _around = new(rules.Settings.LineWidth);
    private readonly PrintSettings _settings = rules.Settings;
    private readonly Printer _printer = rules.Printer;
    private PrintPath? _last;

    /// <summary>The first travel goes up, above an object on the bed, before it goes anywhere else.</summary>
    public bool RisesFirst { get; init; }

    private Region? _inside;

    // The layer of the last path is not level, or not known to be.
    private bool _isBent;

    private double Clearance => emitter.ToolRules.Material?.ZHop ?? rules.Clearance;

    /// <summary>A path has been printed to its end.</summary>
    public void Printed(PrintPath path, Region? inside)
    {
        _last = path;
        _inside = inside;
        _isBent = inside is null && path.Layer is not null;
        Primed();
    }

    /// <summary>The tool has extruded material: it can ooze.</summary>
    public void Primed() => _hasPrinted[emitter.Tool] = true;

    /// <summary>Retracts before a travel of a length, if the rules require it and it has not been done.</summary>
    public void RetractFor(double length)
    {
        var tool = emitter.ToolRules;
        if (rules.AddsNothing || tool.RetractE <= 0 || !_hasPrinted[emitter.Tool]) return;
        var missing = tool.RetractE - emitter.Retracted;
        if (missing <= 0)
        {
            counts.AlreadyRetracted++;
        }
        else if (length < _settings.RetractionMinTravel)
        {
            counts.SkippedRetractions++;
        }
        else
        {
            counts.Retractions++;
            if (!TryWipe(missing, tool)) emitter.Retract(missing, tool.RetractSpeed);
        }
    }

    /// <summary>Moves the head to the start of a path. Adds nothing if it is already there.</summary>
    /// <param name="start">Start of the path, mm.</param>
    /// <param name="direct">The head comes from the end of the last path, without a drawn travel in between, which would already have retracted.</param>
    /// <param name="inside">The region that the layer covers.</param>
    public void To(Vec3 start, bool direct, Region? inside)
    {
        if (rules.AddsNothing)
        {
            if (emitter.IsPlaced && emitter.Position.DistanceTo(start) <= Touching) return;
            counts.Travels++;
            emitter.Travel(start, _settings.TravelSpeed);
            return;
        }
        if (!emitter.IsPlaced)
        {
            var top = RisesFirst ? Math.Max(start.Z, emitter.Highest) + Clearance : _settings.ZHopType == ZHopType.None ? start.Z : start.Z + Clearance;
            // Where the start code leaves the head is not known: a line of its own moves Z alone.
            if (RisesFirst) emitter.Event(new RawEvent($"G0 Z{NumberFormatter.Format(top, 3)} F{NumberFormatter.Format(_printer.ZHopSpeed * 60, 0)}"));
            emitter.Travel(start.WithZ(top), _settings.TravelSpeed);
            Down(start);
            return;
        }
        if (emitter.Position.DistanceTo(start) <= Touching) return;
        counts.Travels++;
        if (direct && TryComb(start, inside)) return;
        if (direct) RetractFor(emitter.Position.DistanceTo(start));
        Over(start);
    }

    private bool TryComb(Vec3 start, Region? inside)
    {
        var from = emitter.Position;
        if (!_settings.Comb || inside is null || _inside is null) return false;
        // Also up to the next layer, where that covers all of it.
        var rise = start.Z - from.Z;
        if (inside == _inside ? Math.Abs(rise) > Touching : !(rise > Touching && rise < 2 * _settings.LayerHeight)) return false;
        if (inside.ContainsLine(from, start))
        {
            if (!IsFree(from, start)) return false;
            counts.Combed++;
            Rise(start);
            return true;
        }
        var longest = from.DistanceTo(start) + _settings.AvoidCrossingMaxDetour;
        if (_settings.AvoidCrossingMaxDetour <= 0 || _around.Find(from, start, inside, longest) is not { } path) return false;
        for (var i = 0; i < path.Count; i++)
        {
            if (!IsFree(i == 0 ? from : path[i - 1], path[i])) return false;
        }
        counts.Combed++;
        counts.CombedAround++;
        foreach (var point in path) Rise(point);
        return true;
    }

    // Along the layer or up to the next one: not faster than the Z axis may go.
    private void Rise(Vec3 to)
    {
        var rise = Math.Abs(to.Z - emitter.Position.Z);
        emitter.Travel(to, rise > 0 ? Math.Min(_settings.TravelSpeed, _printer.ZHopSpeed * emitter.Position.DistanceTo(to) / rise) : _settings.TravelSpeed);
    }

    private bool IsFree(Vec3 from, Vec3 to)
        => deposit is null || rules.Head.RequiredHeight(deposit, from, to, Math.Min(from.Z, to.Z)) <= Math.Min(from.Z, to.Z) + Flush;

    /// <summary>Deretracts before a path.</summary>
    public void Restore()
    {
        if (rules.AddsNothing || emitter.Retracted <= 0) return;
        emitter.Restore(null, emitter.ToolRules.DeretractionSpeed);
        Extra();
    }

    /// <summary>Up, over and down, or around.</summary>
    /// <param name="to">The target, mm.</param>
    /// <param name="safely">Avoids printed parts even if the settings ask for no lift.</param>
    public void Over(Vec3 to, bool safely = false)
    {
        var from = emitter.Position;
        if ((to - from).LengthXY <= Touching)
        {
            Down(to);
            return;
        }
        if (_settings.ZHopType == ZHopType.None && !safely)
        {
            counts.SkippedZHops++;
            emitter.Travel(to, _settings.TravelSpeed);
            return;
        }
        var level = Math.Max(from.Z, to.Z);
        var z = HeightOver(from, to, level, safely);
        if (z > level && TryDetour(from.WithZ(level), to.WithZ(level), z - level))
        {
            Down(to);
            return;
        }
        if (z <= level) counts.SkippedZHops++;
        else if (_settings.ZHopType == ZHopType.AbovePrint) counts.ZHops++;
        else counts.LocalZHops++;
        if (z > from.Z) emitter.Travel(from.WithZ(z), _printer.ZHopSpeed);
        emitter.Travel(to.WithZ(z), _settings.TravelSpeed);
        Down(to);
    }

    /// <summary>Time to go up, over and down, s, ignoring accelerations and detours.</summary>
    public double TimeOver(Vec3 to)
    {
        var from = emitter.Position;
        var z = HeightOver(from, to, Math.Max(from.Z, to.Z), true);
        return (z - from.Z + z - to.Z) / _printer.ZHopSpeed + (to - from).LengthXY / _settings.TravelSpeed;
    }

    private double HeightOver(Vec3 from, Vec3 to, double level, bool safely)
    {
        if (_settings.ZHopType == ZHopType.AbovePrint)
        {
            if (safely || from.DistanceTo(to) > _settings.ZHopMinTravel) return Math.Max(level, emitter.Highest) + Clearance;
            // Short travels along a slope pass over what is higher next to them.
            return _isBent && Math.Abs(to.Z - from.Z) > Flat ? level + Math.Min(Clearance, (to - from).LengthXY) : level;
        }
        if (deposit is null) return level;
        var needed = rules.Head.RequiredHeight(deposit, from, to, level);
        return needed > level + Flush ? needed + Clearance : level;
    }

    // A detour is taken if it is faster than going up and down.
    private bool TryDetour(Vec3 from, Vec3 to, double rise)
    {
        if (_detours is null) return false;
        var longest = from.DistanceTo(to) + 2 * rise / _printer.ZHopSpeed * _settings.TravelSpeed;
        if (_detours.Find(from, to, longest) is not { } detour) return false;
        counts.Detours++;
        emitter.Travel(from, _printer.ZHopSpeed);
        foreach (var point in detour) emitter.Travel(point, _settings.TravelSpeed);
        return true;
    }

    private void Down(Vec3 to)
    {
        var length = emitter.IsPlaced ? emitter.Position.DistanceTo(to) : 0;
        if (rules.AddsNothing || !_settings.DeretractDuringDescent || !rules.CanWipe || emitter.Retracted <= 0 || !(to.Z < emitter.Position.Z))
        {
            emitter.Travel(to, _printer.ZHopSpeed);
            return;
        }
        // Slow enough for the filament to keep up.
        var tool = emitter.ToolRules;
        emitter.Restore(to, Math.Min(_printer.ZHopSpeed, length * tool.DeretractionSpeed / tool.FilamentLength(emitter.Retracted)));
        Extra();
    }

    private void Extra()
    {
        var tool = emitter.ToolRules;
        if (tool.ExtraE > 0) emitter.Prime(tool.ExtraE, tool.DeretractionSpeed);
    }

    // Back along an open path, onward along a closed one, while the filament is retracted.
    private bool TryWipe(double e, ToolRules tool)
    {
        if (_last is not { } path || path.End.DistanceTo(emitter.Position) > Touching) return false;
        var distance = path.Role == Role.PrimeTower ? TowerWipe : emitter.ToolRules.Material?.WipeDistance ?? rules.WipeDistance;
        if (distance <= 0 || !rules.CanWipe) return false;
        var points = WipePath.Along(path, distance);
        var length = 0.0;
        for (var i = 1; i < points.Count; i++) length += points[i - 1].DistanceTo(points[i]);
        if (!(length > 0) || points.Exists(p => Math.Abs(p.Z - points[0].Z) > Flat)) return false;
        var speed = Math.Min(_settings.TravelSpeed, length * tool.RetractSpeed / tool.FilamentLength(e));
        var left = e;
        for (var i = 1; i < points.Count; i++)
        {
            var part = i + 1 == points.Count ? left : Math.Min(left, e * points[i - 1].DistanceTo(points[i]) / length);
            emitter.Wipe(points[i], part, speed);
            left -= part;
        }
        counts.Wipes++;
        return true;
    }
}
