namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>UltiGCode.</summary>
    public static FlavorRules Ultigcode { get; } = new()
    {
        Name = "ultigcode",
        Title = "UltiGCode",
        Limits = LimitCommands.Marlin,
        Source =
            "Ultimaker2Marlin of 2018-09-16, Marlin/Marlin_main.cpp (get_coordinates, process_commands), Marlin/motion_control.cpp (mc_arc), "
            + "Marlin/planner.cpp (volume_to_filament_length), Marlin/UltiLCD2_menu_print.cpp (;FLAVOR:UltiGCode)",
        Notes =
            "The line ;FLAVOR:UltiGCode switches E to a volume, with the filament diameter of the printer. M200 is unknown. Before the file the printer homes, "
            + "heats and primes by itself.",
        HomesToNumber = true,
        Inches = false,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        Planes = false,
        CounterclockwiseCircles = false,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        StartsVolumetric = true,
        HomeOffset = HomeOffsetRule.AtHoming,
        RetractionSettings = RetractionCommands.Marlin,
        Pauses = ["M0", "M1", "M25", "M600", "M601"],
        StatesHeight = null,
    };
}
