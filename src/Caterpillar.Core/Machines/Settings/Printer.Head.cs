namespace Caterpillar.Machines;

// Tools, head, and what it must not hit.
public sealed partial record Printer
{
    /// <summary>Offset of each tool from the first one.</summary> <value>mm.</value>
    public ValueList<Vec3> ToolOffsets { get; init => field = HeadKeys.ToolOffsets.Check(value); } = new(Vec3.Zero);

    /// <summary>The tools feed one nozzle: a tool change swaps the filament. Otherwise each tool has a nozzle of its own, which it heats.</summary>
    public bool SharedNozzle { get; init; }

    /// <summary>Profile of nozzle and head: radius at each height above the tip.</summary> <value>mm.</value> <remarks>Radius and height ascend.</remarks>
    public ValueList<HeadPoint> HeadOutline { get; init => field = HeadKeys.HeadOutline.Check(value); }
        = new(new HeadPoint(0.5, 0), new(4, 6), new(20, 12));

    /// <summary>Boxes around parts of the head that are not round, relative to the nozzle tip.</summary> <value>mm.</value>
    public ValueList<Bounds> HeadBoxes { get; init => field = HeadKeys.HeadBoxes.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Beams along X across the whole bed that hold the head, relative to the nozzle tip.</summary>
    /// <value>mm.</value> <remarks>X is ignored.</remarks>
    public ValueList<Bounds> Gantry { get; init => field = HeadKeys.Gantry.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Boxes around bed clips and other obstacles on the bed, in machine coordinates.</summary> <value>mm.</value>
    public ValueList<Bounds> Clips { get; init => field = HeadKeys.Clips.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Rectangles of the bed to keep free.</summary> <value>mm.</value> <remarks>In the machine's coordinates.</remarks>
    public ValueList<Bounds> ExcludedAreas { get; init => field = HeadKeys.ExcludedAreas.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Coordinates that another word replaces, scaled: X=A*2.86 turns a platform by 2.86 degrees per mm of X, X=A*2.86@110 holds X at 110.</summary>
    /// <remarks>Planning, checks and times use the unrolled surface.</remarks>
    public ValueList<AxisMapping> AxisMappings { get; init => field = HeadKeys.AxisMappings.Check(value); } = ValueList<AxisMapping>.Empty;

    /// <summary>Severities of checks that differ from the default. Errors refuse the file.</summary>
    /// <remarks>Defaults are in <see cref="CheckCodes.All"/>.</remarks>
    public ValueList<CheckSeverity> CheckSeverities { get; init => field = HeadKeys.CheckSeverities.Check(value); } = ValueList<CheckSeverity>.Empty;
}

/// <summary>Keys of printers: tools, head and obstacles.</summary>
internal static class HeadKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly ProfileKey<Printer, ValueList<Vec3>> ToolOffsets = All.Of(
        "tool_offsets_mm", new RowsFormat<Vec3>(["x", "y", "z"], 64, -10_000, 10_000, n => new Vec3(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]) { Fewest = 1 },
        p => p.ToolOffsets, (p, v) => p with { ToolOffsets = v });
    public static readonly ProfileKey<Printer, bool> SharedNozzle
        = All.Boolean("shared_nozzle", p => p.SharedNozzle, (p, v) => p with { SharedNozzle = v });
    public static readonly ProfileKey<Printer, ValueList<HeadPoint>> HeadOutline = All.Of(
        "head_outline_mm",
        new RowsFormat<HeadPoint>(["radius", "height"], 64, 0, 10_000, n => new HeadPoint(n[0], n[1]), h => [h.Radius, h.Height], Ascends) { Fewest = 1 },
        p => p.HeadOutline, (p, v) => p with { HeadOutline = v });
    public static readonly ProfileKey<Printer, ValueList<Bounds>> HeadBoxes = All.Of(
        "head_boxes_mm", new RowsFormat<Bounds>(["min x", "min y", "min z", "max x", "max y", "max z"], 64, -10_000, 10_000, MakeBox, TakeBox),
        p => p.HeadBoxes, (p, v) => p with { HeadBoxes = v });
    public static readonly ProfileKey<Printer, ValueList<Bounds>> Gantry = All.Of(
        "gantry_mm",
        new RowsFormat<Bounds>(
            ["min y", "min z", "max y", "max z"], 64, -10_000, 10_000, n => MakeBox([0, n[0], n[1], 0, n[2], n[3]]),
            b => [b.Min.Y, b.Min.Z, b.Max.Y, b.Max.Z]),
        p => p.Gantry, (p, v) => p with { Gantry = v });
    public static readonly ProfileKey<Printer, ValueList<Bounds>> Clips = All.Of(
        "bed_clips_mm", new RowsFormat<Bounds>(["min x", "min y", "min z", "max x", "max y", "max z"], 64, -100_000, 100_000, MakeBox, TakeBox), p => p.Clips,
        (p, v) => p with { Clips = v });
    public static readonly ProfileKey<Printer, ValueList<Bounds>> ExcludedAreas = All.Of(
        "bed_exclude_areas_mm",
        new RowsFormat<Bounds>(
            ["min x", "min y", "max x", "max y"], 64, -100_000, 100_000, n => Bounds.Of([new Vec3(n[0], n[1]), new Vec3(n[2], n[3])]),
            b => [b.Min.X, b.Min.Y, b.Max.X, b.Max.Y]),
        p => p.ExcludedAreas, (p, v) => p with { ExcludedAreas = v });
    public static readonly ProfileKey<Printer, ValueList<AxisMapping>> AxisMappings
        = All.Of("axis_mappings", new MappingFormat(), p => p.AxisMappings, (p, v) => p with { AxisMappings = v });
    public static readonly ProfileKey<Printer, ValueList<CheckSeverity>> CheckSeverities
        = All.Of("check_severities", new SeverityFormat(), p => p.CheckSeverities, (p, v) => p with { CheckSeverities = v });

    private static string? Ascends(ValueList<HeadPoint> outline)
    {
        for (var i = 1; i < outline.Count; i++)
        {
            if (outline[i].Radius <= outline[i - 1].Radius || outline[i].Height < outline[i - 1].Height) return "must have ascending radii and heights";
        }
        return outline[0].Height == 0 ? null : "must begin at the tip, height 0";
    }

    private static Bounds? MakeBox(double[] n)
        => n[0] <= n[3] && n[1] <= n[4] && n[2] <= n[5] ? new Bounds(new Vec3(n[0], n[1], n[2]), new Vec3(n[3], n[4], n[5])) : null;

    private static double[] TakeBox(Bounds b) => [b.Min.X, b.Min.Y, b.Min.Z, b.Max.X, b.Max.Y, b.Max.Z];
}
