namespace Caterpillar.Flavors;

/// <summary>Prusa-Firmware.</summary>
internal static class Prusa
{
    public static FlavorRules Rules { get; } = Marlin1.Rules with
    {
        Name = "prusa",
        Title = "Prusa-Firmware",
        Progress = ProgressCommand.PercentAndMinutes,
        OtherNames = ["mk3", "prusafirmware"],
        Source =
            "Prusa-Firmware of 2024-03-28 (MK3), Firmware/Marlin_main.cpp: get_coordinates, process_commands (G2, G3, G4, G21, G90, G91, M82, M83, "
            + "M200, M220, M221, M600, M601), gcode_G28, gcode_G92; Firmware/motion_control.cpp: mc_arc",
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
        Pauses = ["M601", "M0", "M1", "M25", "M125", "M600"],
    };
}
