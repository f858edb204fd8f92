namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Marlin 1.</summary>
    public static FlavorRules Marlin1 { get; } = new()
    {
        Name = "marlin1",
        Title = "Marlin 1",
        Limits = LimitCommands.Marlin,
        OtherNames = ["marlinlegacy", "reprap", "reprapreprap", "reprapsprinter", "teacup", "sprinter", "griffin"],
        Source = "Marlin 1.1, Marlin/Marlin_main.cpp: gcode_get_destination, gcode_G2_G3, gcode_G4, gcode_G92, gcode_M200, gcode_M220, gcode_M221, tool_change",
        Notes =
            "G10 and G11, G17 to G19, G20, G92.1 and P of arcs, workspaces (G54 to G59), saved positions (G60, G61), splines (G5) and babysteps (M290 in Z) "
            + "are build options, assumed to be enabled. Motion without G is an option too, assumed to be disabled.",
        ShiftResets = ["G92.1"],
        HomingSelectsXy = true,
        InchesOfE = InchesOfERule.InchesOrCubic,
        ArcTurns = ArcTurnsRule.CirclesFirst,
        RadiusInXyOnly = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        FlowToolLetter = "T",
        Volumetric = true,
        Splines = true,
        Workspaces = true,
        WorkspacesByG92 = true,
        SavedPositions = true,
        HomeOffset = HomeOffsetRule.AtOnce,
        LargestBabystep = 2,
        RetractionSettings = RetractionCommands.Marlin,
        RetractionLifts = true,
        Pauses = ["M0", "M1", "M25", "M125", "M600"],
        ObjectMarks = ObjectMarking.Numbers,
    };

    /// <summary>Marlin 2.</summary>
    public static FlavorRules Marlin2 { get; } = Marlin1 with
    {
        Name = "marlin2",
        Title = "Marlin 2",
        Progress = ProgressCommand.PercentAndMinutes,
        OtherNames = ["marlin", "reprapmarlinsprinter"],
        SeparateAccelerations = true,
        Source =
            "Marlin 2.1, Marlin/src/gcode: gcode.cpp (get_destination_from_command, process_parsed_command), gcode.h (set_relative_mode, "
            + "axis_is_relative), parser.h (axis_unit_factor), motion/G2_G3.cpp (G2_G3, plan_arc), motion/G4.cpp, motion/G5.cpp, motion/M290.cpp, "
            + "geometry/G92.cpp, geometry/G53-G59.cpp, geometry/M206_M428.cpp, feature/pause/G60.cpp and G61.cpp, config/M220.cpp, config/M221.cpp, "
            + "config/M200-M205.cpp; Marlin/src/feature/fwretract.cpp",
        RelativeE = RelativeERule.LastWins,
        ArcTurns = ArcTurnsRule.Added,
        SpeedMemory = SpeedMemoryRule.RestoresFirst,
    };

    /// <summary>Prusa-Firmware.</summary>
    public static FlavorRules Prusa { get; } = Marlin1 with
    {
        Name = "prusa",
        Title = "Prusa-Firmware",
        Progress = ProgressCommand.PercentAndMinutes,
        OtherNames = ["mk3", "prusafirmware"],
        Source =
            "Prusa-Firmware of 2024-03-28 (MK3), Firmware/Marlin_main.cpp: get_coordinates, process_commands (G2, G3, G4, G21, G90, G91, M82, M83, "
            + "M200, M206 to M208, M220, M221, M600, M601), retract, gcode_G28, gcode_G92; Firmware/motion_control.cpp: mc_arc",
        Notes = "8-bit printers up to the MK3. The MK4, XL and Mini run Marlin 2.",
        RelativeE = RelativeERule.OnlyM82M83,
        ShiftResets = [],
        HomingSelectsXy = false,
        HomesToNumber = true,
        Inches = false,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        ArcTurns = ArcTurnsRule.Ignored,
        Planes = false,
        SpeedMemory = SpeedMemoryRule.RestoresLast,
        FlowFactor = FlowFactorRule.AllTools,
        FlowToolLetter = "",
        Splines = false,
        Workspaces = false,
        WorkspacesByG92 = false,
        SavedPositions = false,
        HomeOffset = HomeOffsetRule.AtHoming,
        LargestBabystep = 0,
        Pauses = ["M601", "M0", "M1", "M25", "M125", "M600"],
        ObjectMarks = ObjectMarking.None,
    };
}
