using System;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Rotary axes: the words A, B and C, in degrees, of toolpaths that have them.</summary>
public sealed partial class GCodeWriter
{
    private readonly long[] _turns = [long.MinValue, long.MinValue, long.MinValue];
    private readonly long[] _nextTurns = new long[3];
    private bool _hasTurns;

    // What the rotary axes of a move are to be. The letter of extrusion is not theirs.
    private void SetTurns(ToolpathColumns c, int i)
    {
        _hasTurns = false;
        if (c.A is null) return;
        for (var axis = 0; axis < 3; axis++)
        {
            var column = axis == 0 ? c.A : axis == 1 ? c.B! : c.C!;
            _nextTurns[axis] = NumberFormatter.ToUnits(column[i], _format.DecimalsXyz);
            if ('A' + axis == _e) _nextTurns[axis] = _turns[axis];
            // An axis that never leaves zero is not there.
            else if (_turns[axis] == long.MinValue && _nextTurns[axis] == 0) _nextTurns[axis] = long.MinValue;
            _hasTurns |= _nextTurns[axis] != _turns[axis];
        }
    }

    private void Turns()
    {
        if (!_hasTurns) return;
        for (var axis = 0; axis < 3; axis++)
        {
            if (_nextTurns[axis] == _turns[axis]) continue;
            var from = _g91 && _turns[axis] != long.MinValue ? _turns[axis] : 0;
            _turns[axis] = _nextTurns[axis];
            _out.Word((byte)('A' + axis), _turns[axis] - from, _format.DecimalsXyz);
        }
        _hasTurns = false;
    }

    // The turns of a move that becomes several: where the axes stand, and where they are to be.
    private (long[] From, long[] To)? BeginTurns() => _hasTurns ? ((long[])_turns.Clone(), (long[])_nextTurns.Clone()) : null;

    // An axis that was not there before turns from 0.
    private void ShareTurns((long[] From, long[] To)? of, double share)
    {
        var (from, to) = of!.Value;
        for (var axis = 0; axis < 3; axis++)
        {
            if (to[axis] == from[axis]) continue;
            var start = from[axis] == long.MinValue ? 0 : from[axis];
            _nextTurns[axis] = share >= 1 ? to[axis] : start + (long)Math.Floor((to[axis] - start) * share + 0.5);
        }
        _hasTurns = true;
    }
}
