namespace Caterpillar.Flavors;

/// <summary>
/// The rules of a G-code flavor, as data. Each firmware has a file in <c>Firmware</c>. The decoder, the writer, the converter and
/// <c>docs/gcode.md</c> use these rules. None of them depends on a firmware by name.
/// </summary>
/// <param name="words">The values of rules by their names, as in those files. Other rules have their usual value.</param>
/// <exception cref="ArgumentException">A value is none of its rule.</exception>
public sealed partial class FlavorRules(IReadOnlyDictionary<string, string> words)
{
    /// <summary>Name in options and profiles, for example <c>marlin2</c>.</summary>
    public string Name { get; } = words.Text(nameof(Name));

    /// <summary>Display name.</summary>
    public string Title { get; } = words.Text(nameof(Title));

    /// <summary>Other names in common use or in comments of slicers: lowercase letters and digits only.</summary>
    public IReadOnlyList<string> OtherNames { get; } = words.List(nameof(OtherNames));

    /// <summary>Source of the rules: version, files and functions.</summary>
    public string Source { get; } = words.Text(nameof(Source));

    /// <summary>Additional notes: build options, closed firmware.</summary>
    public string Notes { get; } = words.Text(nameof(Notes));

    /// <summary>Which G words of a line are executed.</summary>
    internal CommandsRule Commands { get; } = words.One(nameof(Commands), CommandsRule.First);

    /// <summary>Allowed letters. A line with another letter is refused; empty = all allowed.</summary>
    internal string Letters { get; } = words.Text(nameof(Letters));

    /// <summary>When axis words move without a G0 to G3 in their line.</summary>
    internal ModalMotionRule ModalMotion { get; } = words.One(nameof(ModalMotion), ModalMotionRule.Never);

    /// <summary>Commands that wait for the user. The writer uses the first.</summary>
    internal IReadOnlyList<string> Pauses { get; } = words.List(nameof(Pauses), "M0, M1");

    /// <summary>G5 is a cubic Bézier curve in the XY plane.</summary>
    internal bool Splines { get; } = words.Is(nameof(Splines));

    /// <summary>M120 saves the modes, M121 restores them.</summary>
    internal bool ModeStack { get; } = words.Is(nameof(ModeStack));

    /// <summary>G60 stores the position. R of G0 and G1 refers to it, or to one that the firmware has stored itself, which gives a warning.</summary>
    internal bool RestorePoints { get; } = words.Is(nameof(RestorePoints));

    /// <summary>SAVE_GCODE_STATE, RESTORE_GCODE_STATE, SET_GCODE_OFFSET and ACTIVATE_EXTRUDER.</summary>
    internal bool ExtendedCommands { get; } = words.Is(nameof(ExtendedCommands));

    /// <summary>True if one of the names is this letter with this number (<c>G28</c>, <c>G92.1</c>).</summary>
    internal static bool Names(IReadOnlyList<string> names, char letter, double number)
        => names.Any(name => name[0] == letter && NumberReader.TryParse(name.Substring(1), out var value) && value == number);

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
