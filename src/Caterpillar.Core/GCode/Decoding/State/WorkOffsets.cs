namespace Caterpillar.GCode;

/// <summary>The origins of the coordinate systems G54 to G59.3 in machine coordinates, and the selected one. That of G54 has the number 1.</summary>
internal struct WorkOffsets
{
    public const int Count = 9;

    // Null while the file has set none. Replaced, never changed.
    private Vec3[]? _origins;
    private int _isSet;

    /// <summary>The selected system; 0 = none.</summary>
    public int Selected;

    /// <summary>True while the words of a line are machine coordinates (G53).</summary>
    public bool IsMachineLine;

    public readonly Vec3 Origin => OriginOf(Selected);

    public readonly Vec3 OriginOf(int system) => _origins is null ? Vec3.Zero : _origins[system];

    /// <summary>True if the file has set the origin of the selected system, or none is selected.</summary>
    public readonly bool HasOrigin => Selected == 0 || (_isSet & (1 << Selected)) != 0;

    public void SetOrigin(int system, Vec3 origin)
    {
        _origins = _origins is null ? new Vec3[Count + 1] : (Vec3[])_origins.Clone();
        _isSet |= 1 << system;
        _origins[system] = origin;
    }

    public readonly bool ReadsLike(in WorkOffsets other)
        => Selected == other.Selected
            && (_origins is null || other._origins is null ? _origins == other._origins : _origins.SequenceEqual(other._origins));
}
