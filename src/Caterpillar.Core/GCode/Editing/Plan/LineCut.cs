namespace Caterpillar.GCode;

/// <summary>Lines of a file that are left out, and the lines in their place.</summary>
/// <param name="First">First line that is left out, from 1.</param>
/// <param name="Last">Last line that is left out. The state that the line after it expects is restored there.</param>
/// <param name="Lines">The lines in their place.</param>
/// <param name="Moves">True to bring the head to where the line after it expects it.</param>
/// <param name="Height">Height in mm to which the head rises at least. NaN = none.</param>
/// <param name="KeepsComments">True to keep the last comments about layer, role and object.</param>
internal sealed record LineCut(int First, int Last, IReadOnlyList<string> Lines, bool Moves = false, double Height = double.NaN, bool KeepsComments = false)
{
    public bool Has(int line) => line >= First && line <= Last;
}
