namespace Caterpillar.Flavors;

/// <summary>Marlin 2.</summary>
internal static class Marlin2
{
    public static FlavorRules Rules { get; } = Marlin1.Rules with
    {
        Name = "marlin2",
        Title = "Marlin 2",
        Progress = ProgressCommand.PercentAndMinutes,
        OtherNames = ["marlin", "reprapmarlinsprinter"],
        Source =
            "Marlin 2.1, Marlin/src/gcode: gcode.cpp (get_destination_from_command, process_parsed_command), gcode.h (set_relative_mode, "
            + "axis_is_relative), parser.h (axis_unit_factor), motion/G2_G3.cpp (G2_G3, plan_arc), motion/G4.cpp, geometry/G92.cpp, config/M220.cpp, "
            + "config/M221.cpp, config/M200-M205.cpp",
        RelativeE = RelativeERule.LastWins,
        ArcTurns = ArcTurnsRule.Added,
        SpeedMemory = SpeedMemoryRule.RestoresFirst,
        ObjectMarks = ObjectMarking.Numbers,
    };
}
