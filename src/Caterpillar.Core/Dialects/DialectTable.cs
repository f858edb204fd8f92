using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Dialects;

/// <summary>The dialects of G-code that are known, with what each firmware does; <see cref="DialectRules.Source"/> says by which source.</summary>
public static class DialectTable
{
    /// <summary>The rules of slicers' own viewers, which the test data follows.</summary>
    public static DialectRules Slicer { get; } = new()
    {
        Name = "slicer",
        Title = "Slicers",
        Source = DialectSources.Slicer,
        Notes = DialectSources.SlicerNotes,
        Commands = CommandsRule.All,
        BareG92 = BareG92Rule.ZeroAll,
        ShiftResets = ["G92.1", "G92.2"],
        ModalMotion = ModalMotionRule.WithoutG,
        NoRetractionWith = "PLXYZ",
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        ArcTurns = ArcTurnsRule.Count,
        ArcWithoutCenterIsLine = true,
        AbsoluteCenters = true,
        ExtruderLetters = "EAB",
        SwitchedExtruder = true,
        ValveIsFan = true,
        Pauses = ["M0", "M1", "M25", "M226", "M600", "M601", "PAUSE"],
    };

    public static DialectRules Marlin1 { get; } = new()
    {
        Name = "marlin1",
        Title = "Marlin 1",
        Source = DialectSources.Marlin1,
        Notes = DialectSources.MarlinNotes,
        ShiftResets = ["G92.1"],
        HomingSelectsXy = true,
        InchesOfE = InchesOfERule.InchesOrCubic,
        ArcTurns = ArcTurnsRule.CirclesFirst,
        RadiusInXyOnly = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        FlowToolLetter = "T",
        Volumetric = true,
        Pauses = ["M0", "M1", "M25", "M125", "M600"],
        NotFollowed = ["G5", "G12", "G27", "G38.2", "G38.3", "G42", "G53", "G54", "G55", "G56", "G57", "G58", "G59", "G61", "M206", "M218", "M290", "M428"],
    };

    public static DialectRules Marlin2 { get; } = Marlin1 with
    {
        Name = "marlin2",
        Title = "Marlin 2",
        Source = DialectSources.Marlin2,
        RelativeE = RelativeERule.LastWins,
        ArcTurns = ArcTurnsRule.Added,
        SpeedMemory = SpeedMemoryRule.RestoresFirst,
    };

    public static DialectRules Prusa { get; } = Marlin1 with
    {
        Name = "prusa",
        Title = "Prusa-Firmware",
        Source = DialectSources.Prusa,
        Notes = DialectSources.PrusaNotes,
        RelativeE = RelativeERule.OnlyM82M83,
        ShiftResets = [],
        HomingSelectsXy = false,
        HomesToNumber = true,
        Inches = false,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        ArcTurns = ArcTurnsRule.Ignored,
        Planes = false,
        SpeedMemory = SpeedMemoryRule.RestoresLast,
        FlowFactor = FlowFactorRule.AllTools,
        FlowToolLetter = "",
        Pauses = ["M601", "M0", "M1", "M25", "M125", "M600"],
        NotFollowed = ["M206"],
    };

    public static DialectRules Bambu { get; } = new()
    {
        Name = "bambu",
        Title = "Bambu",
        Source = DialectSources.Bambu,
        Notes = DialectSources.BambuNotes,
        BareG92 = BareG92Rule.ZeroAll,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        ArcTurns = ArcTurnsRule.OneCircle,
        Planes = false,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.AllTools,
        FlowToolLetter = "T",
        ToolCommands = ["M1020 S"],
        ToolLimit = 255,
        Dwells = ["G4", "M400"],
        Pauses = ["M400 U1", "M0", "M1", "M25", "M600"],
        NotFollowed = ["G380"],
    };

    public static DialectRules Klipper { get; } = new()
    {
        Name = "klipper",
        Title = "Klipper",
        Source = DialectSources.Klipper,
        Notes = DialectSources.KlipperNotes,
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

    public static DialectRules RepRapFirmware { get; } = new()
    {
        Name = "reprapfirmware",
        Title = "RepRapFirmware",
        Source = DialectSources.RepRapFirmware,
        Notes = DialectSources.RepRapFirmwareNotes,
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
        Pauses = ["M226", "M601", "M25", "M600"],
        NotFollowed = ["G10", "G38.2", "G38.3", "G38.4", "G38.5", "G68", "M206", "M290"],
    };

    public static DialectRules Repetier { get; } = new()
    {
        Name = "repetier",
        Title = "Repetier",
        Source = DialectSources.Repetier,
        Commands = CommandsRule.Last,
        ShortRadius = 0,
        Planes = false,
        HomingKeepsShifts = true,
        HelixRisesFirst = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.AllTools,
        FactorsReset = true,
        Volumetric = true,
        PositionOfE = PositionOfERule.PerTool,
        Pauses = ["M600", "M25"],
        NotFollowed = ["G131", "G132", "G134", "M290", "M402"],
    };

    public static DialectRules Smoothie { get; } = new()
    {
        Name = "smoothie",
        Title = "Smoothieware",
        Source = DialectSources.Smoothie,
        Notes = DialectSources.SmoothieNotes,
        Commands = CommandsRule.InOrder,
        RelativeE = RelativeERule.LastWins,
        BareG92 = BareG92Rule.ClearShifts,
        ShiftResets = ["G92.1", "G92.2"],
        ModalMotion = ModalMotionRule.WithoutG,
        HomingKeepsShifts = true,
        InchesOfE = InchesOfERule.Unchanged,
        Workspaces = true,
        NoRetractionWith = "L",
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        DwellSums = true,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        Volumetric = true,
        PositionOfE = PositionOfERule.PerTool,
        ModeStack = true,
        Pauses = ["M600", "M25"],
        NotFollowed = ["G28.2", "G28.3", "G28.4", "G30", "G38.2", "G38.3", "G43.1", "G43.2", "G92.3", "G92.4", "M206"],
    };

    public static DialectRules Sailfish { get; } = new()
    {
        Name = "sailfish",
        Title = "Sailfish, MakerWare",
        Source = DialectSources.Sailfish,
        Notes = DialectSources.SailfishNotes,
        Commands = CommandsRule.Last,
        ModalMotion = ModalMotionRule.WithoutG,
        HomingCommands = ["G28", "G161", "G162"],
        Inches = false,
        Arcs = false,
        FirmwareRetraction = false,
        DwellS = 0,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        FlowToolLetter = "T",
        PositionOfE = PositionOfERule.PerTool,
        ToolCommands = ["M6 T", "M108 T", "M135 T"],
        Fan = FanScale.Switch,
        ValveIsFan = true,
        ExtruderLetters = "EAB",
        SwitchedExtruder = true,
        Pauses = ["M1", "M25", "M71"],
        NotFollowed = ["G10", "G54", "G55", "G56", "G57", "G58", "G59", "M132"],
    };

    /// <summary>Mach3 and LinuxCNC: the extruder is the A axis.</summary>
    public static DialectRules Cnc { get; } = new()
    {
        Name = "cnc",
        Title = "Mach3, LinuxCNC",
        Source = DialectSources.Cnc,
        Notes = DialectSources.CncNotes,
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
        StrokesWithoutE = true,
        Pauses = ["M0", "M1", "M60"],
        NotFollowed =
        [
            "G5", "G5.1", "G5.2", "G6.2", "G10", "G33", "G38.2", "G38.3", "G38.4", "G38.5", "G41", "G42", "G43", "G43.1", "G43.2", "G52", "G73", "G74", "G76",
                "G81", "G82", "G83", "G84", "G85", "G86", "G87", "G88",
            "G89", "G92.3",
        ],
    };

    public static DialectRules Ultigcode { get; } = new()
    {
        Name = "ultigcode",
        Title = "UltiGCode",
        Source = DialectSources.Ultigcode,
        Notes = DialectSources.UltigcodeNotes,
        HomesToNumber = true,
        Inches = false,
        RadiusArcs = false,
        RadiusAndCenter = RadiusAndCenterRule.CenterWins,
        Planes = false,
        CounterclockwiseCircles = false,
        SpeedFactor = true,
        FlowFactor = FlowFactorRule.PerTool,
        StartsVolumetric = true,
        Pauses = ["M0", "M1", "M25", "M600", "M601"],
        NotFollowed = ["M206", "M218", "M606"],
    };

    public static DialectRules Bfb { get; } = new()
    {
        Name = "bfb",
        Title = "Bits from Bytes",
        Source = DialectSources.Bfb,
        Notes = DialectSources.BfbNotes,
        Inches = false,
        Arcs = false,
        FirmwareRetraction = false,
        DwellS = 0,
        ExtruderLetters = "",
        SwitchedExtruder = true,
        SwitchedTools = true,
        Pauses = ["M0"],
    };

    public static DialectRules Grbl { get; } = new()
    {
        Name = "grbl",
        Title = "Grbl",
        Source = DialectSources.Grbl,
        Notes = DialectSources.GrblNotes,
        Letters = "ABCFGIJKLMNPRSTXYZ", // A B C: of builds with turning axes.
        Commands = CommandsRule.All,
        RelativeE = RelativeERule.OnlyG90G91,
        ShiftResets = ["G92.1"],
        ModalMotion = ModalMotionRule.Standard,
        Homing = HomingRule.GoesToStoredPosition,
        HomingCommands = ["G28", "G30"],
        Workspaces = true,
        FirmwareRetraction = false,
        ShortRadius = 0,
        RadiusAndCenter = RadiusAndCenterRule.Refused,
        ArcTurns = ArcTurnsRule.Refused,
        ArcNamesEnd = true,
        ArcTolerance = new ArcTolerance(0.005, 0.5, 0.001),
        DwellP = 1,
        DwellS = 0,
        ToolLimit = 0,
        Fan = FanScale.None,
        ExtruderLetters = "",
        StrokesWithoutE = true,
        Pauses = ["M0"],
        NotFollowed = ["G10", "G38.2", "G38.3", "G38.4", "G38.5", "G43.1"],
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
