namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Smoothieware.</summary>
    public static FlavorRules Smoothie { get; } = new()
    {
        Name = "smoothie",
        Title = "Smoothieware",
        OtherNames = ["smoothieware"],
        Source =
            "Smoothieware of 2023-07-31, src/modules/robot/Robot.cpp (on_gcode_received, process_move, append_arc), src/modules/tools/extruder/Extruder.cpp "
            + "(on_gcode_received), src/modules/communication/GcodeDispatch.cpp, src/modules/utils/player/Player.cpp",
        Notes = "For the 3D printer mode. In Grbl mode, P of G4 is in seconds and G28 moves to a stored position.",
        Commands = CommandsRule.InOrder,
        RelativeE = RelativeERule.LastWins,
        BareG92 = BareG92Rule.ClearShifts,
        ShiftResets = ["G92.1", "G92.2"],
        ModalMotion = ModalMotionRule.WithoutG,
        HomingKeepsShifts = true,
        InchesOfE = InchesOfERule.Unchanged,
        Workspaces = true,
        NoRetractionWith = "L",
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        DwellSums = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        Volumetric = true,
        RetractionSettings = RetractionCommands.Marlin,
        PositionOfE = PositionOfERule.PerTool,
        ModeStack = true,
        Pauses = ["M600", "M25"],
    };
}
