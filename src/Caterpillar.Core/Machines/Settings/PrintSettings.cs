namespace Caterpillar.Machines;

/// <summary>
/// Print settings. Lengths in mm, speeds in mm/s. The keys of profiles are in <see cref="ProfileKeys"/>. A value outside its key's range throws an
/// <see cref="System.ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed partial record PrintSettings
{
    /// <summary>Diameter of the nozzle without a printer, mm.</summary>
    internal const double UsualNozzle = 0.4;

    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "standard";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = SettingsKeys.Title.Check(value); } = "Standard";

    /// <summary>Layer height; 0 = half the nozzle diameter.</summary> <value>mm.</value>
    public double LayerHeight { get => OfNozzle(field, 0.2); init => field = SettingsKeys.LayerHeight.Check(value); }

    /// <summary>Height of the first layer; 0 = half the nozzle diameter.</summary> <value>mm.</value>
    public double FirstLayerHeight { get => OfNozzle(field, 0.2); init => field = SettingsKeys.FirstLayerHeight.Check(value); }

    /// <summary>The larger of both heights, mm.</summary>
    internal double LargerLayerHeight => Math.Max(LayerHeight, FirstLayerHeight);

    /// <summary>Width of extrusions; 0 = 112.5 % of the nozzle diameter.</summary> <value>mm.</value>
    public double LineWidth { get => OfNozzle(field, 0.45); init => field = SettingsKeys.LineWidth.Check(value); }

    /// <summary>Shape of the cross-section of an extrusion, which relates its area to its width.</summary>
    public BeadShape BeadShape { get; init; } = BeadShape.Stadium;

    /// <summary>Number of walls.</summary>
    public int WallCount { get; init => field = SettingsKeys.WallCount.Check(value); } = 2;

    /// <summary>Infill density. infill_spacing_mm takes precedence.</summary> <value>%.</value>
    public double InfillDensityPercent { get; init => field = SettingsKeys.InfillDensityPercent.Check(value); } = 20;

    /// <summary>Distance between infill lines; 0 = from infill_density_percent.</summary>
    /// <value>mm.</value> <remarks>The "density" of Caterpillar 2019.</remarks>
    public double InfillSpacing { get; init => field = SettingsKeys.InfillSpacing.Check(value); }

    /// <summary>Direction of infill lines in the first layer, counterclockwise from +X.</summary> <value>Degrees.</value>
    public double InfillAngle { get; init => field = SettingsKeys.InfillAngle.Check(value); } = 45;

    /// <summary>Overlap of infill with the innermost wall, in % of the line width. Solid infill overlaps by two thirds of it.</summary> <value>%.</value>
    public double InfillOverlapPercent { get; init => field = SettingsKeys.InfillOverlapPercent.Check(value); } = 15;

    /// <summary>Maximum deviation of simplified contours.</summary> <value>mm.</value>
    public double Resolution { get; init => field = SettingsKeys.Resolution.Check(value); } = 0.0125;

    /// <summary>Print overlapping models as one solid. Otherwise their overlap is printed twice.</summary>
    public bool MergeOverlappingModels { get; init; } = true;

    /// <summary>Print several models layer by layer, or one by one, lowest first.</summary>
    public PrintSequence PrintSequence { get; init; } = PrintSequence.ByLayer;

    /// <summary>Repair meshes that are not closed: join naked edges, fill holes, turn faces outward.</summary>
    public bool RepairMeshes { get; init; } = true;

    /// <summary>Widest gap to close in contours of broken meshes; 0 = off.</summary> <value>mm.</value>
    public double SliceGapClosing { get; init => field = SettingsKeys.SliceGapClosing.Check(value); } = 10;

    /// <summary>Maximum loss of area of a layer of a broken mesh, compared with its neighbors; 100 = no limit.</summary> <value>%.</value>
    public double MaxAreaLossPercent { get; init => field = SettingsKeys.MaxAreaLossPercent.Check(value); } = 25;

    /// <summary>Segment length of subdivided curves.</summary> <value>mm.</value>
    public double SubdivisionDistance { get; init => field = SettingsKeys.SubdivisionDistance.Check(value); } = 1;

    /// <summary>Printing speed.</summary> <value>mm/s.</value>
    public double PrintSpeed { get; init => field = SettingsKeys.PrintSpeed.Check(value); } = 60;

    /// <summary>Speed of outer walls; 0 = printing speed.</summary> <value>mm/s.</value>
    public double OuterWallSpeed { get; init => field = SettingsKeys.OuterWallSpeed.Check(value); } = 40;

    /// <summary>Speed of sparse infill; 0 = printing speed.</summary> <value>mm/s.</value>
    public double InfillSpeed { get; init => field = SettingsKeys.InfillSpeed.Check(value); }

    /// <summary>Maximum speed of the first layer; 0 = no limit.</summary> <value>mm/s.</value>
    public double FirstLayerSpeed { get; init => field = SettingsKeys.FirstLayerSpeed.Check(value); } = 25;

    /// <summary>Travel speed.</summary> <value>mm/s.</value>
    public double TravelSpeed { get; init => field = SettingsKeys.TravelSpeed.Check(value); } = 150;

    /// <summary>Z-hop over everything printed, only over extrusions below the travel move, or none.</summary>
    public ZHopType ZHopType { get; init; } = ZHopType.AbovePrint;

    /// <summary>Travel moves up to this length have no Z-hop.</summary> <value>mm.</value>
    public double ZHopMinTravel { get; init => field = SettingsKeys.ZHopMinTravel.Check(value); } = 2;

    /// <summary>Let travel moves go around printed parts if that is faster than over them.</summary>
    public bool Detour { get; init; }

    /// <summary>Keep travel moves inside the part, without retraction and Z-hop.</summary>
    public bool Comb { get; init; } = true;

    /// <summary>Travel moves up to this length have no retraction.</summary> <value>mm.</value>
    public double RetractionMinTravel { get; init => field = SettingsKeys.RetractionMinTravel.Check(value); } = 1.5;

    /// <summary>Length of the wipe back along the path during retraction; 0 = off.</summary> <value>mm.</value>
    public double WipeDistance { get; init => field = SettingsKeys.WipeDistance.Check(value); }

    /// <summary>Deretract while the head descends to the start of a path, instead of afterwards.</summary>
    public bool DeretractDuringDescent { get; init; }

    /// <summary>Length of bead extruded in place before a path starts, for materials that respond late; at most a tenth of the path.</summary>
    /// <value>mm.</value>
    public double StartDistance { get; init => field = SettingsKeys.StartDistance.Check(value); }

    /// <summary>Coasting: stop the extruder this far before the end of a path, at most a tenth of its length.</summary> <value>mm.</value>
    public double CoastingDistance { get; init => field = SettingsKeys.CoastingDistance.Check(value); }

    /// <summary>Sort sliced paths within their groups for short travel moves.</summary>
    public bool SortPaths { get; init; } = true;

    /// <summary>Speed in mm/s of paths without their own.</summary>
    public double SpeedOf(Role role, bool firstLayer = false)
        => new RoleValues(OuterWallSpeed, 0, InfillSpeed, SolidInfillSpeed, TopSurfaceSpeed, BridgeSpeed, SupportSpeed)
            .Of(role, firstLayer ? FirstLayerSpeed : 0, role == Role.Ironing && IroningSpeed > 0 ? IroningSpeed : PrintSpeed);

    public override string ToString() => Title;

    /// <summary>Diameter of the nozzle that the settings are for, mm; set by <see cref="PrintSetup"/>.</summary>
    internal double NozzleDiameter { get; init; } = UsualNozzle;

    /// <summary>The settings as given: 0 for sizes that follow from the nozzle.</summary>
    internal PrintSettings AsGiven => this with { NozzleDiameter = 0 };

    // A size is given in mm or as a negative share of the nozzle, or proportional to that.
    private double OfNozzle(double given, double ofUsual)
        => given < 0 && NozzleDiameter > 0 ? -given * NozzleDiameter : given != 0 ? given : ofUsual * (NozzleDiameter * 1000) / (UsualNozzle * 1000);
}

/// <summary>Keys of print settings: sizes, speeds, travel moves.</summary>
internal static class SettingsKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly ProfileKey<PrintSettings, string> Title = All.Text("title", s => s.Title, (s, v) => s with { Title = v });
    public static readonly NumberKey LayerHeight
        = All.NumberOrZero("layer_height_mm", 0.001, 1000, s => s.LayerHeight, (s, v) => s with { LayerHeight = v });
    public static readonly NumberKey FirstLayerHeight
        = All.NumberOrZero("first_layer_height_mm", 0.001, 1000, s => s.FirstLayerHeight, (s, v) => s with { FirstLayerHeight = v });
    public static readonly NumberKey LineWidth = All.NozzleSize("line_width_mm", s => s.LineWidth, (s, v) => s with { LineWidth = v });
    public static readonly ProfileKey<PrintSettings, BeadShape> BeadShape = All.Choice("bead_shape", s => s.BeadShape, (s, v) => s with { BeadShape = v });
    public static readonly IntegerKey WallCount = All.Integer("wall_count", 0, 10_000, s => s.WallCount, (s, v) => s with { WallCount = v });
    public static readonly NumberKey InfillDensityPercent
        = All.Number("infill_density_percent", 0, 100, s => s.InfillDensityPercent, (s, v) => s with { InfillDensityPercent = v });
    public static readonly NumberKey InfillSpacing = All.Number("infill_spacing_mm", 0, 10_000, s => s.InfillSpacing, (s, v) => s with { InfillSpacing = v });
    public static readonly NumberKey InfillAngle = All.Number("infill_angle_deg", -360, 360, s => s.InfillAngle, (s, v) => s with { InfillAngle = v });
    public static readonly NumberKey InfillOverlapPercent
        = All.Number("infill_overlap_percent", 0, 100, s => s.InfillOverlapPercent, (s, v) => s with { InfillOverlapPercent = v });
    public static readonly NumberKey Resolution
        = All.Number("resolution_mm", 0, 100, s => s.Resolution, (s, v) => s with { Resolution = v });
    public static readonly FlagKey MergeOverlappingModels
        = All.Boolean("merge_overlapping_models", s => s.MergeOverlappingModels, (s, v) => s with { MergeOverlappingModels = v });
    public static readonly ProfileKey<PrintSettings, PrintSequence> PrintSequence
        = All.Choice("print_sequence", s => s.PrintSequence, (s, v) => s with { PrintSequence = v });
    public static readonly FlagKey RepairMeshes = All.Boolean("repair_meshes", s => s.RepairMeshes, (s, v) => s with { RepairMeshes = v });
    public static readonly NumberKey SliceGapClosing
        = All.Number("slice_gap_closing_mm", 0, 1000, s => s.SliceGapClosing, (s, v) => s with { SliceGapClosing = v });
    public static readonly NumberKey MaxAreaLossPercent
        = All.Number("max_area_loss_percent", 0, 100, s => s.MaxAreaLossPercent, (s, v) => s with { MaxAreaLossPercent = v });
    public static readonly NumberKey SubdivisionDistance
        = All.Number("subdivision_distance_mm", 0.001, 10_000, s => s.SubdivisionDistance, (s, v) => s with { SubdivisionDistance = v });
    public static readonly NumberKey PrintSpeed = All.Number("print_speed_mm_s", 0.01, 10_000, s => s.PrintSpeed, (s, v) => s with { PrintSpeed = v });
    public static readonly NumberKey OuterWallSpeed
        = All.Number("outer_wall_speed_mm_s", 0, 10_000, s => s.OuterWallSpeed, (s, v) => s with { OuterWallSpeed = v });
    public static readonly NumberKey InfillSpeed = All.Number("infill_speed_mm_s", 0, 10_000, s => s.InfillSpeed, (s, v) => s with { InfillSpeed = v });
    public static readonly NumberKey FirstLayerSpeed
        = All.Number("first_layer_speed_mm_s", 0, 10_000, s => s.FirstLayerSpeed, (s, v) => s with { FirstLayerSpeed = v });
    public static readonly NumberKey TravelSpeed = All.Number("travel_speed_mm_s", 0.01, 10_000, s => s.TravelSpeed, (s, v) => s with { TravelSpeed = v });
    public static readonly ProfileKey<PrintSettings, ZHopType> ZHopType = All.Choice("z_hop_type", s => s.ZHopType, (s, v) => s with { ZHopType = v });
    public static readonly NumberKey ZHopMinTravel = All.Number("z_hop_min_travel_mm", 0, 10_000, s => s.ZHopMinTravel, (s, v) => s with { ZHopMinTravel = v });
    public static readonly FlagKey Detour = All.Boolean("travel_detours", s => s.Detour, (s, v) => s with { Detour = v });
    public static readonly FlagKey Comb = All.Boolean("avoid_crossing_walls", s => s.Comb, (s, v) => s with { Comb = v });
    public static readonly NumberKey RetractionMinTravel
        = All.Number("retraction_min_travel_mm", 0, 10_000, s => s.RetractionMinTravel, (s, v) => s with { RetractionMinTravel = v });
    public static readonly NumberKey WipeDistance = All.Number("wipe_distance_mm", 0, 1000, s => s.WipeDistance, (s, v) => s with { WipeDistance = v });
    public static readonly FlagKey DeretractDuringDescent
        = All.Boolean("deretract_during_descent", s => s.DeretractDuringDescent, (s, v) => s with { DeretractDuringDescent = v });
    public static readonly NumberKey StartDistance = All.Number("start_distance_mm", 0, 1000, s => s.StartDistance, (s, v) => s with { StartDistance = v });
    public static readonly NumberKey CoastingDistance
        = All.Number("coasting_distance_mm", 0, 1000, s => s.CoastingDistance, (s, v) => s with { CoastingDistance = v });
    public static readonly FlagKey SortPaths = All.Boolean("sort_paths", s => s.SortPaths, (s, v) => s with { SortPaths = v });
}
