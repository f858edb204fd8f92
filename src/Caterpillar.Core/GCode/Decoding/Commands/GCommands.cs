namespace Caterpillar.GCode;

/// <summary>Executes the G commands and axis words of a line that the firmware accepts.</summary>
internal sealed class GCommands(Machine machine, EventCommands events, ModeCommands modes, PositionCommands positions, MotionCommands motion)
{
    private const int NoMotion = -1;
    private readonly FlavorRules _rules = machine.Rules;

    public void Take(byte[] text, ParsedLine line)
    {
        if (_rules.Letters.Length > 0 && HasUnknownLetter(line)) return;
        Execute(text, line);
        machine.State.Work.IsMachineLine = false;
    }

    private void Execute(byte[] text, ParsedLine line)
    {
        var action = 0;
        var explicitMotion = NoMotion;
        var commands = 0;
        for (var i = 0; i < line.Count; i++)
        {
            if (!line.HasValue[i]) continue;
            // Some firmware executes these too.
            if (line.Letters[i] == 'M' && _rules.Commands is CommandsRule.All or CommandsRule.InOrder) machine.Log.See(text, line.LetterAt[i], line.CodeEnd);
            if (line.Letters[i] != 'G') continue;
            commands++;
            if (_rules.Commands is CommandsRule.First or CommandsRule.Last && !Counts(line, i, commands)) continue;
            var code = Tenfold(line.Values[i]);
            if (_rules.Commands == CommandsRule.InOrder && explicitMotion != NoMotion)
            {
                if (!IsMotion(code)) continue;
                machine.Diagnostics.Warn("gcode.flavor_commands", "A line has several motion commands. Only the last one is read, with the words of all.");
            }
            if (IsMotion(code))
            {
                explicitMotion = code / 10;
                continue;
            }
            // A mode takes effect now, and an action after all modes.
            machine.Log.See(text, line.LetterAt[i], line.CodeEnd);
            if (!modes.Take(code)) action = code;
        }
        if (commands > 1) machine.Features.Add(Feature.MultiG);
        if (explicitMotion != NoMotion)
        {
            machine.State.Modes.Motion = explicitMotion;
            motion.Move(line);
            if (commands > 1 && _rules.Commands == CommandsRule.InOrder) ModesAfterMotion(line);
        }
        else if (action != 0)
        {
            Act(action, line);
        }
        else if (motion.HasAxisWord(line) && (commands == 0 || _rules.ModalMotion == ModalMotionRule.Standard || machine.State.Work.IsMachineLine))
        {
            RepeatMotion(line);
        }
        else if (commands == 0)
        {
            if (_rules.ModalMotion != ModalMotionRule.Never && line.TryGet('F', out var feed)) machine.SetFeed(feed);
            else if (line.Find('F') < 0) Unknown(text, line);
        }
    }

    private void Unknown(byte[] text, ParsedLine line)
    {
        machine.Log.See(text, line.LetterAt[0], line.CodeEnd);
        machine.Log.Ignore();
    }

    private static bool IsMotion(int code) => code is 0 or 10 or 20 or 30;

    private static int Tenfold(double code) => code is >= 0 and < 1000 ? (int)Math.Floor(code * 10 + 0.5) : -1;

    private void RepeatMotion(ParsedLine line)
    {
        machine.Features.Add(Feature.ModalLines);
        if (_rules.ModalMotion == ModalMotionRule.Never)
            machine.Diagnostics.Warn("gcode.flavor_modal", "A line has coordinates but no G command. " + _rules.Title
                + " ignores it, other firmware repeats the last motion.");
        else
            motion.Move(line);
    }

    // Modes after the motion in the same line.
    private void ModesAfterMotion(ParsedLine line)
    {
        var moved = false;
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Letters[i] != 'G' || !line.HasValue[i]) continue;
            var code = Tenfold(line.Values[i]);
            if (IsMotion(code)) moved = true;
            else if (moved) modes.Take(code);
        }
    }

    private bool HasUnknownLetter(ParsedLine line)
    {
        for (var i = 0; i < line.Count; i++)
        {
            if (_rules.Letters.IndexOf(((char)line.Letters[i]).ToString(), StringComparison.Ordinal) >= 0) continue;
            machine.Diagnostics.Warn("gcode.word_refused", _rules.Title + " rejects lines with the letter " + (char)line.Letters[i] + ".");
            return true;
        }
        return false;
    }

    // Firmware that takes one command of a line.
    private bool Counts(ParsedLine line, int word, int number)
    {
        var last = true;
        for (var i = word + 1; i < line.Count && last; i++) last = line.Letters[i] != 'G' || !line.HasValue[i];
        if (number == 1 && last) return true;
        if (last)
            machine.Diagnostics.Warn("gcode.flavor_commands", "A line has several G commands. " + _rules.Title + " executes only the "
                + (_rules.Commands == CommandsRule.First ? "first." : "last."));
        return _rules.Commands == CommandsRule.First ? number == 1 : last;
    }

    private void Act(int code, ParsedLine line)
    {
        if (IsHoming(code))
        {
            if (_rules.Homing == HomingRule.HomesToZero) positions.Home(line);
            else positions.GoToStored(line, code == 280 ? machine.State.Stored28 : machine.State.Stored30);
            return;
        }
        switch (code)
        {
            case 40:
                events.Dwell(line);
                return;
            case 100:
            case 110:
                if (line.HasAny(_rules.NoRetractionWith) || !_rules.FirmwareRetraction) Offsets(line, code);
                else FirmwareRetraction(code == 100);
                return;
            case 920:
                positions.Rename(line);
                motion.RenameTurns(line);
                if (line.Count == 1) positions.BareRename();
                return;
            case 50 when _rules.Splines:
                motion.Spline(line);
                return;
            case 600 when _rules.SavedPositions || _rules.RestorePoints:
                modes.StorePosition(line);
                return;
            case 610 when _rules.SavedPositions:
                modes.ReturnTo(line, 'S');
                return;
            case 281 when _rules.Homing == HomingRule.GoesToStoredPosition:
                machine.State.Stored28 = machine.State.Head.Machine;
                return;
            case 301 when _rules.Homing == HomingRule.GoesToStoredPosition:
                machine.State.Stored30 = machine.State.Head.Machine;
                return;
            default:
                if (FlavorRules.Names(_rules.ShiftResets, 'G', code / 10.0)) positions.ClearShifts();
                else machine.Log.Ignore();
                return;
        }
    }

    private bool IsHoming(int code) => (code == 280 && _rules.HomingCommands.Count == 1)
        || (code is 280 or 300 or 1610 or 1620 && FlavorRules.Names(_rules.HomingCommands, 'G', code / 10.0));

    private void FirmwareRetraction(bool retract)
    {
        machine.Features.Add(Feature.FirmwareRetraction);
        if (retract) machine.Counters.FirmwareRetractions++;
        else machine.Counters.FirmwareDeretractions++;
        ref var state = ref machine.State.Retraction;
        if (!retract) machine.Moves.Raise(-state.Lifted);
        machine.Moves.Stay(retract ? Toolpaths.MoveKind.Retract : Toolpaths.MoveKind.Deretract);
        var lifted = !retract ? 0 : state.IsRetracted ? state.Lifted : state.Lift;
        if (retract) machine.Moves.Raise(lifted - state.Lifted);
        state = new RetractionState(state.Lift, retract, lifted);
    }

    // G10 and G11 that do not retract.
    private void Offsets(ParsedLine line, int code)
    {
        if (code == 100 && _rules.Workspaces && line.TryGet('L', out var l) && l is 2 or 20)
        {
            positions.SetSystem(line, l == 20);
            return;
        }
        if (code == 100 && events.TakeToolTemperature(line) && !line.HasAny("XYZ")) return;
        machine.Log.Ignore();
    }
}
