namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Repetier.</summary>
    public static FlavorRules Repetier { get; } = new()
    {
        Name = "repetier",
        Title = "Repetier",
        Limits = LimitCommands.Repetier,
        SeparateAccelerations = true,
        Source =
            "Repetier-Firmware 1.0.4, src/ArduinoAVR/Repetier: Printer.cpp (setDestinationStepsFromGCode), Commands.cpp (processGCode, processMCode, "
            + "processArc), gcode.cpp (parseAscii), motion.cpp (PrintLine::arc), Extruder.cpp (selectExtruderById)",
        Commands = CommandsRule.Last,
        ShortRadius = 0,
        Planes = false,
        HomingKeepsShifts = true,
        HelixRisesFirst = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.AllTools,
        FactorsReset = true,
        Volumetric = true,
        LargestBabystep = 100,
        PositionOfE = PositionOfERule.PerTool,
        Pauses = ["M600", "M25"],
    };
}
