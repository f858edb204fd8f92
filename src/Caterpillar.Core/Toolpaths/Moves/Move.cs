using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>One move of a <see cref="Toolpath"/>, gathered from its columns.</summary>
/// <param name="Index">Number of the move in the toolpath, from 0.</param>
/// <param name="Start">Start point, mm.</param>
/// <param name="End">End point, mm.</param>
/// <param name="E">Commanded change of E, signed, in the unit of the tool (mm of filament or mm³).</param>
/// <param name="Deposited">Part of it that becomes material on the part, after the retraction balance; same unit.</param>
/// <param name="Speed">mm/s; for moves in place, of the filament.</param>
/// <param name="Kind">What the machine does.</param>
/// <param name="Role">What the extrusion is for.</param>
/// <param name="Layer">Index into the layers of the toolpath, or −1.</param>
/// <param name="Tool">Number of the tool.</param>
/// <param name="Source">Line of the file (from 1) or number of the step (from 0), according to the toolpath; −1 if there is none.</param>
/// <param name="Arc">Its geometry if it is not straight.</param>
public readonly record struct Move(
    int Index, Vec3 Start, Vec3 End, double E, double Deposited, double Speed, MoveKind Kind, Role Role, int Layer, int Tool, int Source, Arc? Arc)
{
    /// <summary>Box around the motion of the head, mm.</summary>
    public Bounds Bounds => Arc is { } arc ? arc.Bounds(Start, End) : Bounds.Empty.Include(Start).Include(End);

    /// <summary>True if the head does not move.</summary>
    internal bool IsInPlace => Arc is null && IsSame(Start, End);

    /// <summary>True for points that are the same to a machine.</summary>
    internal static bool IsSame(Vec3 start, Vec3 end) => start.DistanceTo(end) <= 1e-9;

    /// <summary>Length of the motion of the head, mm.</summary>
    public double Length => Arc is { } arc ? arc.Length(Start, End) : Start.DistanceTo(End);
}
