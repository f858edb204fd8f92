using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Rotary axes: the words A, B and C, in degrees, in files where they do not extrude. Only lines with these words come here.</summary>
internal sealed partial class DecoderCore
{
    private bool _readsTurns => _axis == ExtrusionAxis.E || _axis == ExtrusionAxis.None || _axis == ExtrusionAxis.Switched;

    // As written, and what G92 has taken from that.
    private Turns _turns;
    private Turns _turnShift;

    /// <summary>Where the rotary axes stand, degrees, in machine coordinates.</summary>
    public Turns Turns => new(_turns.A + _turnShift.A, _turns.B + _turnShift.B, _turns.C + _turnShift.C);

    /// <summary>The rotary axes as written minus as they are.</summary>
    public Turns TurnShift => _turnShift;

    private static bool HasTurnWord(ParsedLine line) => line.Find('A') >= 0 || line.Find('B') >= 0 || line.Find('C') >= 0;

    private void MoveAndTurn(ParsedLine line)
    {
        if (!_readsTurns || !HasTurnWord(line))
        {
            Move(line);
            return;
        }
        var before = _out.Count;
        Move(line);
        var target = new Turns(Turned(line, 'A', _turns.A), Turned(line, 'B', _turns.B), Turned(line, 'C', _turns.C));
        if (target == _turns) return;
        _turns = target;
        // Turning alone is a move as well.
        if (_out.Count == before) Emit(_x, _y, _z, 0, 0, MoveKind.Travel);
        _out.Turn(Turns);
    }

    private double Turned(ParsedLine line, char letter, double from)
        => !line.TryGet(letter, out var word) || !(word is > -Largest and < Largest) ? from
            : !_relative ? word
            : from + word is > -Largest and < Largest and var to ? to : from;

    private void RenameTurns(ParsedLine line)
    {
        if (!_readsTurns || !HasTurnWord(line)) return;
        var before = Turns;
        var relative = _relative;
        _relative = false;
        _turns = new Turns(Turned(line, 'A', _turns.A), Turned(line, 'B', _turns.B), Turned(line, 'C', _turns.C));
        _relative = relative;
        _turnShift = new Turns(before.A - _turns.A, before.B - _turns.B, before.C - _turns.C);
    }
}

/// <summary>Rotary axes in degrees.</summary>
internal readonly record struct Turns(double A, double B, double C)
{
    public bool IsNear(Turns other) => System.Math.Abs(A - other.A) <= 1e-9 && System.Math.Abs(B - other.B) <= 1e-9 && System.Math.Abs(C - other.C) <= 1e-9;
}
