namespace Caterpillar.GCode;

/// <summary>Rotary axes: the words A, B and C in degrees, without the letter of extrusion.</summary>
internal sealed class RotaryWords(LineBuffer output, int decimals, byte extruder)
{
    private readonly long[] _turns = [long.MinValue, long.MinValue, long.MinValue];
    private readonly long[] _next = new long[3];

    /// <summary>True if an axis turns with the next line.</summary>
    public bool Turns { get; private set; }

    /// <summary>Sets the axes for the end of a move.</summary>
    public void Aim(ToolpathColumns c, int i)
    {
        Turns = false;
        if (c.Turns is null) return;
        var words = c.Turns[i];
        for (var axis = 0; axis < 3; axis++)
        {
            _next[axis] = NumberFormatter.ToUnits(axis == 0 ? words.X : axis == 1 ? words.Y : words.Z, decimals);
            if ('A' + axis == extruder) _next[axis] = _turns[axis];
            // An axis that never leaves zero is not there.
            else if (_turns[axis] == long.MinValue && _next[axis] == 0) _next[axis] = long.MinValue;
            Turns |= _next[axis] != _turns[axis];
        }
    }

    /// <summary>Adds the words of the turning axes to the line, as differences in relative mode.</summary>
    public void Write(bool relative)
    {
        if (!Turns) return;
        for (var axis = 0; axis < 3; axis++)
        {
            if (_next[axis] == _turns[axis]) continue;
            var from = relative && _turns[axis] != long.MinValue ? _turns[axis] : 0;
            _turns[axis] = _next[axis];
            output.Word((byte)('A' + axis), _turns[axis] - from, decimals);
        }
        Turns = false;
    }

    /// <summary>Start and end of the axes in a move that becomes several. Null if they do not turn.</summary>
    public (long[] From, long[] To)? Begin() => Turns ? ((long[])_turns.Clone(), (long[])_next.Clone()) : null;

    /// <summary>Aims at a share of such turns.</summary>
    public void Share((long[] From, long[] To) of, double share)
    {
        for (var axis = 0; axis < 3; axis++)
        {
            var (from, to) = (of.From[axis], of.To[axis]);
            if (to == from) continue;
            // An axis that was not there before turns from 0.
            var start = from == long.MinValue ? 0 : from;
            _next[axis] = share >= 1 ? to : start + (long)Math.Floor((to - start) * share + 0.5);
        }
        Turns = true;
    }
}
