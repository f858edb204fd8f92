namespace Caterpillar.GCode;

/// <summary>States that a file saves and restores (M120, G60, SAVE_GCODE_STATE), and the offsets of SET_GCODE_OFFSET and M206, which homing keeps.</summary>
internal struct SavedStates
{
    private const int MaxCount = 100;

    // Replaced, never changed.
    private SavedState[] _stack;
    private SavedState[] _named;

    /// <summary>The offset of the head, mm; the negative home offset of M206.</summary>
    public Vec3 Offset;

    /// <summary>What M290 has added to the height, mm.</summary>
    public double Babysteps;
    public double OffsetE;

    public static SavedStates None => new() { _stack = [], _named = [] };

    public void Push(SavedState state)
    {
        if (_stack.Length < MaxCount) _stack = [.. _stack, state];
    }

    /// <summary>The state that was pushed last, or null.</summary>
    public SavedState? Pop()
    {
        if (_stack.Length == 0) return null;
        var last = _stack[_stack.Length - 1];
        _stack = _stack.Take(_stack.Length - 1).ToArray();
        return last;
    }

    public void SetNamed(SavedState state) => _named = [.. _named.Where(s => s.Name != state.Name).Take(MaxCount), state];

    public readonly SavedState? Named(string name) => _named.FirstOrDefault(s => s.Name == name);

    public readonly bool ReadsLike(in SavedStates other)
        => Offset == other.Offset && Babysteps == other.Babysteps && OffsetE == other.OffsetE
            && _stack.SequenceEqual(other._stack) && _named.SequenceEqual(other._named);
}

/// <summary>A saved state. Its last motion does not count.</summary>
internal sealed record SavedState(string Name, Modes Modes, FeedState Feed, ExtrusionState Extrusion, HeadPosition Head, Vec3 Offset, double OffsetE);
