namespace Caterpillar.Flavors;

public static partial class FlavorTable
{
    /// <summary>RepRapFirmware.</summary>
    public static FlavorRules RepRapFirmware { get; } = new()
    {
        Name = "reprapfirmware",
        Title = "RepRapFirmware",
        Progress = ProgressCommand.PercentAndMinutes,
        Limits = LimitCommands.RepRapFirmware,
        SeparateAccelerations = true,
        OtherNames = ["rrf", "duet"],
        Source =
            "RepRapFirmware 3.5.3 (2024-10-23), src/GCodes: GCodes.cpp (DoStraightMove, DoArcMove, LoadExtrusionAndFeedrateFromGCode, DoDwell), "
            + "RetractFilament, SavePosition), GCodes2.cpp (HandleGcode, HandleMcode, HandleTcode), GCodes3.cpp (SetPositions, OffsetAxes, "
            + "GetSetWorkplaceCoordinates), GCodeMachineState.cpp, GCodeBuffer/StringParser.cpp (DecodeCommand, FindParameters); src/Tools/Tool.cpp "
            + "(SetFirmwareRetraction)",
        Notes =
            "M0 and M1 end the print. If E has several numbers (mixing), the first one counts. Homing and tool changes run macros of the printer, which "
            + "are not in the file.",
        Commands = CommandsRule.InOrder,
        RelativeE = RelativeERule.OnlyM82M83,
        Workspaces = true,
        NoRetractionWith = "LPRSXYZ",
        ToolTemperatures = true,
        ShortRadius = 0.00995,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        FlowToolLetter = "D",
        Volumetric = true,
        Fan = FanScale.FractionOrByte,
        ModeStack = true,
        RestorePoints = true,
        HomeOffset = HomeOffsetRule.OfWorkspace,
        LargestBabystep = 1,
        HomingKeepsBabysteps = true,
        RetractionSettings = RetractionCommands.RepRapFirmware,
        RetractionLifts = true,
        Pauses = ["M226", "M601", "M25", "M600"],
        ObjectMarks = ObjectMarking.NumbersWithNames,
    };
}
