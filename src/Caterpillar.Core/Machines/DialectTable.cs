using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Machines;

/// <summary>The dialects of G-code that are known, with what each firmware does.</summary>
public static class DialectTable
{
    /// <summary>The rules of slicers' own viewers, which the test data follows.</summary>
    public static DialectRules Slicer { get; } = new()
    {
        Name = "slicer",
        Title = "Slicers",
        Source = "PrusaSlicer src/libslic3r/GCode/GCodeProcessor.cpp",
        ArcWithoutCenterIsLine = true,
        AbsoluteCenters = true,
        Pauses = ["M0", "M1", "M25", "M226", "M600", "M601", "PAUSE"],
    };

    public static DialectRules Marlin1 { get; } = new()
    {
        Name = "marlin1",
        Title = "Marlin 1",
        Source = "Marlin 1.1 Marlin_main.cpp (gcode_get_destination, gcode_G92, gcode_G2_G3)",
        BareG92 = BareG92Rule.Nothing,
        ModalMotion = ModalMotionRule.Never,
        SpeedFactor = true,
        FlowFactor = true,
        Volumetric = true,
        ExtruderLetters = "E",
        SwitchedExtruder = false,
        Pauses = ["M0", "M1", "M25", "M226", "M600"],
    };

    public static DialectRules Marlin2 { get; } = Marlin1 with
    {
        Name = "marlin2",
        Title = "Marlin 2",
        Source = "Marlin 2 src/gcode/gcode.h (axis_relative), geometry/G92.cpp, motion/G2_G3.cpp, motion/G4.cpp",
        RelativeE = RelativeERule.LastWins,
        Pauses = ["M0", "M1", "M25", "M125", "M600"],
    };

    public static DialectRules Prusa { get; } = Marlin1 with
    {
        Name = "prusa",
        Title = "Prusa-Firmware",
        Source = "Prusa-Firmware Firmware/Marlin_main.cpp (MK2, MK3)",
        RelativeE = RelativeERule.OnlyM82M83,
        RadiusArcs = false,
        Pauses = ["M601", "M0", "M1", "M25", "M600"],
    };

    public static DialectRules Bambu { get; } = Marlin1 with
    {
        Name = "bambu",
        Title = "Bambu",
        Source = "BambuStudio src/libslic3r/GCode/GCodeProcessor.cpp (the firmware is closed)",
        Confirmed = false,
        BareG92 = BareG92Rule.ZeroAll,
        Volumetric = false,
        ToolLimit = 255,
        Pauses = ["M400 U1", "M0", "M1", "M25", "M600"],
    };

    public static DialectRules Klipper { get; } = new()
    {
        Name = "klipper",
        Title = "Klipper",
        Source = "Klipper klippy/extras/gcode_move.py, gcode_arcs.py, firmware_retraction.py",
        ModalMotion = ModalMotionRule.Never,
        Inches = false,
        RadiusArcs = false,
        ArcsInRelativeMode = false,
        ArcTurns = false,
        DwellS = 0,
        SpeedFactor = true,
        FlowFactor = true,
        SharedE = false,
        ExtruderLetters = "E",
        SwitchedExtruder = false,
        Pauses = ["PAUSE", "M25", "M600"],
    };

    public static DialectRules RepRapFirmware { get; } = new()
    {
        Name = "reprapfirmware",
        Title = "RepRapFirmware",
        Source = "RepRapFirmware src/GCodes/GCodes2.cpp, GCodes3.cpp",
        RelativeE = RelativeERule.OnlyM82M83,
        BareG92 = BareG92Rule.Nothing,
        ModalMotion = ModalMotionRule.Never,
        ArcTurns = false,
        SpeedFactor = true,
        FlowFactor = true,
        Volumetric = true,
        SharedE = false,
        Fan = FanScale.FractionOrByte,
        ExtruderLetters = "E",
        SwitchedExtruder = false,
        Pauses = ["M226", "M601", "M25", "M0", "M1", "M600"],
    };

    public static DialectRules Repetier { get; } = Marlin1 with
    {
        Name = "repetier",
        Title = "Repetier",
        Source = "Repetier-Firmware src/ArduinoAVR/Repetier/Printer.cpp (setDestinationStepsFromGCode), Commands.cpp",
        ArcTurns = false,
        Planes = false,
        Pauses = ["M600", "M25"],
    };

    public static DialectRules Smoothie { get; } = new()
    {
        Name = "smoothie",
        Title = "Smoothieware",
        Source = "Smoothieware src/modules/robot/Robot.cpp, src/modules/tools/extruder/Extruder.cpp",
        RelativeE = RelativeERule.LastWins,
        BareG92 = BareG92Rule.ClearShifts,
        RadiusArcs = false,
        ArcTurns = false,
        SpeedFactor = true,
        FlowFactor = true,
        Volumetric = true,
        ExtruderLetters = "E",
        SwitchedExtruder = false,
        Pauses = ["M600", "M25"],
    };

    public static DialectRules Sailfish { get; } = new()
    {
        Name = "sailfish",
        Title = "Sailfish, MakerWare",
        Source = "GPX src/shared/gpx.c (translation to the s3g commands of Sailfish)",
        Confirmed = false,
        BareG92 = BareG92Rule.Nothing,
        ModalMotion = ModalMotionRule.Never,
        Arcs = false,
        FirmwareRetraction = false,
        ExtruderLetters = "EAB",
        Pauses = ["M0", "M1", "M25"],
    };

    /// <summary>Mach3 and LinuxCNC: the extruder is the A axis.</summary>
    public static DialectRules Cnc { get; } = new()
    {
        Name = "cnc",
        Title = "Mach3, LinuxCNC",
        Source = "LinuxCNC src/emc/rs274ngc (interp_convert.cc, interp_arc.cc), NIST RS274NGC version 3",
        Confirmed = false,
        RelativeE = RelativeERule.OnlyG90G91,
        BareG92 = BareG92Rule.Nothing,
        ModalMotion = ModalMotionRule.Standard,
        Homing = HomingRule.GoesToStoredPosition,
        AbsoluteCenters = true,
        FirmwareRetraction = false,
        DwellP = 1,
        DwellS = 0,
        ToolByM6 = true,
        ExtruderLetters = "AEB",
        SwitchedExtruder = false,
        StrokesWithoutE = true,
    };

    public static DialectRules Ultigcode { get; } = Marlin1 with
    {
        Name = "ultigcode",
        Title = "UltiGCode",
        Source = "Ultimaker2Marlin Marlin/Marlin_main.cpp; CuraEngine src/gcodeExport.cpp",
        Confirmed = false,
        StartsVolumetric = true,
        Pauses = ["M0", "M25", "M600", "M601"],
    };

    public static DialectRules Bfb { get; } = new()
    {
        Name = "bfb",
        Title = "Bits from Bytes",
        Source = "CuraEngine src/gcodeExport.cpp (writeExtrusionBFB)",
        Confirmed = false,
        BareG92 = BareG92Rule.Nothing,
        Arcs = false,
        FirmwareRetraction = false,
        ExtruderLetters = "",
    };

    public static DialectRules Grbl { get; } = new()
    {
        Name = "grbl",
        Title = "Grbl",
        Source = "Grbl 1.1 grbl/gcode.c",
        Confirmed = false,
        RelativeE = RelativeERule.OnlyG90G91,
        BareG92 = BareG92Rule.Nothing,
        ModalMotion = ModalMotionRule.Standard,
        Homing = HomingRule.GoesToStoredPosition,
        ArcTurns = false,
        FirmwareRetraction = false,
        DwellP = 1,
        DwellS = 0,
        ToolByM6 = true,
        ExtruderLetters = "",
        SwitchedExtruder = false,
        StrokesWithoutE = true,
    };

    /// <summary>All of them; the first is the neutral one, the second is taken where a file says nothing.</summary>
    public static IReadOnlyList<DialectRules> All { get; } =
        [Slicer, Marlin2, Marlin1, Prusa, Bambu, Klipper, RepRapFirmware, Repetier, Smoothie, Sailfish, Cnc, Ultigcode, Bfb, Grbl];

    /// <summary>The dialect with this name (case does not matter; common other names are known), or null.</summary>
    public static DialectRules? Find(string name)
    {
        if (name is null) throw new ArgumentNullException(nameof(name));
        var plain = new string(name.Where(char.IsLetterOrDigit).ToArray()).ToLowerInvariant();
        plain = plain switch
        {
            "marlin" => "marlin2",
            "marlinlegacy" => "marlin1",
            "rrf" or "duet" => "reprapfirmware",
            "reprap" or "teacup" or "sprinter" => "marlin1",
            "mk3" or "prusafirmware" => "prusa",
            "smoothieware" => "smoothie",
            "makerware" or "makerbot" => "sailfish",
            "mach3" or "linuxcnc" or "machinekit" => "cnc",
            "griffin" => "marlin1",
            _ => plain,
        };
        return All.FirstOrDefault(d => d.Name == plain);
    }
}
