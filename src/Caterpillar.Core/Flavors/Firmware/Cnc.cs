namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>Mach3 and LinuxCNC: the extruder is the A axis.</summary>
    public static FlavorRules Cnc { get; } = new()
    {
        Name = "cnc",
        Title = "Mach3, LinuxCNC",
        OtherNames = ["mach3", "linuxcnc", "machinekit"],
        Source =
            "LinuxCNC of 2026-08-22, src/emc/rs274ngc: interp_convert.cc (convert_arc, convert_axis_offsets, convert_home, convert_setup, "
            + "convert_coordinate_system, convert_stop), interp_arc.cc (arc_data_ijk, arc_data_r), interp_check.cc (check_g_codes), interp_internal.cc "
            + "(enhance_block), interp_find.cc (find_ends)",
        Notes =
            "Mach3 is closed source and is assumed to follow the rules of LinuxCNC. The extruder is a rotary axis, so G20 does not scale it. M1 "
            + "waits only if the operator has enabled it. Canned cycles are not supported.",
        Commands = CommandsRule.All,
        RelativeE = RelativeERule.OnlyG90G91,
        ShiftResets = ["G92.1", "G92.2"],
        ModalMotion = ModalMotionRule.Standard,
        Homing = HomingRule.GoesToStoredPosition,
        HomingCommands = ["G28", "G30"],
        InchesOfE = InchesOfERule.Unchanged,
        Workspaces = true,
        FirmwareRetraction = false,
        ShortRadius = 0,
        ShortRadiusMm = 0.00127,
        RadiusAndCenter = RadiusAndCenterRule.Refused,
        ArcTurns = ArcTurnsRule.Count,
        AbsoluteCenters = true,
        ArcTolerance = new ArcTolerance(0.0283, 2.83, 0.001),
        DwellP = 1,
        DwellS = 0,
        ToolByM6 = true,
        FanLetter = 'P',
        ExtruderLetters = "AEB",
        PrintsWithoutE = true,
        Pauses = ["M0", "M1", "M60"],
        StatesHeight = null,
    };
}
