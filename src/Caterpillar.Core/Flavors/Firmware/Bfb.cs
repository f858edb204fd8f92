namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Bits from Bytes, with extruders that are switched on and off.</summary>
    public static FlavorRules Bfb { get; } = new()
    {
        Name = "bfb",
        Title = "Bits from Bytes",
        Source = "CuraEngine of 2026-08-20, src/gcode_export/gcodeExport.cpp (writeMoveBFB, writeRetraction, writeDelay, processInitialLayerTemperature)",
        Notes =
            "The firmware is closed source. These are the words that CuraEngine writes for it. M108 S sets the revolutions per minute of the extruder (others "
            + "write ten times that), M227 its own retraction. Files contain no amounts of E, so none are guessed. G92 as on most machines, T, and M0 as a "
            + "pause are assumptions. Other commands of the firmware are unknown.",
        Inches = false,
        Arcs = false,
        FirmwareRetraction = false,
        DwellS = 0,
        ExtruderLetters = "",
        SwitchedExtruder = true,
        SwitchedTools = true,
        Pauses = ["M0"],
        StatesHeight = null,
    };
}
