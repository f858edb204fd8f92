namespace Caterpillar.GCode;

/// <summary>Commands that rename positions or go to stored ones: G92, G28, G30, G54 to G59.3, G10 L2 and L20, M206, M290.</summary>
internal sealed class PositionCommands(Machine machine, ExtruderWords extruder)
{
    private const double Largest = MoveRecorder.LargestLength;
    private readonly FlavorRules _rules = machine.Rules;
    private readonly InterpreterState _state = machine.State;
    private readonly MoveRecorder _moves = machine.Moves;

    // Machine coordinates minus coordinates as written, without the offsets of G92.
    private Vec3 Base
        => (_rules.WorkspacesByG92 ? Vec3.Zero : _state.Work.Origin) + _state.Saved.Offset + new Vec3(0, 0, _state.Saved.Babysteps + _state.Retraction.Lifted);

    /// <summary>G28 and similar commands that home.</summary>
    public void Home(ParsedLine line)
    {
        Axes(line, out var x, out var y, out var z);
        ref var head = ref _state.Head;
        var moves = (x && head.X + head.ShiftX != 0) || (y && head.Y + head.ShiftY != 0) || (z && head.Z + head.ShiftZ != 0);
        _moves.AddEvent(new HomeEvent(x, y, z));
        if (_rules.HomingSelectsXy) _state.Modes.Plane = ArcPlane.XY;
        if (z) ForgetHeights();
        var origin = _rules.HomingKeepsShifts ? head.Shift : Base;
        if (x) HomeAxis(line, 'X', origin.X, ref head.X, ref head.ShiftX, ref head.KnownX);
        if (y) HomeAxis(line, 'Y', origin.Y, ref head.Y, ref head.ShiftY, ref head.KnownY);
        if (z) HomeAxis(line, 'Z', origin.Z, ref head.Z, ref head.ShiftZ, ref head.KnownZ);
        if (head.Lost != 0) machine.Restate((x ? ChunkParser.HasX : 0) | (y ? ChunkParser.HasY : 0) | (z ? ChunkParser.HasZ : 0));
        _moves.BreakExtrusion();
        // Homing is a move of the toolpath, though the file has no line of motion for it.
        if (moves && head.HasMoved) _moves.Stay(MoveKind.Travel);
    }

    /// <summary>G28 and G30 that go to a stored position via the given point, in the given axes.</summary>
    public void GoToStored(ParsedLine line, Vec3 stored)
    {
        var point = machine.Target(line);
        if (MoveRecorder.IsTooFar(point.X, point.Y, point.Z))
        {
            _moves.OutOfRange();
            return;
        }
        Axes(line, out var x, out var y, out var z);
        _moves.BreakExtrusion();
        ref var head = ref _state.Head;
        var end = new Vec3(x ? stored.X - head.ShiftX : point.X, y ? stored.Y - head.ShiftY : point.Y, z ? stored.Z - head.ShiftZ : point.Z);
        // The move to the point named is a travel like others, the one from there the homing.
        if (point != end) _moves.Travel(point);
        _moves.AddEvent(new HomeEvent(x, y, z));
        _moves.Travel(end);
        head.KnownX |= x;
        head.KnownY |= y;
        head.KnownZ |= z;
    }

    /// <summary>G92: renames the position. The head does not move.</summary>
    public void Rename(ParsedLine line)
    {
        ref var head = ref _state.Head;
        var any = false;
        if (line.TryGet('X', out var x)) any |= RenameAxis(x, ref head.X, ref head.ShiftX, ref head.KnownX);
        if (line.TryGet('Y', out var y)) any |= RenameAxis(y, ref head.Y, ref head.ShiftY, ref head.KnownY);
        if (line.TryGet('Z', out var z)) any |= RenameAxis(z, ref head.Z, ref head.ShiftZ, ref head.KnownZ);
        if (any) machine.Features.Add(Feature.G92Xyz);
        if (any && _rules.WorkspacesByG92 && _state.Work.Selected > 0) _state.Work.SetOrigin(_state.Work.Selected, head.Shift - Base);
        if (extruder.Rename(line)) machine.Features.Add(Feature.G92E);
    }

    /// <summary>G92 without any word.</summary>
    public void BareRename()
    {
        machine.Features.Add(Feature.G92All);
        machine.Diagnostics.Warn("gcode.flavor_g92", "G92 without axis letters differs between firmwares. It was read by the rules of " + _rules.Title
            + ".");
        if (_rules.BareG92 == BareG92Rule.Nothing) return;
        if (_rules.BareG92 == BareG92Rule.ClearShifts)
        {
            ClearShifts();
        }
        else
        {
            ref var head = ref _state.Head;
            RenameAxis(0, ref head.X, ref head.ShiftX, ref head.KnownX);
            RenameAxis(0, ref head.Y, ref head.ShiftY, ref head.KnownY);
            RenameAxis(0, ref head.Z, ref head.ShiftZ, ref head.KnownZ);
        }
        _state.Extrusion.SetE(0);
        _state.Extrusion.A = _state.Extrusion.B = 0;
    }

    /// <summary>Resets the shifts of G92. The origin of the selected coordinate system does not change.</summary>
    public void ClearShifts()
    {
        _state.Head.SetShift(Base);
        _moves.BreakExtrusion();
    }

    /// <summary>Selects a coordinate system by a G command, given ten times its number. False if it selects none.</summary>
    public bool SelectSystem(int code)
    {
        ref var work = ref _state.Work;
        if (code == 530 && !_rules.WorkspacesByG92)
        {
            work.IsMachineLine = true;
            return true;
        }
        if (code is < 540 or > 593 || (code < 590 && code % 10 != 0)) return false;
        var system = code < 590 ? (code - 530) / 10 : 6 + code - 590;
        if (system == work.Selected) return true;
        var before = work.Origin;
        work.Selected = system;
        if (system > 1 && !work.HasOrigin)
            machine.Diagnostics.Warn("gcode.workspace", $"G{NumberFormatter.Format(code / 10.0, 1)} selects a coordinate system whose origin the file does not "
                + "set: positions are unknown. They are read as if its origin were that of the machine.");
        if (_rules.WorkspacesByG92) _state.Head.SetShift(work.Origin + Base);
        else OriginMoved(before);
        _moves.BreakExtrusion();
        return true;
    }

    /// <summary>G10 L2 (the words are the origin) and L20 (the words are the position of the head in the system).</summary>
    public void SetSystem(ParsedLine line, bool here)
    {
        var number = line.Get('P', 0);
        if (!(number is >= 0 and <= WorkOffsets.Count))
        {
            machine.Log.Ignore();
            return;
        }
        ref var work = ref _state.Work;
        var system = number < 1 ? work.Selected : (int)number;
        var before = work.Origin;
        var position = _state.Head.Written + before;
        work.SetOrigin(system, here ? Words(line, work.OriginOf(system), position, -1) : Words(line, work.OriginOf(system), Vec3.Zero, 1));
        OriginMoved(before);
    }

    /// <summary>M206: the home offset.</summary>
    public void SetHomeOffset(ParsedLine line)
    {
        ref var work = ref _state.Work;
        if (_rules.HomeOffset == HomeOffsetRule.OfWorkspace)
        {
            var origin = work.Origin;
            work.SetOrigin(work.Selected, Words(line, origin, Vec3.Zero, -1));
            OriginMoved(origin);
            return;
        }
        ref var saved = ref _state.Saved;
        var before = saved.Offset;
        saved.Offset = Words(line, before, Vec3.Zero, -1);
        if (_rules.HomeOffset == HomeOffsetRule.AtOnce) _state.Head.SetShift(_state.Head.Shift + saved.Offset - before);
    }

    /// <summary>M290: moves in Z without a change of the coordinates.</summary>
    public void Babystep(ParsedLine line)
    {
        if (line.HasAny("XY")) machine.Log.NotFollowed("M290 in X or Y");
        if (!line.TryGet('Z', out var z) && !line.TryGet('S', out z)) return;
        z *= _state.Modes.Unit;
        ref var saved = ref _state.Saved;
        var step = _rules.HomingKeepsBabysteps && line.TryGet('R', out var relative) && relative == 0 ? z - saved.Babysteps
            : Math.Max(Math.Min(z, _rules.LargestBabystep), -_rules.LargestBabystep);
        if (!(step is > -Largest and < Largest)) return;
        saved.Babysteps += step;
        _moves.Raise(step);
    }

    // The words X, Y and Z by a factor, added to positions; for those that the line does not have, others.
    private Vec3 Words(ParsedLine line, Vec3 unchanged, Vec3 added, double factor)
    {
        var unit = factor * _state.Modes.Unit;
        return new Vec3(Word('X', unchanged.X, added.X), Word('Y', unchanged.Y, added.Y), Word('Z', unchanged.Z, added.Z));

        double Word(char letter, double otherwise, double add)
            => line.TryGet(letter, out var word) && word * unit is > -Largest and < Largest and var known ? known + add : otherwise;
    }

    private void OriginMoved(Vec3 before)
    {
        _state.Head.SetShift(_state.Head.Shift + _state.Work.Origin - before);
        _moves.BreakExtrusion();
    }

    // Homing of Z ends the lift of the firmware retraction, and most firmware forgets babysteps.
    private void ForgetHeights()
    {
        ref var head = ref _state.Head;
        var babysteps = _rules.HomingKeepsBabysteps ? 0 : _state.Saved.Babysteps;
        head.SetShift(head.Shift - new Vec3(0, 0, babysteps + _state.Retraction.Lifted));
        _state.Saved.Babysteps -= babysteps;
        _state.Retraction = _state.Retraction with { Lifted = 0 };
    }

    private static void Axes(ParsedLine line, out bool x, out bool y, out bool z)
    {
        x = line.Has('X');
        y = line.Has('Y');
        z = line.Has('Z');
        if (!x && !y && !z) x = y = z = true;
    }

    private void HomeAxis(ParsedLine line, char letter, double origin, ref double position, ref double shift, ref bool known)
    {
        if (_rules.HomesToNumber && line.TryGet(letter, out var number) && Math.Abs(number) is >= 1 and < Largest) origin -= number;
        shift = origin;
        position = -origin;
        known = true;
    }

    private bool RenameAxis(double word, ref double position, ref double shift, ref bool known)
    {
        word *= _state.Modes.Unit;
        if (!(word is > -Largest and < Largest))
        {
            _moves.OutOfRange();
            return false;
        }
        // Before the axis has moved or homed, its name is all there is to know.
        if (known) shift += position - word;
        position = word;
        known = true;
        _moves.BreakExtrusion();
        return true;
    }
}
