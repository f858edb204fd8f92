using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>The keys of print settings.</summary>
internal static class SettingsKeys
{
    public static readonly ProfileKey<PrintSettings, string> Title = K.Text(
        "title", s => s.Title, (s, v) => s with { Title = v }, "Display name.");

    public static readonly ProfileKey<PrintSettings, double> LayerHeight = K.Number(
        "layer_height_mm", 0.001, 1000, s => s.LayerHeight, (s, v) => s with { LayerHeight = v }, "Height of a layer.");

    public static readonly ProfileKey<PrintSettings, double> FirstLayerHeight = K.Number(
        "first_layer_height_mm", 0.001, 1000, s => s.FirstLayerHeight, (s, v) => s with { FirstLayerHeight = v },
        "Height of the layer on the bed.");

    public static readonly ProfileKey<PrintSettings, double> LineWidth = K.Number(
        "line_width_mm", 0.001, 1000, s => s.LineWidth, (s, v) => s with { LineWidth = v }, "Width of a strand.");

    public static readonly ProfileKey<PrintSettings, Toolpaths.BeadShape> BeadShape = K.Choice(
        "bead_shape", s => s.BeadShape, (s, v) => s with { BeadShape = v }, "Shape of the cross-section, which relates area and width of a strand.",
        ("rectangle", Toolpaths.BeadShape.Rectangle), ("stadium", Toolpaths.BeadShape.Stadium), ("circle", Toolpaths.BeadShape.Circle));

    public static readonly ProfileKey<PrintSettings, int> WallCount = K.Integer(
        "wall_count", 0, 10_000, s => s.WallCount, (s, v) => s with { WallCount = v }, "Number of walls around each region.");

    public static readonly ProfileKey<PrintSettings, double> InfillPercent = K.Number(
        "infill_percent", 0, 100, s => s.InfillPercent, (s, v) => s with { InfillPercent = v },
        "Share of the inside that is filled; ignored if infill_spacing_mm is given.");

    public static readonly ProfileKey<PrintSettings, double> InfillSpacing = K.Number(
        "infill_spacing_mm", 0, 10_000, s => s.InfillSpacing, (s, v) => s with { InfillSpacing = v },
        "Distance between the lines of the infill; 0 to take it from infill_percent.");

    public static readonly ProfileKey<PrintSettings, double> InfillAngle = K.Number(
        "infill_angle_deg", -360, 360, s => s.InfillAngle, (s, v) => s with { InfillAngle = v },
        "Direction of the infill in the first layer, from +X.");

    public static readonly ProfileKey<PrintSettings, double> InfillOverlapPercent = K.Number(
        "infill_overlap_percent", 0, 100, s => s.InfillOverlapPercent, (s, v) => s with { InfillOverlapPercent = v },
        "Overlap of the infill with the innermost wall, % of the line width; lines of closed areas overlap by two thirds of it.");

    public static readonly ProfileKey<PrintSettings, double> SimplifyTolerance = K.Number(
        "simplify_tolerance_mm", 0, 100, s => s.SimplifyTolerance, (s, v) => s with { SimplifyTolerance = v },
        "Maximum deviation of simplified contours.");

    public static readonly ProfileKey<PrintSettings, bool> MergeOverlapping = K.Boolean(
        "merge_overlapping", s => s.MergeOverlapping, (s, v) => s with { MergeOverlapping = v },
        "Models that run through each other are printed as one solid; without it the place where they overlap is printed twice.");

    public static readonly ProfileKey<PrintSettings, PrintSequence> PrintSequence = K.Choice(
        "print_sequence", s => s.PrintSequence, (s, v) => s with { PrintSequence = v },
        "Several models are printed layer by layer, or one after the other, the lowest first.",
        ("by_layer", Machines.PrintSequence.ByLayer), ("by_object", Machines.PrintSequence.ByObject));

    public static readonly ProfileKey<PrintSettings, bool> MendMeshes = K.Boolean(
        "mend_meshes", s => s.MendMeshes, (s, v) => s with { MendMeshes = v },
        "Meshes that are not closed are made solid before they are sliced: rims joined, holes filled, triangles and bodies turned outwards.");

    public static readonly ProfileKey<PrintSettings, double> LargestGap = K.Number(
        "largest_gap_mm", 0, 1000, s => s.LargestGap, (s, v) => s with { LargestGap = v },
        "Gaps in the contours of broken meshes are closed up to this width; 0 closes none.");

    public static readonly ProfileKey<PrintSettings, double> MaxAreaLossPercent = K.Number(
        "max_area_loss_percent", 0, 100, s => s.MaxAreaLossPercent, (s, v) => s with { MaxAreaLossPercent = v },
        "A layer of a broken mesh that loses more than this of the area of its neighbors is an error; 100 allows any loss.");

    public static readonly ProfileKey<PrintSettings, double> SubdivisionDistance = K.Number(
        "subdivision_distance_mm", 0.001, 10_000, s => s.SubdivisionDistance, (s, v) => s with { SubdivisionDistance = v },
        "Length of the pieces of subdivided curves.");

    public static readonly ProfileKey<PrintSettings, double> PrintSpeed = K.Number(
        "print_speed_mm_s", 0.01, 10_000, s => s.PrintSpeed, (s, v) => s with { PrintSpeed = v }, "Speed of printing moves.");

    public static readonly ProfileKey<PrintSettings, double> OuterWallSpeed = K.Number(
        "outer_wall_speed_mm_s", 0, 10_000, s => s.OuterWallSpeed, (s, v) => s with { OuterWallSpeed = v },
        "Speed of outer walls; 0 for the print speed.");

    public static readonly ProfileKey<PrintSettings, double> InfillSpeed = K.Number(
        "infill_speed_mm_s", 0, 10_000, s => s.InfillSpeed, (s, v) => s with { InfillSpeed = v },
        "Speed of infill; 0 for the print speed.");

    public static readonly ProfileKey<PrintSettings, double> FirstLayerSpeed = K.Number(
        "first_layer_speed_mm_s", 0, 10_000, s => s.FirstLayerSpeed, (s, v) => s with { FirstLayerSpeed = v },
        "Maximum print speed in the first layer; 0 for no limit.");

    public static readonly ProfileKey<PrintSettings, double> TravelSpeed = K.Number(
        "travel_speed_mm_s", 0.01, 10_000, s => s.TravelSpeed, (s, v) => s with { TravelSpeed = v }, "Speed of travel moves.");

    public static readonly ProfileKey<PrintSettings, TravelLift> TravelLift = K.Choice(
        "travel_lift", s => s.TravelLift, (s, v) => s with { TravelLift = v },
        "Lift for travels: above everything printed, above what lies under the path of the travel, or none.",
        ("printed_top", Machines.TravelLift.PrintedTop), ("corridor", Machines.TravelLift.Corridor), ("none", Machines.TravelLift.None));

    public static readonly ProfileKey<PrintSettings, double> LiftMinTravel = K.Number(
        "lift_min_travel_mm", 0, 10_000, s => s.LiftMinTravel, (s, v) => s with { LiftMinTravel = v },
        "Travels up to this length are made without a lift.");

    public static readonly ProfileKey<PrintSettings, bool> Detour = K.Boolean(
        "detour", s => s.Detour, (s, v) => s with { Detour = v }, "Travels go around printed parts if that is faster than over them.");

    public static readonly ProfileKey<PrintSettings, bool> Comb = K.Boolean(
        "comb", s => s.Comb, (s, v) => s with { Comb = v }, "Travels within a layer that stay inside the part are made without lift and retraction.");

    public static readonly ProfileKey<PrintSettings, double> RetractionMinTravel = K.Number(
        "retraction_min_travel_mm", 0, 10_000, s => s.RetractionMinTravel, (s, v) => s with { RetractionMinTravel = v },
        "Travels up to this length are made without a retraction.");

    public static readonly ProfileKey<PrintSettings, double> WipeDistance = K.Number(
        "wipe_distance_mm", 0, 1000, s => s.WipeDistance, (s, v) => s with { WipeDistance = v },
        "Distance back along the path during which filament is retracted; 0 for none.");

    public static readonly ProfileKey<PrintSettings, bool> RestoreDuringDescent = K.Boolean(
        "restore_during_descent", s => s.RestoreDuringDescent, (s, v) => s with { RestoreDuringDescent = v },
        "Retracted filament is restored while the head descends to a path, not afterwards.");

    public static readonly ProfileKey<PrintSettings, double> StartDistance = K.Number(
        "start_distance_mm", 0, 1000, s => s.StartDistance, (s, v) => s with { StartDistance = v },
        "Length of bead extruded in place before a path starts, for materials with a delayed response.");

    public static readonly ProfileKey<PrintSettings, double> StopDistance = K.Number(
        "stop_distance_mm", 0, 1000, s => s.StopDistance, (s, v) => s with { StopDistance = v },
        "The extruder stops this far before the end of a path (coasting).");

    public static readonly ProfileKey<PrintSettings, bool> SortPaths = K.Boolean(
        "sort_paths", s => s.SortPaths, (s, v) => s with { SortPaths = v },
        "Sliced paths are sorted inside their groups, for short travels.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        Title, LayerHeight, FirstLayerHeight, LineWidth, BeadShape, WallCount, InfillPercent, InfillSpacing, InfillAngle,
        InfillOverlapPercent, SimplifyTolerance, MergeOverlapping, PrintSequence, MendMeshes, LargestGap, MaxAreaLossPercent, SubdivisionDistance,
        PrintSpeed, OuterWallSpeed, InfillSpeed, FirstLayerSpeed, TravelSpeed, TravelLift, LiftMinTravel, Detour, Comb, RetractionMinTravel,
        WipeDistance, RestoreDuringDescent,
        StartDistance, StopDistance, SortPaths,
        ..WallWidthKeys.All, ..LayerKeys.All, ..SkinKeys.All, ..InfillKeys.All, ..BedKeys.All, ..SurfaceKeys.All, ..SeamKeys.All, ..TravelKeys.All,
        ..CurvedKeys.All, ..SupportKeys.All,
    ];
}
