namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Sailfish and MakerWare.</summary>
    public static FlavorRules Sailfish { get; } = new()
    {
        Name = "sailfish",
        Title = "Sailfish, MakerWare",
        Progress = ProgressCommand.Percent,
        OtherNames = ["makerware", "makerbot"],
        Source =
            "GPX of 2020-11-26, src/gpx/gpx.c (gpx_convert_line, calculate_target_position, queue_ext_point, do_tool_change), which translates G-code "
            + "to the s3g commands that Sailfish executes",
        Notes =
            "The printer itself does not read G-code: GPX or MakerWare (closed source) translates it. The position after homing is "
            + "stored in the printer and assumed to be 0.",
        Commands = CommandsRule.Last,
        ModalMotion = ModalMotionRule.WithoutG,
        HomingCommands = ["G28", "G161", "G162"],
        Inches = false,
        Arcs = false,
        FirmwareRetraction = false,
        DwellS = 0,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        FlowToolLetter = "T",
        PositionOfE = PositionOfERule.PerTool,
        ToolCommands = ["M6 T", "M108 T", "M135 T"],
        Fan = FanScale.Switch,
        ValveIsFan = true,
        ExtruderLetters = "EAB",
        SwitchedExtruder = true,
        Pauses = ["M1", "M25", "M71"],
        StatesHeight = null,
    };
}
