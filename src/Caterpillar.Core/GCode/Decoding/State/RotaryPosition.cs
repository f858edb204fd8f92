namespace Caterpillar.GCode;

/// <summary>Position of the rotary axes, degrees.</summary>
/// <param name="Written">As written.</param>
/// <param name="Shift">Machine coordinates minus coordinates as written. G92 changes it.</param>
internal readonly record struct RotaryPosition(Turns Written, Turns Shift)
{
    public Turns Machine => new(Written.A + Shift.A, Written.B + Shift.B, Written.C + Shift.C);
}

/// <summary>Angles of the rotary axes, degrees.</summary>
internal readonly record struct Turns(double A, double B, double C)
{
    public bool IsNear(Turns other)
        => Math.Abs(A - other.A) <= InterpreterState.NoChange && Math.Abs(B - other.B) <= InterpreterState.NoChange
            && Math.Abs(C - other.C) <= InterpreterState.NoChange;
}
