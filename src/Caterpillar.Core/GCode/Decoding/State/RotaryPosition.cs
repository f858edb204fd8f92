namespace Caterpillar.GCode;

/// <summary>Position of the rotary axes A, B and C, degrees.</summary>
/// <param name="Written">As written.</param>
/// <param name="Shift">Machine coordinates minus coordinates as written. G92 changes it.</param>
internal readonly record struct RotaryPosition(Vec3 Written, Vec3 Shift)
{
    public Vec3 Machine => Written + Shift;
}
