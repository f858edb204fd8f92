namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Firmware of Bambu Lab printers.</summary>
    public static FlavorRules Bambu { get; } = new()
    {
        Name = "bambu",
        Title = "Bambu",
        Progress = ProgressCommand.PercentAndMinutes,
        Limits = LimitCommands.Marlin,
        Source =
            "BambuStudio, src/libslic3r/GCode/GCodeProcessor.cpp (commit bca0414): process_G1, process_G2_G3, process_G4, process_G28, process_G92, "
            + "process_M106, process_M221, process_M400, process_M1020, process_T",
        Notes =
            "The firmware is closed source. These are the rules by which BambuStudio reads its own files. Its source has neither M220, which is in the start "
            + "G-code of its printers, nor M0, M1, M25, M600 and M400 U1 as pauses.",
        BareG92 = BareG92Rule.ZeroAll,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        ArcTurns = ArcTurnsRule.OneCircle,
        Planes = false,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.AllTools,
        FlowToolLetter = "T",
        ToolCommands = ["M1020 S"],
        ToolLimit = 255,
        Dwells = ["G4", "M400"],
        Pauses = ["M400 U1", "M0", "M1", "M25", "M600"],
        StatesHeight = null,
    };
}
