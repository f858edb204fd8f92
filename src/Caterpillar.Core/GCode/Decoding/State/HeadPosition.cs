namespace Caterpillar.GCode;

/// <summary>Position of the head, mm: coordinates as written (after G92), and their shift to machine coordinates.</summary>
internal struct HeadPosition
{
    public double X;
    public double Y;
    public double Z;

    // Machine coordinates minus coordinates as written.
    public double ShiftX;
    public double ShiftY;
    public double ShiftZ;

    // An axis is known once the file has homed it, named its position or moved it.
    public bool KnownX;
    public bool KnownY;
    public bool KnownZ;

    /// <summary>Axes in which a macro may have moved the head, and which the file has not stated since, as a mask of <see cref="ChunkParser"/>.</summary>
    public int Lost;

    /// <summary>True once the file has made a move.</summary>
    public bool HasMoved;

    public readonly Vec3 Written => new(X, Y, Z);

    public readonly Vec3 Shift => new(ShiftX, ShiftY, ShiftZ);

    public readonly Vec3 Machine => new(X + ShiftX, Y + ShiftY, Z + ShiftZ);

    public readonly bool IsKnown => KnownX && KnownY && KnownZ;

    /// <summary>Moves the origin of the coordinates as written. The head does not move.</summary>
    public void SetShift(Vec3 shift)
    {
        X += ShiftX - shift.X;
        Y += ShiftY - shift.Y;
        Z += ShiftZ - shift.Z;
        (ShiftX, ShiftY, ShiftZ) = (shift.X, shift.Y, shift.Z);
    }

    public readonly bool ReadsLike(in HeadPosition other)
        => Near(X, other.X) && Near(Y, other.Y) && Near(Z, other.Z) && HasShiftOf(other);

    public readonly bool HasShiftOf(in HeadPosition other)
        => Near(ShiftX, other.ShiftX) && Near(ShiftY, other.ShiftY) && Near(ShiftZ, other.ShiftZ);

    private static bool Near(double a, double b) => Math.Abs(a - b) <= InterpreterState.NoChange;
}
