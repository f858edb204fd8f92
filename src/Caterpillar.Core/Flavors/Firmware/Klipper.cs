namespace Caterpillar.Flavors;

/// <summary>Klipper.</summary>
internal static class Klipper
{
    public static FlavorRules Rules { get; } = new()
    {
        Name = "klipper",
        Title = "Klipper",
        Progress = ProgressCommand.PercentAndMinutes,
        Limits = LimitCommands.Klipper,
        Source =
            "Klipper of 2026-08-07, klippy/extras/gcode_move.py (GCodeMove), gcode_arcs.py (ArcSupport), firmware_retraction.py, fan.py, "
            + "pause_resume.py, virtual_sdcard.py; klippy/toolhead.py (cmd_G4), klippy/kinematics/extruder.py (cmd_ACTIVATE_EXTRUDER)",
        Notes =
            "T, M600 and the words of a printer's own macros are what its configuration makes of them; T is taken as a change of the extruder, M600 as "
            + "a pause, others do nothing. G2, G3, G10 and G11 need their sections in the configuration, taken as there.",
        BareG92 = BareG92Rule.ZeroAll,
        Inches = false,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.Refused,
        ArcsInRelativeMode = false,
        MirroredZx = true,
        DwellS = 0,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.UntilToolChange,
        FactorsReset = true,
        PositionOfE = PositionOfERule.ZeroAtChange,
        ExtendedCommands = true,
        Pauses = ["PAUSE", "M25", "M600"],
    };
}
