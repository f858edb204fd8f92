namespace Caterpillar.Flavors;

/// <summary>Marlin 1.</summary>
internal static class Marlin1
{
    public static FlavorRules Rules { get; } = new()
    {
        Name = "marlin1",
        Title = "Marlin 1",
        Limits = LimitCommands.Marlin,
        OtherNames = ["marlinlegacy", "reprap", "reprapreprap", "reprapsprinter", "teacup", "sprinter", "griffin"],
        Source = "Marlin 1.1, Marlin/Marlin_main.cpp: gcode_get_destination, gcode_G2_G3, gcode_G4, gcode_G92, gcode_M200, gcode_M220, gcode_M221, tool_change",
        Notes =
            "G10 and G11, G17 to G19, G20, G92.1 and P of arcs are build options, assumed to be enabled. Workspaces (G53 to G59), saved positions (G60, "
            + "G61), splines (G5) and motion without G are options too, assumed to be disabled.",
        ShiftResets = ["G92.1"],
        HomingSelectsXy = true,
        InchesOfE = InchesOfERule.InchesOrCubic,
        ArcTurns = ArcTurnsRule.CirclesFirst,
        RadiusInXyOnly = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        FlowToolLetter = "T",
        Volumetric = true,
        Pauses = ["M0", "M1", "M25", "M125", "M600"],
        ObjectMarks = ObjectMarking.Numbers,
    };
}
