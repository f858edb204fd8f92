namespace Caterpillar.Machines;

// Where loops begin, and in which order the walls of a contour are printed.
public sealed partial record PrintSettings
{
    /// <summary>Start of outer walls: aligned, nearest, rear, near seam_point_mm, random, or in the sharpest concave corner.</summary>
    public SeamPosition SeamPosition { get; init; } = SeamPosition.Aligned;

    /// <summary>With seam_position=point: seams face this point of the bed.</summary> <value>mm.</value>
    public Vec3 SeamPoint { get; init => field = Keys.Check(value); }

    /// <summary>Seam enforcers: spheres [x, y, z, radius]. Walls that pass through one start there.</summary> <value>mm.</value>
    public ValueList<SeamMark> SeamEnforcers { get; init => field = Keys.Check(value); } = ValueList<SeamMark>.Empty;

    /// <summary>Random seed of seam_position=random.</summary>
    public int SeamSeed { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Gap left at the end of each closed wall to prevent a blob, at most a tenth of the wall; 0 = off.</summary>
    /// <value>mm.</value> <remarks>Beads have round ends. Two ends in one place would form a blob.</remarks>
    public double SeamGap { get; init => field = Keys.Check(value); } = 0.06;

    /// <summary>Length of scarf seams; 0 = off.</summary> <value>mm.</value>
    public double ScarfSeamLength { get; init => field = Keys.Check(value); }

    /// <summary>Number of steps of a scarf seam.</summary>
    public int ScarfSeamSteps { get; init => field = Keys.Check(value); } = 12;

    /// <summary>Print walls from inside out, outside in, or alternating by layer.</summary>
    public WallOrder WallOrder { get; init; } = WallOrder.InsideOut;

    /// <summary>Order of walls with overhangs.</summary>
    public OverhangWallOrder OverhangWallOrder { get; init; } = OverhangWallOrder.Same;
}
