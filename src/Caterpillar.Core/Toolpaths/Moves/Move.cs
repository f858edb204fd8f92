namespace Caterpillar.Toolpaths;

/// <summary>One move of a <see cref="Toolpath"/>.</summary>
/// <param name="Index">Number of the move in the toolpath, from 0.</param>
/// <param name="Start">Start point, mm.</param>
/// <param name="End">End point, mm.</param>
/// <param name="E">Commanded change of E, signed, in the unit of the tool (mm of filament or mm³).</param>
/// <param name="Deposited">Part of E that is deposited, without deretraction, in the same unit.</param>
/// <param name="Speed">Speed of the head, or of the filament for moves in place, mm/s.</param>
/// <param name="Kind">Kind of the move.</param>
/// <param name="Role">Role of the extrusion.</param>
/// <param name="Layer">Index into the layers of the toolpath. −1 = no layer.</param>
/// <param name="Tool">Number of the tool.</param>
/// <param name="Source">Line of the file (from 1) or number of the step (from 0), see <see cref="Toolpath.Source"/>. −1 = none.</param>
/// <param name="Arc">The arc. Null = straight.</param>
public readonly record struct Move(
    int Index, Vec3 Start, Vec3 End, double E, double Deposited, double Speed, MoveKind Kind, Role Role, int Layer, int Tool, int Source, Arc? Arc)
{
    /// <summary>Bounding box of the motion, mm.</summary>
    public Bounds Bounds => Arc is { } arc ? arc.Bounds(Start, End) : Bounds.Empty.Include(Start).Include(End);

    /// <summary>True if the head does not move.</summary>
    internal bool IsInPlace => Arc is null && IsSame(Start, End);

    /// <summary>True if a machine does not distinguish these points.</summary>
    internal static bool IsSame(Vec3 start, Vec3 end) => start.DistanceTo(end) <= 1e-9;

    /// <summary>The point at a part of the motion, 0 to 1.</summary>
    internal Vec3 PointAt(double t) => Geometry.Arc.PointAt(Arc, Start, End, t);

    /// <summary>Length of the motion, mm.</summary>
    public double Length => Arc is { } arc ? arc.Length(Start, End) : Start.DistanceTo(End);
}
