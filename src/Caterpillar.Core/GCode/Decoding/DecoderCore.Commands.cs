using System;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Lines that the fast path leaves: modal words, G92, G28, and motions in unusual notation.</summary>
internal sealed partial class DecoderCore
{
    private int _motion;
    private bool _relative;
    private bool _inches;
    private bool _m83;
    private bool _lastRelative;
    private bool _relativeE;

    // True when the fast path holds: absolute, mm, and no doubt about the mode of E.
    private bool _plain = true;
    private bool _modesDiffer;

    // E as Marlin 2 would count it, from where the rules part.
    private bool _shadow;
    private double _shadowE;
    private double _feedFactor = 1;
    private double _feed;

    private double Unit => _inches ? Inch : 1;

    private void Execute(byte[] text, int start, int end)
    {
        if (_line == 1 && start == 0 && end >= 3 && text[0] == 0xEF && text[1] == 0xBB && text[2] == 0xBF) start = 3;
        _parsed.Scan(text, start, end);
        Execute(_parsed, text, end);
    }

    private void Execute(ParsedLine line, byte[] text, int end)
    {
        Features.Count(line);
        if (line.Shape == LineShape.Macro)
        {
            Macro(text, line);
            return;
        }
        if (line.CommentStart >= 0)
        {
            if (line.Shape == LineShape.Blank) Meaning(text, line.CommentStart, end);
            else if (!_typed) TrailingComment(text, line.CommentStart);
        }
        if (line.Shape == LineShape.Blank) return;
        switch ((char)line.Letters[0])
        {
            case 'M':
                Machine(text, line);
                return;
            case 'T':
                if (!_rules.ToolByM6) ChangeTool(line.Values[0]);
                else _nextTool = line.Values[0];
                return;
            case 'O':
                return;
            default:
                Motion(line);
                return;
        }
    }

    private void Motion(ParsedLine line)
    {
        var action = 0;
        var explicitMotion = -1;
        var words = 0;
        _machineCoordinates = false;
        if (_rules.Letters.Length > 0 && HasUnknownLetter(line)) return;
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Letters[i] != 'G' || !line.HasValue[i]) continue;
            words++;
            if (_rules.Commands is CommandsRule.First or CommandsRule.Last && !Counts(line, i, words)) continue;
            var code = Tenfold(line.Values[i]);
            if (_rules.Commands == CommandsRule.InOrder && explicitMotion >= 0)
            {
                if (code is 0 or 10 or 20 or 30) Differs("gcode.dialect_commands",
                    "A line has several motions: the last alone is read, with the words of all.");
                else continue;
            }
            if (code is 0 or 10 or 20 or 30) explicitMotion = code / 10;
            else if (!Modal(code)) action = code;
        }
        if (words > 1) Features.MultiG++;
        if (explicitMotion >= 0)
        {
            _motion = explicitMotion;
            MoveAndTurn(line);
            if (words > 1 && _rules.Commands == CommandsRule.InOrder) ModesBehind(line);
        }
        else if (action != 0)
        {
            Action(action, line);
        }
        else if (HasAxisWord(line) && (words == 0 || _rules.ModalMotion == ModalMotionRule.Standard || _machineCoordinates))
        {
            Features.ModalLines++;
            if (_rules.ModalMotion == ModalMotionRule.Never)
            {
                Differs("gcode.dialect_modal", "A line moves without a G word: " + _rules.Title + " ignores it, others repeat the last motion.");
                return;
            }
            MoveAndTurn(line);
        }
        else if (words == 0)
        {
            if (_rules.ModalMotion != ModalMotionRule.Never && line.TryGet('F', out var feed)) SetFeed(feed);
            else if (line.Find('F') < 0) Ignored((char)line.Letters[0], line.HasValue[0] ? line.Values[0] : 0);
        }
    }

    private static int Tenfold(double code) => code is >= 0 and < 1000 ? (int)Math.Floor(code * 10 + 0.5) : -1;

    // Modes that stand behind the motion of their line.
    private void ModesBehind(ParsedLine line)
    {
        var moved = false;
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Letters[i] != 'G' || !line.HasValue[i]) continue;
            var code = Tenfold(line.Values[i]);
            if (code is 0 or 10 or 20 or 30) moved = true;
            else if (moved) Modal(code);
        }
    }

    private bool HasUnknownLetter(ParsedLine line)
    {
        for (var i = 0; i < line.Count; i++)
        {
            if (_rules.Letters.IndexOf(((char)line.Letters[i]).ToString(), StringComparison.Ordinal) >= 0) continue;
            Refused("gcode.word_refused", _rules.Title + " refuses lines with the letter " + (char)line.Letters[i] + ".");
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
        if (last) Differs("gcode.dialect_commands", "A line has several G words: " + _rules.Title + " executes the "
            + (_rules.Commands == CommandsRule.First ? "first" : "last") + " alone.");
        return _rules.Commands == CommandsRule.First ? number == 1 : last;
    }

    // True when the code changes a mode only.
    private bool Modal(int code)
    {
        switch (code)
        {
            case 170:
            case 180:
            case 190:
                if (_rules.Planes || code == 170) _plane = (Geometry.ArcPlane)((code - 170) / 10);
                else Ignored('G', code / 10);
                return true;
            case 200:
                Features.G20++;
                if (_rules.Inches) _inches = true;
                else Refused("gcode.inches", _rules.Title + " knows no inches: G20 is refused.");
                Modes();
                return true;
            case 210:
                Features.G21++;
                _inches = false;
                Modes();
                return true;
            case 900:
            case 910:
                if (code == 900) Features.G90++;
                else Features.G91++;
                _relative = code == 910;
                _lastRelative = _relative;
                Modes();
                return true;
            case 901:
            case 911:
                if (_rules.AbsoluteCenters) _absoluteCenters = code == 901;
                else if (code == 901) Ignored('G', 90.1);
                return true;
            default:
                return _rules.Workspaces && Workspace(code);
        }
    }

    /// <summary>The last line that changed a mode.</summary>
    public int LastModeLine { get; private set; }

    // After each change of a mode: which rule of E holds, and whether the fast path does.
    private void Modes()
    {
        LastModeLine = _line;
        var either = _relative || _m83;
        _relativeE = _rules.RelativeE switch
        {
            RelativeERule.EitherG91OrM83 => either,
            RelativeERule.LastWins => _lastRelative,
            RelativeERule.OnlyM82M83 => _m83,
            _ => _relative,
        };
        _modesDiffer = either != _lastRelative || either != _m83;
        if (!_shadow && _relativeE != _lastRelative)
        {
            _shadow = true;
            _shadowE = _e;
            DecodeCounters.EMarlin2 = DecodeCounters.ENet;
        }
        _plain = !_relative && !_inches && !_shadow && !_modesDiffer;
    }

    private void Move(ParsedLine line)
    {
        if (line.TryGet('F', out var feed)) SetFeed(feed);
        if (_motion > 1)
        {
            ArcMove(line);
            return;
        }
        var mask = (line.TryGet('X', out var x) ? ChunkParser.HasX : 0) | (line.TryGet('Y', out var y) ? ChunkParser.HasY : 0)
            | (line.TryGet('Z', out var z) ? ChunkParser.HasZ : 0) | (ExtruderWord(line, out var e) ? ChunkParser.HasE : 0);
        if (_rules.RestorePoints && line.Find('R') >= 0) NotFollowed("R of a motion");
        General(mask, x, y, z, e, _motion);
        _machineCoordinates = false;
    }

    private void General(int mask, double x, double y, double z, double e, int code)
    {
        var de = (mask & ChunkParser.HasE) != 0 ? ChangeOfE(e) : 0;
        Linear(
            (mask & ChunkParser.HasX) != 0 ? Target(_x, x, _shiftX) : _x,
            (mask & ChunkParser.HasY) != 0 ? Target(_y, y, _shiftY) : _y,
            (mask & ChunkParser.HasZ) != 0 ? Target(_z, z, _shiftZ) : _z,
            de,
            code);
    }

    private double Target(double from, double word, double shift) => _machineCoordinates ? word * Unit - shift : _relative ? from + word * Unit : word * Unit;

    private bool HasAxisWord(ParsedLine line)
    {
        for (var i = 0; i < line.Count; i++)
        {
            if (line.HasValue[i] && (line.Letters[i] is (byte)'X' or (byte)'Y' or (byte)'Z' || _axis.Is(line.Letters[i])
                || (_readsTurns && line.Letters[i] is (byte)'A' or (byte)'B' or (byte)'C')
                || (_motion > 1 && line.Letters[i] is (byte)'I' or (byte)'J' or (byte)'K' or (byte)'R'))) return true;
        }
        return false;
    }

    private void SetFeed(double feed)
    {
        feed *= Unit;
        if (!(feed is > 0 and < 1e9)) return;
        _feed = feed;
        _speed = feed / 60 * _feedFactor;
    }

    private void Action(int code, ParsedLine line)
    {
        if (IsHomer(code))
        {
            if (_rules.Homing == HomingRule.HomesToZero) Home(line);
            else GoToStored(line, code == 280 ? 0 : 1);
            return;
        }
        switch (code)
        {
            case 40:
                Dwell(line);
                return;
            case 100:
            case 110:
                if (line.HasAny(_rules.NoRetractionWith) || !_rules.FirmwareRetraction) Offsets(line, code);
                else FirmwareRetraction(code == 100);
                return;
            case 920:
                Rename(line);
                return;
            case 281 when _rules.Homing == HomingRule.GoesToStoredPosition:
            case 301 when _rules.Homing == HomingRule.GoesToStoredPosition:
                Store(code == 281 ? 0 : 1);
                return;
            default:
                if (DialectRules.Names(_rules.ShiftResets, 'G', code / 10.0)) ClearShifts();
                else Ignored('G', code < 0 ? 0 : code / 10.0);
                return;
        }
    }

    private bool IsHomer(int code)
    {
        if (code == 280 && _rules.HomingCommands.Count == 1) return true;
        return code is 280 or 300 or 1610 or 1620 && DialectRules.Names(_rules.HomingCommands, 'G', code / 10.0);
    }

    private void FirmwareRetraction(bool retract)
    {
        Features.FirmwareRetraction++;
        if (retract) DecodeCounters.FirmwareRetracts++;
        else DecodeCounters.FirmwareUnretracts++;
        Emit(_x, _y, _z, 0, 0, retract ? MoveKind.Retract : MoveKind.Restore);
    }

    private void Dwell(ParsedLine line)
    {
        var seconds = _rules.DwellSeconds(line.TryGet('P', out var p) ? p : null, line.TryGet('S', out var s) ? s : null);
        if (!(seconds is > 0 and < 1e9)) return;
        AddEvent(new DwellEvent(seconds));
        Emit(_x, _y, _z, 0, 0, MoveKind.Dwell);
    }
}
