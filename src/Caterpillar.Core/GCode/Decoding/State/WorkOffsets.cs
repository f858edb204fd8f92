namespace Caterpillar.GCode;

/// <summary>The origins of the coordinate systems G54 to G59.3 in machine coordinates, and the selected one.</summary>
internal struct WorkOffsets
{
    public const int Count = 9;

    // Null while the file has set none. Replaced, never changed.
    private Vec3[]? _origins;

    /// <summary>The selected system, from 0.</summary>
    public int Selected;

    /// <summary>True while the words of a line are machine coordinates (G53).</summary>
    public bool IsMachineLine;

    public readonly Vec3 Origin => OriginOf(Selected);

    public readonly Vec3 OriginOf(int system) => _origins is null ? Vec3.Zero : _origins[system];

    public void SetOrigin(int system, Vec3 origin)
    {
        _origins = _origins is null ? new Vec3[Count] : (Vec3[])_origins.Clone();
        _origins[system] = origin;
    }

    public readonly bool ReadsLike(in WorkOffsets other)
        => Selected == other.Selected
            && (_origins is null || other._origins is null ? _origins == other._origins : _origins.SequenceEqual(other._origins));
}
