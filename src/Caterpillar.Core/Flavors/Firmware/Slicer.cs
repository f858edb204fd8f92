namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Neutral rules, as in the viewers of slicers.</summary>
    public static FlavorRules Slicer { get; } = new()
    {
        Name = "slicer",
        Title = "Slicers",
        Limits = LimitCommands.Marlin,
        Source =
            "PrusaSlicer 2.9.4, src/libslic3r/GCode/GCodeProcessor.cpp: process_gcode_line, process_G1, process_G2_G3, process_G28, process_G92, process_T",
        Notes =
            "Neutral rules. Beyond the processor of PrusaSlicer they follow most machines. Lines without G repeat the last motion. "
            + "Arcs may be in other planes and have absolute centers or P. An arc without a center is a line. M101, M103 and the letters A and B extrude.",
        Commands = CommandsRule.All,
        BareG92 = BareG92Rule.ZeroAll,
        ShiftResets = ["G92.1", "G92.2"],
        ModalMotion = ModalMotionRule.WithoutG,
        NoRetractionWith = "PLXYZ",
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        ArcTurns = ArcTurnsRule.Count,
        ArcWithoutCenterIsLine = true,
        AbsoluteCenters = true,
        ExtruderLetters = "EAB",
        SwitchedExtruder = true,
        ValveIsFan = true,
        Pauses = ["M0", "M1", "M25", "M226", "M600", "M601", "PAUSE"],
    };
}
