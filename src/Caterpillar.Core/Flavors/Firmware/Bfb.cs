namespace Caterpillar.Flavors;

/// <summary>Bits from Bytes.</summary>
internal static class Bfb
{
    public static FlavorRules Rules { get; } = new()
    {
        Name = "bfb",
        Title = "Bits from Bytes",
        Source = "CuraEngine of 2026-08-20, src/gcode_export/gcodeExport.cpp (writeMoveBFB, writeRetraction, writeDelay, processInitialLayerTemperature)",
        Notes =
            "The firmware is closed: these are the words that CuraEngine writes for it. M108 S sets the revolutions of the extruder per minute (others "
            + "write ten times that), M227 its own retraction; there are no amounts, so none are made up. G92 as most machines take it, T and M0 as a "
            + "pause are not from there; what else the firmware knows is not known.",
        Inches = false,
        Arcs = false,
        FirmwareRetraction = false,
        DwellS = 0,
        ExtruderLetters = "",
        SwitchedExtruder = true,
        SwitchedTools = true,
        Pauses = ["M0"],
    };
}
