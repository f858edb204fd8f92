namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Klipper.</summary>
    public static FlavorRules Klipper { get; } = new()
    {
        Name = "klipper",
        Title = "Klipper",
        Progress = ProgressCommand.PercentAndMinutes,
        Limits = LimitCommands.Klipper,
        Source =
            "Klipper of 2026-08-07, klippy/extras/gcode_move.py (GCodeMove), gcode_arcs.py (ArcSupport), firmware_retraction.py, fan.py, "
            + "pause_resume.py, virtual_sdcard.py; klippy/toolhead.py (cmd_G4), klippy/kinematics/extruder.py (cmd_ACTIVATE_EXTRUDER)",
        Notes =
            "T, M600 and other macros depend on the configuration of the printer. Here T changes the extruder, M600 is "
            + "a pause. Other macros are not understood, unless the printer profile declares them. "
            + "G2, G3, G10 and G11 need sections in the configuration, which are assumed to be present.",
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
        NoTargetIsOff = true,
        PositionOfE = PositionOfERule.ZeroAtChange,
        ExtendedCommands = true,
        RetractionSettings = RetractionCommands.Klipper,
        Pauses = ["PAUSE", "M25", "M600"],
        StatesHeight = "SET_KINEMATIC_POSITION Z={z} SET_HOMED=Z",
        HeightNeeds = " Klipper needs enable_force_move in its configuration for that.",
        ObjectMarks = ObjectMarking.Names,
        FanNumbers = false,
    };
}
