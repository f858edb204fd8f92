namespace Caterpillar.Machines;

// Where loops begin, and in which order the walls of a contour are printed.
public sealed partial record PrintSettings
{
    /// <summary>Start of outer walls: aligned, nearest, rear, near seam_point_mm, random, or in the sharpest concave corner.</summary>
    public SeamPosition SeamPosition { get; init; } = SeamPosition.Aligned;

    /// <summary>With seam_position=point: seams face this point of the bed.</summary> <value>mm.</value>
    public Vec3 SeamPoint { get; init => field = SeamKeys.SeamPoint.Check(value); }

    /// <summary>Seam enforcers: spheres [x, y, z, radius]. Walls that pass through one start there.</summary> <value>mm.</value>
    public ValueList<SeamMark> SeamEnforcers { get; init => field = SeamKeys.SeamEnforcers.Check(value); } = ValueList<SeamMark>.Empty;

    /// <summary>Random seed of seam_position=random.</summary>
    public int SeamSeed { get; init => field = SeamKeys.SeamSeed.Check(value); } = 1;

    /// <summary>Gap left at the end of each closed wall to prevent a blob, at most a tenth of the wall; 0 = off.</summary>
    /// <value>mm.</value> <remarks>Beads have round ends. Two ends in one place would form a blob.</remarks>
    public double SeamGap { get; init => field = SeamKeys.SeamGap.Check(value); } = 0.06;

    /// <summary>Length of scarf seams; 0 = off.</summary> <value>mm.</value>
    public double ScarfSeamLength { get; init => field = SeamKeys.ScarfSeamLength.Check(value); }

    /// <summary>Number of steps of a scarf seam.</summary>
    public int ScarfSeamSteps { get; init => field = SeamKeys.ScarfSeamSteps.Check(value); } = 12;

    /// <summary>Print walls from inside out, outside in, or alternating by layer.</summary>
    public WallOrder WallOrder { get; init; } = WallOrder.InsideOut;

    /// <summary>Order of walls with overhangs.</summary>
    public OverhangWallOrder OverhangWallOrder { get; init; } = OverhangWallOrder.Same;
}

/// <summary>Keys of print settings: seams and the order of walls.</summary>
internal static class SeamKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly ProfileKey<PrintSettings, SeamPosition> SeamPosition
        = All.Choice("seam_position", s => s.SeamPosition, (s, v) => s with { SeamPosition = v });
    public static readonly ProfileKey<PrintSettings, Vec3> SeamPoint = All.Of(
        "seam_point_mm", new NumbersFormat<Vec3>(["x", "y"], -100_000, 100_000, n => new Vec3(n[0], n[1]), v => [v.X, v.Y]), s => s.SeamPoint,
        (s, v) => s with { SeamPoint = v });
    public static readonly ProfileKey<PrintSettings, ValueList<SeamMark>> SeamEnforcers = All.Of(
        "seam_enforcers_mm",
        new RowsFormat<SeamMark>(
            ["x", "y", "z", "radius"], 10_000, -100_000, 100_000, SeamMark.Of, m => [m.Place.X, m.Place.Y, m.Place.Z, m.Radius], SeamMark.Problem),
        s => s.SeamEnforcers, (s, v) => s with { SeamEnforcers = v });
    public static readonly IntegerKey SeamSeed = All.Integer("seam_seed", 0, 1_000_000_000, s => s.SeamSeed, (s, v) => s with { SeamSeed = v });
    public static readonly NumberKey SeamGap = All.Number("seam_gap_mm", 0, 10, s => s.SeamGap, (s, v) => s with { SeamGap = v });
    public static readonly NumberKey ScarfSeamLength
        = All.NumberOrZero("scarf_seam_length_mm", 0.1, 1000, s => s.ScarfSeamLength, (s, v) => s with { ScarfSeamLength = v });
    public static readonly IntegerKey ScarfSeamSteps = All.Integer("scarf_seam_steps", 2, 1000, s => s.ScarfSeamSteps, (s, v) => s with { ScarfSeamSteps = v });
    public static readonly ProfileKey<PrintSettings, WallOrder> WallOrder = All.Choice("wall_order", s => s.WallOrder, (s, v) => s with { WallOrder = v });
    public static readonly ProfileKey<PrintSettings, OverhangWallOrder> OverhangWallOrder
        = All.Choice("overhang_wall_order", s => s.OverhangWallOrder, (s, v) => s with { OverhangWallOrder = v });
}
