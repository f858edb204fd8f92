namespace Caterpillar.GCode;

/// <summary>G and M commands that only change a mode.</summary>
internal sealed class ModeCommands(Machine machine, PositionCommands positions)
{
    private readonly FlavorRules _rules = machine.Rules;
    private readonly Features _features = machine.Features;

    /// <summary>Reads a G command, given ten times its number. False if it is not a mode command.</summary>
    public bool Take(int code)
    {
        ref var modes = ref machine.State.Modes;
        switch (code)
        {
            case 170 or 180 or 190:
                if (_rules.Planes || code == 170) modes.Plane = (ArcPlane)((code - 170) / 10);
                else machine.Log.Ignore();
                return true;
            case 200:
                _features.Add(Feature.G20);
                if (_rules.Inches) modes.Inches = true;
                else machine.Diagnostics.Warn("gcode.inches", _rules.Title + " does not support inches. G20 is ignored.");
                machine.ModesChanged();
                return true;
            case 210:
                _features.Add(Feature.G21);
                modes.Inches = false;
                machine.ModesChanged();
                return true;
            case 900 or 910:
                _features.Add(code == 900 ? Feature.G90 : Feature.G91);
                modes.Relative = modes.LastRelative = code == 910;
                machine.ModesChanged();
                return true;
            case 901 or 911:
                if (_rules.AbsoluteCenters) modes.AbsoluteCenters = code == 901;
                else if (code == 901) machine.Log.Ignore();
                return true;
            default:
                return _rules.Workspaces && positions.SelectSystem(code);
        }
    }

    /// <summary>M82 and M83.</summary>
    public void SetRelativeE(bool relative)
    {
        _features.Add(relative ? Feature.M83 : Feature.M82);
        if (_rules.RelativeE == RelativeERule.OnlyG90G91)
        {
            machine.Log.Ignore();
            return;
        }
        machine.State.Modes.M83 = machine.State.Modes.LastRelative = relative;
        machine.ModesChanged();
    }

    /// <summary>M200.</summary>
    public void SetVolumetric(ParsedLine line)
    {
        _features.Add(Feature.M200);
        ref var modes = ref machine.State.Modes;
        if (line.TryGet('D', out var diameter)) modes.Volumetric = diameter > 0;
        if (line.TryGet('S', out var on)) modes.Volumetric = on > 0 && modes.Volumetric | diameter == 0;
    }

    /// <summary>M120.</summary>
    public void Push() => machine.State.Saved.Push(Current(""));

    /// <summary>M121.</summary>
    public void Pop()
    {
        if (machine.State.Saved.Pop() is not { } saved) return;
        ref var modes = ref machine.State.Modes;
        modes.Inches = saved.Modes.Inches;
        modes.Volumetric = saved.Modes.Volumetric;
        modes.Plane = saved.Modes.Plane;
        Restore(saved, machine.State.Feed.Factor);
    }

    /// <summary>G60: the position under a number. With Q it returns to it as G61 does, and D deletes positions.</summary>
    public void StorePosition(ParsedLine line)
    {
        if (_rules.SavedPositions && line.Find('Q') >= 0) ReturnTo(line, 'Q');
        else if (!_rules.SavedPositions || !line.Has('D')) machine.State.Saved.SetNamed(Current(PointName(line.Get('S', 0))));
    }

    /// <summary>The stored position with a number, as written now; null if there is none.</summary>
    public Vec3? StoredPosition(double number)
        => machine.State.Saved.Named(PointName(number)) is { } saved ? saved.Head.Machine - machine.State.Head.Shift : null;

    /// <summary>G61: moves back to a stored position, in the axes named and by what is added to them; without any axis first up, or last down.</summary>
    public void ReturnTo(ParsedLine line, char slot)
    {
        var number = line.Get(slot, 0);
        if (StoredPosition(number) is not { } stored) return;
        var (state, moves) = (machine.State, machine.Moves);
        var (all, now, unit, speed) = (!line.HasAny("XYZE"), state.Head.Written, state.Modes.Unit, state.Feed.Speed);
        var target = new Vec3(Coordinate('X', stored.X, now.X), Coordinate('Y', stored.Y, now.Y), Coordinate('Z', stored.Z, now.Z));
        if (line.TryGet('F', out var feed) && feed is > 0 and < 1e9) state.Feed.Speed = feed * unit / 60;
        if (all) moves.Travel(target.Z > now.Z ? now.WithZ(target.Z) : target.WithZ(now.Z));
        moves.Travel(target);
        moves.BreakExtrusion();
        state.Feed.Speed = speed;
        if (line.Has('E')) state.Extrusion.SetE(state.Saved.Named(PointName(number))!.Extrusion.E);

        double Coordinate(char letter, double there, double here)
            => all ? there : line.Has(letter) && there + line.Get(letter, 0) * unit is > -MoveRecorder.LargestLength and < MoveRecorder.LargestLength and var at
                ? at : here;
    }

    /// <summary>The current state under a name.</summary>
    public SavedState Current(string name)
    {
        var state = machine.State;
        return new SavedState(
            name, state.Modes with { Motion = 0 }, state.Feed, state.Extrusion, state.Head, state.Saved.Offset, state.Saved.OffsetE);
    }

    // No state of a firmware with names has this one.
    private static string PointName(double number) => "G60 " + NumberFormatter.Format(number, 0);

    /// <summary>Restores the state that all firmwares restore: relative or absolute positions and E, and the feed rate.</summary>
    public void Restore(SavedState saved, double feedFactor)
    {
        ref var modes = ref machine.State.Modes;
        modes.Relative = saved.Modes.Relative;
        modes.LastRelative = saved.Modes.LastRelative;
        modes.M83 = saved.Modes.M83;
        machine.State.Feed.Set(saved.Feed.Rate, feedFactor);
        machine.ModesChanged();
    }
}
