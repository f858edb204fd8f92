using Caterpillar.Basics;

namespace Caterpillar.Flavors;

/// <summary>
/// What the words of G-code mean to one firmware, as data; each firmware is one file of <c>Firmware</c>. The decoder, the writer, the converter and
/// <c>docs/gcode.md</c> all read it; none of them knows a firmware by name.
/// </summary>
public sealed partial record FlavorRules
{
    /// <summary>Name in options and profiles, for example <c>marlin2</c>.</summary>
    public string Name { get; init; } = "slicer";

    /// <summary>Display name.</summary>
    public string Title { get; init; } = "Slicers";

    /// <summary>Other names that users and the comments of slicers give it: lowercase letters and digits only.</summary>
    public IReadOnlyList<string> OtherNames { get; init; } = [];

    /// <summary>What the rules were compared with: version, files and functions.</summary>
    public string Source { get; init; } = "";

    /// <summary>What the table cannot say: build options, closed firmware.</summary>
    public string Notes { get; init; } = "";

    /// <summary>Which G words of a line are executed.</summary>
    internal CommandsRule Commands { get; init; } = CommandsRule.First;

    /// <summary>The letters that a line may have; any other refuses it. Empty where letters do not matter.</summary>
    internal string Letters { get; init; } = "";

    /// <summary>When axis words move without a G0 to G3 in their line.</summary>
    internal ModalMotionRule ModalMotion { get; init; } = ModalMotionRule.Never;

    /// <summary>Commands that wait for the user; the first is the one to write.</summary>
    internal IReadOnlyList<string> Pauses { get; init; } = ["M0", "M1"];

    /// <summary>Commands that move the head or shift its coordinates in a way that is not followed: a warning says so.</summary>
    internal IReadOnlyList<string> NotFollowed { get; init; } = [];

    /// <summary>M120 keeps the modes, M121 brings them back.</summary>
    internal bool ModeStack { get; init; }

    /// <summary>R of G0 and G1 counts from a position that the firmware has kept; not followed, a warning says so.</summary>
    internal bool RestorePoints { get; init; }

    /// <summary>SAVE_GCODE_STATE, RESTORE_GCODE_STATE, SET_GCODE_OFFSET and ACTIVATE_EXTRUDER.</summary>
    internal bool ExtendedCommands { get; init; }

    /// <summary>True when one of the names is this letter with this number (<c>G28</c>, <c>G92.1</c>).</summary>
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
    /// <summary>All, as one block: modes in the line hold for its motion, wherever they stand.</summary>
    All,

    /// <summary>One after the other.</summary>
    InOrder,

    /// <summary>The first; others in the line are ignored.</summary>
    First,

    /// <summary>The last; others in the line are ignored.</summary>
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
