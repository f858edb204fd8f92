namespace Caterpillar.Flavors;

/// <summary>Extrusion, retraction and tools.</summary>
public sealed partial record FlavorRules
{
    /// <summary>Which commands make E relative.</summary>
    internal RelativeERule RelativeE { get; init; } = RelativeERule.EitherG91OrM83;

    /// <summary>Letters of extrusion, best first. What the file uses decides.</summary>
    internal string ExtruderLetters { get; init; } = "E";

    /// <summary>M101 and M103 switch the extruder on and off.</summary>
    internal bool SwitchedExtruder { get; init; }

    /// <summary>M201, M301 … without words switch on the second extruder, the third …</summary>
    internal bool SwitchedTools { get; init; }

    /// <summary>G1 to G3 of a file without any extrusion are strokes of a pen or another tool.</summary>
    internal bool PrintsWithoutE { get; init; }

    /// <summary>M200 D makes E a volume in mm³.</summary>
    internal bool Volumetric { get; init; }

    /// <summary>E is in mm³ from the start.</summary>
    internal bool StartsVolumetric { get; init; }

    /// <summary>G10 and G11 retract and restore.</summary>
    internal bool FirmwareRetraction { get; init; } = true;

    /// <summary>Letters with which G10 and G11 are something else.</summary>
    internal string NoRetractionWith { get; init; } = "";

    /// <summary>What M221 S scales by percent.</summary>
    internal FlowFactorRule FlowFactor { get; init; }

    /// <summary>The letter that names the tool of M221, or none.</summary>
    internal string FlowToolLetter { get; init; } = "";

    /// <summary>What the position of E is after a tool change.</summary>
    internal PositionOfERule PositionOfE { get; init; }

    /// <summary>M6 changes to the tool named by T; otherwise T alone does.</summary>
    internal bool ToolByM6 { get; init; }

    /// <summary>Further commands that change to the tool that a word names: <c>M135 T</c>.</summary>
    internal IReadOnlyList<string> ToolCommands { get; init; } = [];

    /// <summary>Numbers of T from here on are commands of a filament changer, or nothing, and no tools.</summary>
    internal int ToolLimit { get; init; } = 1000;

    /// <summary>G10 P S is the temperature of a tool.</summary>
    internal bool ToolTemperatures { get; init; }
}

/// <summary>Which of G90, G91, M82 and M83 decide whether numbers of E are increments.</summary>
internal enum RelativeERule
{
    /// <summary>E is relative when G91 or M83 is in force.</summary>
    EitherG91OrM83,

    /// <summary>The last of G90, G91, M82 and M83 decides.</summary>
    LastWins,

    /// <summary>Only M82 and M83 count.</summary>
    OnlyM82M83,

    /// <summary>Only G90 and G91 count: the extruder is an axis like the others.</summary>
    OnlyG90G91,
}

/// <summary>What M221 S scales.</summary>
internal enum FlowFactorRule
{
    /// <summary>Nothing.</summary>
    Ignored,

    /// <summary>The extrusion of all tools.</summary>
    AllTools,

    /// <summary>The extrusion of one tool: the present one, or the one that is named.</summary>
    PerTool,

    /// <summary>The extrusion until the tool changes.</summary>
    UntilToolChange,
}

/// <summary>Where E stands after a change of the tool.</summary>
internal enum PositionOfERule
{
    /// <summary>The tools have one position of E in common.</summary>
    Shared,

    /// <summary>Each tool has its own.</summary>
    PerTool,

    /// <summary>At each change it is 0.</summary>
    ZeroAtChange,
}
