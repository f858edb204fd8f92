namespace Caterpillar.Flavors;

/// <summary>Extrusion, retraction and tools.</summary>
public sealed partial class FlavorRules
{
    /// <summary>Which commands make E relative.</summary>
    internal RelativeERule RelativeE { get; } = words.One(nameof(RelativeE), RelativeERule.EitherG91OrM83);

    /// <summary>Letters of extrusion, preferred first. The file decides which one counts.</summary>
    internal string ExtruderLetters { get; } = words.Text(nameof(ExtruderLetters), "E");

    /// <summary>M101 and M103 switch the extruder on and off.</summary>
    internal bool SwitchedExtruder { get; } = words.Is(nameof(SwitchedExtruder));

    /// <summary>M201, M301 … without words switch on the second, third … extruder.</summary>
    internal bool SwitchedTools { get; } = words.Is(nameof(SwitchedTools));

    /// <summary>In a file without extrusion, G1 to G3 draw with a pen or another tool.</summary>
    internal bool PrintsWithoutE { get; } = words.Is(nameof(PrintsWithoutE));

    /// <summary>M200 D switches E to mm³.</summary>
    internal bool Volumetric { get; } = words.Is(nameof(Volumetric));

    /// <summary>E is in mm³ from the start.</summary>
    internal bool StartsVolumetric { get; } = words.Is(nameof(StartsVolumetric));

    /// <summary>G10 and G11 retract and deretract.</summary>
    internal bool FirmwareRetraction { get; } = words.Is(nameof(FirmwareRetraction), true);

    /// <summary>Letters that give G10 and G11 another meaning.</summary>
    internal string NoRetractionWith { get; } = words.Text(nameof(NoRetractionWith));

    /// <summary>Commands that set length and speed of the firmware retraction.</summary>
    internal RetractionCommands RetractionSettings { get; } = words.One<RetractionCommands>(nameof(RetractionSettings));

    /// <summary>G10 lifts the head by the height of M207 Z, above all coordinates, until G11.</summary>
    internal bool RetractionLifts { get; } = words.Is(nameof(RetractionLifts));

    /// <summary>What M221 S scales, in percent.</summary>
    internal FlowFactorRule FlowFactor { get; } = words.One<FlowFactorRule>(nameof(FlowFactor));

    /// <summary>The letter that names the tool of M221, or none.</summary>
    internal string FlowToolLetter { get; } = words.Text(nameof(FlowToolLetter));

    /// <summary>Position of E after a tool change.</summary>
    internal PositionOfERule PositionOfE { get; } = words.One<PositionOfERule>(nameof(PositionOfE));

    /// <summary>M6 changes to the tool of T. Otherwise T alone does.</summary>
    internal bool ToolByM6 { get; } = words.Is(nameof(ToolByM6));

    /// <summary>Other commands that change the tool: <c>M135 T</c>.</summary>
    internal IReadOnlyList<string> ToolCommands { get; } = words.List(nameof(ToolCommands));

    /// <summary>T numbers from here on are no tools, but commands of a filament changer or nothing.</summary>
    internal int ToolLimit { get; } = (int)words.Number(nameof(ToolLimit), 1000);

    /// <summary>G10 P S is the temperature of a tool.</summary>
    internal bool ToolTemperatures { get; } = words.Is(nameof(ToolTemperatures));
}

/// <summary>Which of G90, G91, M82 and M83 make E relative.</summary>
internal enum RelativeERule
{
    /// <summary>E is relative if G91 or M83 is active.</summary>
    EitherG91OrM83,

    /// <summary>The last of G90, G91, M82 and M83 decides.</summary>
    LastWins,

    /// <summary>Only M82 and M83 count.</summary>
    OnlyM82M83,

    /// <summary>Only G90 and G91 count: the extruder is an axis like the others.</summary>
    OnlyG90G91,
}

/// <summary>Commands that set length and speed of the firmware retraction.</summary>
internal enum RetractionCommands
{
    /// <summary>None that is followed.</summary>
    None,

    /// <summary>M207 S F for the retraction; M208 S F for what is extruded in addition after it, and its speed.</summary>
    Marlin,

    /// <summary>M207 S F for the retraction, R T for what is extruded in addition after it, and its speed.</summary>
    RepRapFirmware,

    /// <summary>SET_RETRACTION, after which G11 does nothing until the next G10.</summary>
    Klipper,
}

/// <summary>What M221 S scales.</summary>
internal enum FlowFactorRule
{
    /// <summary>Nothing.</summary>
    Ignored,

    /// <summary>The extrusion of all tools.</summary>
    AllTools,

    /// <summary>The extrusion of one tool: the current or named one.</summary>
    PerTool,

    /// <summary>The extrusion until the tool changes.</summary>
    UntilToolChange,
}

/// <summary>Position of E after a tool change.</summary>
internal enum PositionOfERule
{
    /// <summary>All tools share one position of E.</summary>
    Shared,

    /// <summary>Each tool has its own.</summary>
    PerTool,

    /// <summary>It is 0 after each change.</summary>
    ZeroAtChange,
}
