using Caterpillar.Geometry;

namespace Caterpillar.Machines;

// Where loops begin, and in which order the walls of a contour are printed.
public sealed partial record PrintSettings
{
    /// <summary>Where the outer walls begin and end.</summary>
    public SeamPosition SeamPosition { get; init; } = SeamPosition.Aligned;

    /// <summary>For <see cref="SeamPosition.Point"/>: seams lie on the side of this point, X and Y in mm.</summary>
    public Vec3 SeamPoint { get; init => field = SeamKeys.SeamPoint.Check(value); }

    /// <summary>Painted places: where a loop passes one of these balls, its seam lies there.</summary>
    public ValueList<SeamMark> SeamMarks { get; init => field = SeamKeys.SeamMarks.Check(value); } = ValueList<SeamMark>.Empty;

    /// <summary>Seed of the random numbers of <see cref="SeamPosition.Random"/>.</summary>
    public int SeamSeed { get; init => field = SeamKeys.SeamSeed.Check(value); } = 1;

    /// <summary>
    /// So far before it has gone around a closed wall the extruder stops, mm, at most a tenth of the wall: beads begin and end round, so that two ends in one
    /// place would be a blob.
    /// </summary>
    public double SeamGap { get; init => field = SeamKeys.SeamGap.Check(value); } = 0.06;

    /// <summary>Length over which an outer wall rises at its start and runs out over that ramp at its end, mm; 0 for a plain seam.</summary>
    public double ScarfLength { get; init => field = SeamKeys.ScarfLength.Check(value); }

    /// <summary>Steps of the ramp of a scarf seam.</summary>
    public int ScarfSteps { get; init => field = SeamKeys.ScarfSteps.Check(value); } = 12;

    /// <summary>The order of the walls of a contour.</summary>
    public WallOrder WallOrder { get; init; } = WallOrder.InsideOut;

    /// <summary>The order of the walls of contours that hang over the layer below somewhere.</summary>
    public OverhangWallOrder OverhangWallOrder { get; init; } = OverhangWallOrder.Same;
}
