namespace Caterpillar.Flavors;

/// <summary>
/// The rules of a G-code flavor, as data. Each firmware has a file in <c>Firmware</c>. The decoder, the writer, the converter and
/// <c>docs/gcode.md</c> use these rules. None of them depends on a firmware by name.
/// </summary>
public sealed partial record FlavorRules
{
    /// <summary>Name in options and profiles, for example <c>marlin2</c>.</summary>
    public string Name { get; init; } = "slicer";

    /// <summary>Display name.</summary>
    public string Title { get; init; } = "Slicers";

    /// <summary>Other names in common use or in comments of slicers: lowercase letters and digits only.</summary>
    public IReadOnlyList<string> OtherNames { get; init; } = [];

    /// <summary>Source of the rules: version, files and functions.</summary>
    public string Source { get; init; } = "";

    /// <summary>Additional notes: build options, closed firmware.</summary>
    public string Notes { get; init; } = "";

    /// <summary>Which G words of a line are executed.</summary>
    internal CommandsRule Commands { get; init; } = CommandsRule.First;

    /// <summary>Allowed letters. A line with another letter is refused; empty = all allowed.</summary>
    internal string Letters { get; init; } = "";

    /// <summary>When axis words move without a G0 to G3 in their line.</summary>
    internal ModalMotionRule ModalMotion { get; init; } = ModalMotionRule.Never;

    /// <summary>Commands that wait for the user. The writer uses the first.</summary>
    internal IReadOnlyList<string> Pauses { get; init; } = ["M0", "M1"];

    /// <summary>G5 is a cubic Bézier curve in the XY plane.</summary>
    internal bool Splines { get; init; }

    /// <summary>M120 saves the modes, M121 restores them.</summary>
    internal bool ModeStack { get; init; }

    /// <summary>G60 stores the position. R of G0 and G1 refers to it, or to one that the firmware has stored itself, which gives a warning.</summary>
    internal bool RestorePoints { get; init; }

    /// <summary>SAVE_GCODE_STATE, RESTORE_GCODE_STATE, SET_GCODE_OFFSET and ACTIVATE_EXTRUDER.</summary>
    internal bool ExtendedCommands { get; init; }

    /// <summary>True if one of the names is this letter with this number (<c>G28</c>, <c>G92.1</c>).</summary>
    internal static bool Names(IReadOnlyList<string> names, char letter, double number)
    {
        foreach (var name in names)
        {
            if (name[0] == letter && NumberReader.TryParse(name.Substring(1), out var value) && value == number) return true;
        }
        return false;
    }

    public override string ToString() => Title;
}

/// <summary>Which G words of a line are executed.</summary>
internal enum CommandsRule
{
    /// <summary>All, as one block: modes apply to the motion of their line in any order.</summary>
    All,

    /// <summary>One after the other.</summary>
    InOrder,

    /// <summary>The first. Others in the line are ignored.</summary>
    First,

    /// <summary>The last. Others in the line are ignored.</summary>
    Last,
}

/// <summary>When axis words move without a G0 to G3 in their line.</summary>
internal enum ModalMotionRule
{
    /// <summary>Never: such a line does nothing.</summary>
    Never,

    /// <summary>In lines without any G word.</summary>
    WithoutG,

    /// <summary>Also after modal words (<c>G90 X10</c>), as in the NIST standard.</summary>
    Standard,
}
