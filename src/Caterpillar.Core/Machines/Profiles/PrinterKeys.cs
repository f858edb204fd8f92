using System.Collections.Generic;
using System.Linq;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.Printer>;

namespace Caterpillar.Machines;

/// <summary>The keys of printers.</summary>
internal static class PrinterKeys
{
    public static readonly ProfileKey<Printer, string> Title = K.Text(
        "title", p => p.Title, (p, v) => p with { Title = v }, "Display name.");

    public static readonly ProfileKey<Printer, DialectRules> Dialect = K.Choice(
        "dialect", p => p.Dialect, (p, v) => p with { Dialect = v },
        "Rules by which the firmware reads G-code.", DialectTable.All.Select(d => (d.Name, d)).ToArray());

    public static readonly ProfileKey<Printer, Vec3> BuildVolume = K.Vector(
        "build_volume_mm", 1, 100_000, p => p.BuildVolume, (p, v) => p with { BuildVolume = v },
        "Size of the space that the nozzle can reach.");

    public static readonly ProfileKey<Printer, BedOrigin> Origin = K.Choice(
        "origin", p => p.Origin, (p, v) => p with { Origin = v },
        "Position of X 0, Y 0 on the bed.", ("corner", BedOrigin.Corner), ("center", BedOrigin.Center));

    public static readonly ProfileKey<Printer, BedShape> BedShape = K.Choice(
        "bed_shape", p => p.BedShape, (p, v) => p with { BedShape = v },
        "Outline of the bed.", ("rectangle", Machines.BedShape.Rectangle), ("round", Machines.BedShape.Round));

    public static readonly ProfileKey<Printer, double> NozzleDiameter = K.Number(
        "nozzle_diameter_mm", 0.01, 200, p => p.NozzleDiameter, (p, v) => p with { NozzleDiameter = v },
        "Diameter of the nozzle, or width of the pen.");

    public static readonly ProfileKey<Printer, string> DefaultMaterial = K.Text(
        "default_material", p => p.DefaultMaterial, (p, v) => p with { DefaultMaterial = v },
        "Material that is used if none is given.");

    public static readonly ProfileKey<Printer, string> DefaultSettings = K.Text(
        "default_settings", p => p.DefaultSettings, (p, v) => p with { DefaultSettings = v },
        "Settings that are used if none are given.");

    public static readonly ProfileKey<Printer, ExtrusionMode> ExtrusionMode = K.Choice(
        "e_mode", p => p.ExtrusionMode, (p, v) => p with { ExtrusionMode = v }, "How E is written: relative (M83) or absolute (M82).",
        ("relative", Machines.ExtrusionMode.Relative), ("absolute", Machines.ExtrusionMode.Absolute));

    public static readonly ProfileKey<Printer, ExtrusionUnit> ExtrusionUnit = K.Choice(
        "e_unit", p => p.ExtrusionUnit, (p, v) => p with { ExtrusionUnit = v },
        "Unit of E: mm of filament or of plunger travel, mm³, or none for pens.",
        ("mm", Machines.ExtrusionUnit.Mm), ("mm3", Machines.ExtrusionUnit.Mm3), ("none", Machines.ExtrusionUnit.None));

    public static readonly ProfileKey<Printer, bool> RelativeXyz = K.Boolean(
        "relative_xyz", p => p.RelativeXyz, (p, v) => p with { RelativeXyz = v },
        "X, Y and Z are written as differences (G91) of the rounded positions; E is then relative.");

    public static readonly ProfileKey<Printer, int> DecimalsXyz = K.Integer(
        "decimals_xyz", 0, 8, p => p.DecimalsXyz, (p, v) => p with { DecimalsXyz = v }, "Decimals of X, Y and Z.");

    public static readonly ProfileKey<Printer, int> DecimalsE = K.Integer(
        "decimals_e", 0, 8, p => p.DecimalsE, (p, v) => p with { DecimalsE = v }, "Decimals of E.");

    public static readonly ProfileKey<Printer, int> DecimalsF = K.Integer(
        "decimals_f", 0, 8, p => p.DecimalsF, (p, v) => p with { DecimalsF = v }, "Decimals of F, which is in mm/min.");

    public static readonly ProfileKey<Printer, double> RetractionDistance = K.Number(
        "retraction_distance_mm", 0, 1000, p => p.RetractionDistance, (p, v) => p with { RetractionDistance = v },
        "Filament retracted before a travel; 0 for none.");

    public static readonly ProfileKey<Printer, double> RetractionSpeed = K.Number(
        "retraction_speed_mm_s", 0.01, 10_000, p => p.RetractionSpeed, (p, v) => p with { RetractionSpeed = v },
        "Speed of retraction, of the filament.");

    public static readonly ProfileKey<Printer, double> RestoreSpeed = K.Number(
        "restore_speed_mm_s", 0, 10_000, p => p.RestoreSpeed, (p, v) => p with { RestoreSpeed = v },
        "Speed of restoring, of the filament; 0 for the retraction speed.");

    public static readonly ProfileKey<Printer, double> RestoreExtra = K.Number(
        "restore_extra_mm", 0, 1000, p => p.RestoreExtra, (p, v) => p with { RestoreExtra = v },
        "Extra filament when restoring, beyond what was retracted.");

    public static readonly ProfileKey<Printer, bool> FirmwareRetraction = K.Boolean(
        "firmware_retraction", p => p.FirmwareRetraction, (p, v) => p with { FirmwareRetraction = v },
        "Retraction by the firmware (G10, G11), with its own distance and speed.");

    public static readonly ProfileKey<Printer, bool> ProgressLines = K.Boolean(
        "progress_lines", p => p.ProgressLines, (p, v) => p with { ProgressLines = v },
        "Files state the print time (;TIME) and the progress (M73), if the dialect knows it.");

    public static readonly ProfileKey<Printer, double> LiftClearance = K.Number(
        "lift_clearance_mm", 0, 1000, p => p.LiftClearance, (p, v) => p with { LiftClearance = v },
        "Clearance of travels above what was printed.");

    public static readonly ProfileKey<Printer, double> LiftSpeed = K.Number(
        "lift_speed_mm_s", 0.01, 10_000, p => p.LiftSpeed, (p, v) => p with { LiftSpeed = v }, "Speed of moves straight up and down.");

    public static readonly ProfileKey<Printer, AxisValues> MaxSpeed = K.Axes(
        "max_speed_mm_s", 0.01, 100_000, p => p.MaxSpeed, (p, v) => p with { MaxSpeed = v }, "Maximum speed of each axis.");

    public static readonly ProfileKey<Printer, AxisValues> MaxAcceleration = K.Axes(
        "max_acceleration_mm_s2", 0.01, 1_000_000, p => p.MaxAcceleration, (p, v) => p with { MaxAcceleration = v },
        "Maximum acceleration of each axis.");

    public static readonly ProfileKey<Printer, double> PrintAcceleration = K.Number(
        "print_acceleration_mm_s2", 0.01, 1_000_000, p => p.PrintAcceleration, (p, v) => p with { PrintAcceleration = v },
        "Acceleration of printing moves.");

    public static readonly ProfileKey<Printer, double> TravelAcceleration = K.Number(
        "travel_acceleration_mm_s2", 0.01, 1_000_000, p => p.TravelAcceleration, (p, v) => p with { TravelAcceleration = v },
        "Acceleration of travels.");

    public static readonly ProfileKey<Printer, double> RetractionAcceleration = K.Number(
        "retraction_acceleration_mm_s2", 0.01, 1_000_000, p => p.RetractionAcceleration, (p, v) => p with { RetractionAcceleration = v },
        "Acceleration of moves of the extruder alone.");

    public static readonly ProfileKey<Printer, CornerRule> CornerRule = K.Choice(
        "corner_rule", p => p.CornerRule, (p, v) => p with { CornerRule = v }, "How the firmware limits the speed in corners.",
        ("jerk", Machines.CornerRule.Jerk), ("junction_deviation", Machines.CornerRule.JunctionDeviation),
            ("square_corner_velocity", Machines.CornerRule.SquareCornerVelocity));

    public static readonly ProfileKey<Printer, AxisValues> Jerk = K.Axes(
        "jerk_mm_s", 0, 10_000, p => p.Jerk, (p, v) => p with { Jerk = v },
        "Sudden change of speed allowed for each axis, for corner_rule jerk.");

    public static readonly ProfileKey<Printer, double> JunctionDeviation = K.Number(
        "junction_deviation_mm", 0.0001, 10, p => p.JunctionDeviation, (p, v) => p with { JunctionDeviation = v },
        "For corner_rule junction_deviation.");

    public static readonly ProfileKey<Printer, double> SquareCornerVelocity = K.Number(
        "square_corner_velocity_mm_s", 0, 10_000, p => p.SquareCornerVelocity, (p, v) => p with { SquareCornerVelocity = v },
        "For corner_rule square_corner_velocity.");

    public static readonly ProfileKey<Printer, double> MinimumCruiseRatio = K.Number(
        "minimum_cruise_ratio", 0, 0.99, p => p.MinimumCruiseRatio, (p, v) => p with { MinimumCruiseRatio = v },
        "Klipper's minimum share of a move at constant speed.");

    public static readonly ProfileKey<Printer, double> InstantaneousCornerVelocity = K.Number(
        "instantaneous_corner_velocity_mm_s", 0.001, 10_000, p => p.InstantaneousCornerVelocity, (p, v) => p with { InstantaneousCornerVelocity = v },
        "For corner_rule square_corner_velocity: jump of the speed of the extruder.");

    public static readonly ProfileKey<Printer, double> ArcSegment = K.Number(
        "arc_segment_mm", 0.01, 1000, p => p.ArcSegment, (p, v) => p with { ArcSegment = v },
        "Length of the straight pieces in which the firmware goes through arcs.");

    public static readonly ProfileKey<Printer, double> NozzleHeating = K.Number(
        "nozzle_heating_c_s", 0, 1000, p => p.NozzleHeating, (p, v) => p with { NozzleHeating = v },
        "Degrees per second by which a nozzle heats up; 0 leaves waits for heat out of times.");

    public static readonly ProfileKey<Printer, double> BedHeating = K.Number(
        "bed_heating_c_s", 0, 1000, p => p.BedHeating, (p, v) => p with { BedHeating = v },
        "Degrees per second by which the bed heats up; 0 leaves waits for heat out of times.");

    public static readonly ProfileKey<Printer, double> ToolChangeTime = K.Number(
        "tool_change_time_s", 0, 10_000, p => p.ToolChangeTime, (p, v) => p with { ToolChangeTime = v },
        "Time for a change of the tool beside its moves.");

    public static readonly ProfileKey<Printer, double> HomingTime = K.Number(
        "homing_time_s", 0, 10_000, p => p.HomingTime, (p, v) => p with { HomingTime = v }, "Time for homing.");

    public static readonly ProfileKey<Printer, int> PlannerQueue = K.Integer(
        "planner_queue_moves", 0, 1_000_000, p => p.PlannerQueue, (p, v) => p with { PlannerQueue = v },
        "Moves that the firmware plans ahead; 0 for all.");

    public static readonly ProfileKey<Printer, ValueList<Vec3>> ToolOffsets = new(
        "tool_offsets_mm", new RowsFormat<Vec3>(["x", "y", "z"], 1, 64, -10_000, 10_000, n => new Vec3(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]),
        p => p.ToolOffsets, (p, v) => p with { ToolOffsets = v }, "Offsets of the tools from the first; one for each tool.");

    public static readonly ProfileKey<Printer, ValueList<HeadPoint>> HeadOutline = new(
        "head_outline_mm", new RowsFormat<HeadPoint>(["radius", "height"], 1, 64, 0, 10_000, n => new HeadPoint(n[0], n[1]), h => [h.Radius, h.Height],
            Ascends),
        p => p.HeadOutline, (p, v) => p with { HeadOutline = v }, "Outline of nozzle and head around their axis, from the tip outward.");

    public static readonly ProfileKey<Printer, ValueList<Bounds>> HeadBoxes = new(
        "head_boxes_mm", new RowsFormat<Bounds>(["min x", "min y", "min z", "max x", "max y", "max z"], 0, 64, -10_000, 10_000, MakeBox, TakeBox),
        p => p.HeadBoxes, (p, v) => p with { HeadBoxes = v },
        "Boxes around parts of head and gantry that are not round, relative to the tip of the nozzle.");

    public static readonly ProfileKey<Printer, ValueList<Bounds>> Gantry = new(
        "gantry_mm", new RowsFormat<Bounds>(["min y", "min z", "max y", "max z"], 0, 64, -10_000, 10_000,
            n => n[0] <= n[2] && n[1] <= n[3] ? new Bounds(new Vec3(0, n[0], n[1]), new Vec3(0, n[2], n[3])) : null,
            b => [b.Min.Y, b.Min.Z, b.Max.Y, b.Max.Z]),
        p => p.Gantry, (p, v) => p with { Gantry = v },
        "Beams along X over the whole bed that carry the head, relative to the tip of the nozzle.");

    public static readonly ProfileKey<Printer, ValueList<Bounds>> Clips = new(
        "clips_mm", new RowsFormat<Bounds>(["min x", "min y", "min z", "max x", "max y", "max z"], 0, 64, -100_000, 100_000, MakeBox, TakeBox),
        p => p.Clips, (p, v) => p with { Clips = v },
        "Boxes around what stands on the bed before the print, for example clips, in the machine's coordinates.");

    public static readonly ProfileKey<Printer, ValueList<CheckSeverity>> CheckSeverities = new(
        "check_severities", new SeverityFormat(), p => p.CheckSeverities, (p, v) => p with { CheckSeverities = v },
        "How serious the findings of checks are on this printer, where that differs from the usual; errors refuse the file.");

    public static readonly ProfileKey<Printer, ValueList<Bounds>> ExcludedAreas = new(
        "excluded_areas_mm", new RowsFormat<Bounds>(["min x", "min y", "max x", "max y"], 0, 64, -100_000, 100_000,
            n => Bounds.Of([new Vec3(n[0], n[1]), new Vec3(n[2], n[3])]), b => [b.Min.X, b.Min.Y, b.Max.X, b.Max.Y]),
        p => p.ExcludedAreas, (p, v) => p with { ExcludedAreas = v },
        "Rectangles of the bed on which nothing may stand, for example where clips hold the plate.");

    public static readonly ProfileKey<Printer, double> MaxFlow = K.Number(
        "max_flow_mm3_s", 0, 1_000_000, p => p.MaxFlow, (p, v) => p with { MaxFlow = v },
        "Material that the hot end or pump can push; 0 if unknown.");

    public static readonly ProfileKey<Printer, double> MinExtrusionTemperature = K.Number(
        "min_extrusion_temperature_c", 0, 2000, p => p.MinExtrusionTemperature, (p, v) => p with { MinExtrusionTemperature = v },
        "Minimum nozzle temperature for extrusion; 0 for materials that are not heated.");

    public static readonly ProfileKey<Printer, double> MaxNozzleTemperature = K.Number(
        "max_nozzle_temperature_c", 0, 2000, p => p.MaxNozzleTemperature, (p, v) => p with { MaxNozzleTemperature = v },
        "Highest temperature that the hot end stands; 0 for a nozzle that cannot be heated.");

    public static readonly ProfileKey<Printer, double> MaxBedTemperature = K.Number(
        "max_bed_temperature_c", 0, 500, p => p.MaxBedTemperature, (p, v) => p with { MaxBedTemperature = v },
        "Highest temperature of the bed; 0 for a bed that cannot be heated.");

    public static readonly ProfileKey<Printer, double> MaxStationaryVolume = K.Number(
        "max_stationary_volume_mm3", 0, 1e9, p => p.MaxStationaryVolume, (p, v) => p with { MaxStationaryVolume = v },
        "Most material that may be pushed out, or pulled back, while the head stands still.");

    public static readonly ProfileKey<Printer, ValueList<string>> StartTemplate = K.Lines(
        "start_template", p => p.StartTemplate, (p, v) => p with { StartTemplate = v }, "Lines before the print.");

    public static readonly ProfileKey<Printer, ValueList<string>> EndTemplate = K.Lines(
        "end_template", p => p.EndTemplate, (p, v) => p with { EndTemplate = v }, "Lines after the print.");

    public static readonly ProfileKey<Printer, ValueList<string>> LayerTemplate = K.Lines(
        "layer_template", p => p.LayerTemplate, (p, v) => p with { LayerTemplate = v }, "Lines before each layer except the first.");

    public static readonly ProfileKey<Printer, ValueList<string>> ToolChangeTemplate = K.Lines(
        "tool_change_template", p => p.ToolChangeTemplate, (p, v) => p with { ToolChangeTemplate = v },
        "Lines for a tool change; without them only the tool number (T1).");

    public static readonly IReadOnlyList<ProfileKey<Printer>> All =
    [
        Title, Dialect, BuildVolume, Origin, BedShape, NozzleDiameter, DefaultMaterial, DefaultSettings, ExtrusionMode, ExtrusionUnit,
        RelativeXyz, DecimalsXyz, DecimalsE, DecimalsF,
        RetractionDistance, RetractionSpeed, RestoreSpeed, RestoreExtra, FirmwareRetraction, ProgressLines, LiftClearance, LiftSpeed, MaxSpeed,
        MaxAcceleration, PrintAcceleration,
        TravelAcceleration, RetractionAcceleration, CornerRule, Jerk, JunctionDeviation, SquareCornerVelocity, MinimumCruiseRatio,
        InstantaneousCornerVelocity, PlannerQueue, ArcSegment, NozzleHeating, BedHeating, ToolChangeTime, HomingTime, ToolOffsets, HeadOutline, HeadBoxes,
        Gantry, Clips, ExcludedAreas, CheckSeverities,
        MaxFlow, MinExtrusionTemperature, MaxNozzleTemperature, MaxBedTemperature, MaxStationaryVolume, StartTemplate, EndTemplate, LayerTemplate,
            ToolChangeTemplate, .. PauseKeys.All,
    ];

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
