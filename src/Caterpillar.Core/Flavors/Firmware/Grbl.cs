namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Grbl, for pens and lasers.</summary>
    public static FlavorRules Grbl { get; } = new()
    {
        Name = "grbl",
        Title = "Grbl",
        Source = "Grbl 1.1h, grbl/gcode.c (gc_execute_line), grbl/gcode.h, grbl/motion_control.c (mc_arc, mc_dwell)",
        Notes =
            "A line with an unknown letter (E, A), or with words that its commands do not use, is refused. T is stored only, without a tool "
            + "change. M1 does nothing.",
        Letters = "ABCFGIJKLMNPRSTXYZ", // A B C: of builds with turning axes.
        Commands = CommandsRule.All,
        RelativeE = RelativeERule.OnlyG90G91,
        ShiftResets = ["G92.1"],
        ModalMotion = ModalMotionRule.Standard,
        Homing = HomingRule.GoesToStoredPosition,
        HomingCommands = ["G28", "G30"],
        Workspaces = true,
        FirmwareRetraction = false,
        ShortRadius = 0,
        RadiusAndCenter = RadiusAndCenterRule.Refused,
        ArcTurns = ArcTurnsRule.Refused,
        ArcNamesEnd = true,
        ArcTolerance = new ArcTolerance(0.005, 0.5, 0.001),
        DwellP = 1,
        DwellS = 0,
        ToolLimit = 0,
        Fan = FanScale.None,
        ExtruderLetters = "",
        PrintsWithoutE = true,
        Pauses = ["M0"],
        StatesHeight = null,
    };
}
