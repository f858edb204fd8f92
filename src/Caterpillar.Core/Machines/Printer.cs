using System;
using Caterpillar.Dialects;
using Caterpillar.Geometry;

namespace Caterpillar.Machines;

/// <summary>
/// A printer: its build volume, its limits and its style of G-code. Lengths in mm, speeds in mm/s, accelerations in mm/s². The keys of profiles are in
/// <see cref="ProfileKeys"/>; a value outside its key's range throws an <see cref="ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed partial record Printer
{
    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "generic";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = PrinterKeys.Title.Check(value); } = "Generic printer";

    /// <summary>The rules by which the firmware reads G-code.</summary>
    public DialectRules Dialect { get; init => field = value ?? throw new ArgumentNullException(nameof(value)); } = DialectTable.Marlin2;

    /// <summary>Size of the space that the nozzle can reach, mm.</summary>
    public Vec3 BuildVolume { get; init => field = PrinterKeys.BuildVolume.Check(value); } = new(220, 220, 250);

    /// <summary>Where the coordinates of the bed begin.</summary>
    public BedOrigin Origin { get; init; } = BedOrigin.Corner;

    /// <summary>Outline of the bed.</summary>
    public BedShape BedShape { get; init; } = BedShape.Rectangle;

    /// <summary>mm.</summary>
    public double NozzleDiameter { get; init => field = PrinterKeys.NozzleDiameter.Check(value); } = 0.4;

    /// <summary>Material that is used if none is given.</summary>
    public string DefaultMaterial { get; init => field = PrinterKeys.DefaultMaterial.Check(value); } = "pla";

    /// <summary>Settings that are used if none are given.</summary>
    public string DefaultSettings { get; init => field = PrinterKeys.DefaultSettings.Check(value); } = "standard";

    /// <summary>Whether E is absolute (M82) or relative (M83).</summary>
    public ExtrusionMode ExtrusionMode { get; init; } = ExtrusionMode.Relative;

    /// <summary>Whether E is a length of filament or a volume.</summary>
    public ExtrusionUnit ExtrusionUnit { get; init; } = ExtrusionUnit.Mm;

    /// <summary>X, Y and Z are written as differences (G91); E is then relative, too.</summary>
    public bool RelativeXyz { get; init; }

    /// <summary>Decimals of X, Y and Z.</summary>
    public int DecimalsXyz { get; init => field = PrinterKeys.DecimalsXyz.Check(value); } = 3;

    /// <summary>Decimals of E.</summary>
    public int DecimalsE { get; init => field = PrinterKeys.DecimalsE.Check(value); } = 5;

    /// <summary>Decimals of F (mm/min).</summary>
    public int DecimalsF { get; init => field = PrinterKeys.DecimalsF.Check(value); }

    /// <summary>Filament retracted before a travel, mm; 0 for none.</summary>
    public double RetractionDistance { get; init => field = PrinterKeys.RetractionDistance.Check(value); } = 0.8;

    /// <summary>mm/s of filament.</summary>
    public double RetractionSpeed { get; init => field = PrinterKeys.RetractionSpeed.Check(value); } = 35;

    /// <summary>Speed of restoring, mm/s of filament; 0 for <see cref="RetractionSpeed"/>.</summary>
    public double RestoreSpeed { get; init => field = PrinterKeys.RestoreSpeed.Check(value); }

    /// <summary>Extra filament when restoring, beyond what was retracted, mm.</summary>
    public double RestoreExtra { get; init => field = PrinterKeys.RestoreExtra.Check(value); }

    /// <summary>Retraction by the firmware (G10, G11), with its own distance and speed.</summary>
    public bool FirmwareRetraction { get; init; }

    /// <summary>Files say how long the print takes (<c>;TIME:</c>) and show its progress (M73), where the dialect knows them.</summary>
    public bool ProgressLines { get; init; } = true;

    /// <summary>Clearance of travels above what was printed, mm.</summary>
    public double LiftClearance { get; init => field = PrinterKeys.LiftClearance.Check(value); } = 0.4;

    /// <summary>Speed of moves straight up and down, mm/s.</summary>
    public double LiftSpeed { get; init => field = PrinterKeys.LiftSpeed.Check(value); } = 10;

    /// <summary>Maximum speed of each axis, mm/s.</summary>
    public AxisValues MaxSpeed { get; init => field = PrinterKeys.MaxSpeed.Check(value); } = new(300, 300, 12, 60);

    /// <summary>Maximum acceleration of each axis, mm/s².</summary>
    public AxisValues MaxAcceleration { get; init => field = PrinterKeys.MaxAcceleration.Check(value); } = new(1000, 1000, 100, 5000);

    /// <summary>Acceleration of printing moves, mm/s².</summary>
    public double PrintAcceleration { get; init => field = PrinterKeys.PrintAcceleration.Check(value); } = 800;

    /// <summary>Acceleration of travels, mm/s².</summary>
    public double TravelAcceleration { get; init => field = PrinterKeys.TravelAcceleration.Check(value); } = 1000;

    /// <summary>Acceleration of moves of the extruder alone, mm/s².</summary>
    public double RetractionAcceleration { get; init => field = PrinterKeys.RetractionAcceleration.Check(value); } = 1000;

    /// <summary>How the firmware limits the speed at corners.</summary>
    public CornerRule CornerRule { get; init; } = CornerRule.JunctionDeviation;

    /// <summary>For <see cref="CornerRule.Jerk"/>: sudden change of speed allowed for each axis, mm/s.</summary>
    public AxisValues Jerk { get; init => field = PrinterKeys.Jerk.Check(value); } = new(8, 8, 0.4, 5);

    /// <summary>For <see cref="CornerRule.JunctionDeviation"/>, mm.</summary>
    public double JunctionDeviation { get; init => field = PrinterKeys.JunctionDeviation.Check(value); } = 0.013;

    /// <summary>For <see cref="CornerRule.SquareCornerVelocity"/>, mm/s.</summary>
    public double SquareCornerVelocity { get; init => field = PrinterKeys.SquareCornerVelocity.Check(value); } = 5;

    /// <summary>Klipper's minimum_cruise_ratio, 0 to 1.</summary>
    public double MinimumCruiseRatio { get; init => field = PrinterKeys.MinimumCruiseRatio.Check(value); }

    /// <summary>
    /// For <see cref="CornerRule.SquareCornerVelocity"/>: jump of the speed of the extruder in corners (instantaneous_corner_velocity), mm/s.
    /// </summary>
    public double InstantaneousCornerVelocity { get; init => field = PrinterKeys.InstantaneousCornerVelocity.Check(value); } = 1;

    /// <summary>Length of the straight pieces in which the firmware goes through arcs, mm.</summary>
    public double ArcSegment { get; init => field = PrinterKeys.ArcSegment.Check(value); } = 1;

    /// <summary>How fast a nozzle heats up, °C/s; 0 where waits for heat are left out of times.</summary>
    public double NozzleHeating { get; init => field = PrinterKeys.NozzleHeating.Check(value); } = 2;

    /// <summary>How fast the bed heats up, °C/s; 0 where waits for heat are left out of times.</summary>
    public double BedHeating { get; init => field = PrinterKeys.BedHeating.Check(value); } = 0.5;

    /// <summary>Time for a change of the tool beside its moves, s.</summary>
    public double ToolChangeTime { get; init => field = PrinterKeys.ToolChangeTime.Check(value); }

    /// <summary>Time for homing, s.</summary>
    public double HomingTime { get; init => field = PrinterKeys.HomingTime.Check(value); }

    /// <summary>Moves that the firmware plans ahead; 0 for all.</summary>
    public int PlannerQueue { get; init => field = PrinterKeys.PlannerQueue.Check(value); } = 16;

    /// <summary>Offsets of the tools from the first, mm; one for each tool.</summary>
    public ValueList<Vec3> ToolOffsets { get; init => field = PrinterKeys.ToolOffsets.Check(value); } = new(Vec3.Zero);

    /// <summary>Outline of nozzle and head around their axis, from the tip outward; radius and height ascend.</summary>
    public ValueList<HeadPoint> HeadOutline { get; init => field = PrinterKeys.HeadOutline.Check(value); } = new(new HeadPoint(0.5, 0), new(4, 6), new(20, 12));

    /// <summary>Boxes around parts of the head and the gantry that are not round, relative to the tip of the nozzle, mm.</summary>
    public ValueList<Bounds> HeadBoxes { get; init => field = PrinterKeys.HeadBoxes.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Beams along X over the whole bed that carry the head, relative to the tip of the nozzle, mm; X has no meaning.</summary>
    public ValueList<Bounds> Gantry { get; init => field = PrinterKeys.Gantry.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Boxes around what stands on the bed before the print (clips), in the machine's coordinates, mm.</summary>
    public ValueList<Bounds> Clips { get; init => field = PrinterKeys.Clips.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>How serious findings of checks are, where that differs from <see cref="CheckCodes.All"/>.</summary>
    public ValueList<CheckSeverity> CheckSeverities { get; init => field = PrinterKeys.CheckSeverities.Check(value); } = ValueList<CheckSeverity>.Empty;

    /// <summary>Rectangles of the bed on which nothing may stand, in the machine's coordinates, mm.</summary>
    public ValueList<Bounds> ExcludedAreas { get; init => field = PrinterKeys.ExcludedAreas.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Material that the hot end or pump can push, mm³/s; 0 if unknown.</summary>
    public double MaxFlow { get; init => field = PrinterKeys.MaxFlow.Check(value); } = 12;

    /// <summary>Minimum nozzle temperature for extrusion, °C; 0 for materials that are not heated.</summary>
    public double MinExtrusionTemperature { get; init => field = PrinterKeys.MinExtrusionTemperature.Check(value); } = 170;

    /// <summary>Highest temperature that the hot end stands, °C; 0 for a nozzle that cannot be heated.</summary>
    public double MaxNozzleTemperature { get; init => field = PrinterKeys.MaxNozzleTemperature.Check(value); } = 300;

    /// <summary>Highest temperature of the bed, °C; 0 for a bed that cannot be heated.</summary>
    public double MaxBedTemperature { get; init => field = PrinterKeys.MaxBedTemperature.Check(value); } = 120;

    /// <summary>Most material that may be pushed out, or pulled back, while the head stands still, mm³.</summary>
    public double MaxStationaryVolume { get; init => field = PrinterKeys.MaxStationaryVolume.Check(value); } = 500;

    /// <summary>Lines before the print.</summary>
    public ValueList<string> StartTemplate { get; init => field = PrinterKeys.StartTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Lines after the print.</summary>
    public ValueList<string> EndTemplate { get; init => field = PrinterKeys.EndTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Lines before each layer except the first.</summary>
    public ValueList<string> LayerTemplate { get; init => field = PrinterKeys.LayerTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Lines for a tool change; without them the writer emits only the tool number.</summary>
    public ValueList<string> ToolChangeTemplate { get; init => field = PrinterKeys.ToolChangeTemplate.Check(value); } = ValueList<string>.Empty;

    /// <summary>Number of tools.</summary>
    public int ToolCount => ToolOffsets.Count;

    /// <summary>The box that the nozzle can reach, in the machine's coordinates.</summary>
    public Bounds BuildBounds
    {
        get
        {
            var min = Origin == BedOrigin.Corner ? Vec3.Zero : new Vec3(-BuildVolume.X / 2, -BuildVolume.Y / 2, 0);
            return new Bounds(min, min + BuildVolume);
        }
    }

    /// <summary>True if the nozzle can reach it, within <paramref name="tolerance"/> mm.</summary>
    public bool CanReach(Vec3 point, double tolerance = 0)
    {
        var bounds = BuildBounds;
        if (!bounds.Contains(point, tolerance)) return false;
        if (BedShape == BedShape.Rectangle) return true;
        var center = bounds.Center;
        var x = (point.X - center.X) / (BuildVolume.X / 2 + tolerance);
        var y = (point.Y - center.Y) / (BuildVolume.Y / 2 + tolerance);
        return x * x + y * y <= 1;
    }

    public override string ToString() => Title;
}
