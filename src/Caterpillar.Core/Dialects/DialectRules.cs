using System.Collections.Generic;

namespace Caterpillar.Dialects;

/// <summary>
/// What the words of G-code mean to one firmware, as data. The decoder, the writer, the converter and <c>docs/gcode.md</c> all read it; none of them knows a
/// firmware by name.
/// </summary>
public sealed partial record DialectRules
{
    /// <summary>Name in options and profiles, for example <c>marlin2</c>.</summary>
    public string Name { get; init; } = "slicer";

    /// <summary>Name for people.</summary>
    public string Title { get; init; } = "Slicers";

    /// <summary>Where the rules stand: version, files and functions that they were compared with.</summary>
    public string Source { get; init; } = "";

    /// <summary>What the table cannot say: build options, closed firmware.</summary>
    public string Notes { get; init; } = "";

    public RelativeERule RelativeE { get; init; } = RelativeERule.EitherG91OrM83;

    public BareG92Rule BareG92 { get; init; } = BareG92Rule.Nothing;

    /// <summary>Commands that take back what G92 has shifted.</summary>
    public IReadOnlyList<string> ShiftResets { get; init; } = [];

    /// <summary>Which G words of a line are executed.</summary>
    public CommandsRule Commands { get; init; } = CommandsRule.First;

    /// <summary>The letters that a line may have; any other refuses it. Empty where letters do not matter.</summary>
    public string Letters { get; init; } = "";

    public ModalMotionRule ModalMotion { get; init; } = ModalMotionRule.Never;

    public HomingRule Homing { get; init; } = HomingRule.HomesToZero;

    /// <summary>Commands that home.</summary>
    public IReadOnlyList<string> HomingCommands { get; init; } = ["G28"];

    /// <summary>Shifts by G92 stay when the machine homes; otherwise those of the homed axes are gone.</summary>
    public bool HomingKeepsShifts { get; init; }

    /// <summary>Homing chooses the plane XY (G17).</summary>
    public bool HomingSelectsXy { get; init; }

    /// <summary>A number behind an axis of G28, unless it is 0, is where that axis stands afterwards.</summary>
    public bool HomesToNumber { get; init; }

    /// <summary>G20 makes inches of all lengths; otherwise it is refused and does nothing.</summary>
    public bool Inches { get; init; } = true;

    /// <summary>What G20 means to the extruder.</summary>
    public InchesOfERule InchesOfE { get; init; }

    /// <summary>G53 (for one line), G54 to G59.3, and G10 L2 and L20, which set where their zeros are.</summary>
    public bool Workspaces { get; init; }

    /// <summary>G10 and G11 retract and restore.</summary>
    public bool FirmwareRetraction { get; init; } = true;

    /// <summary>Letters with which G10 and G11 are something else.</summary>
    public string NoRetractionWith { get; init; } = "";

    /// <summary>G10 P S is the temperature of a tool.</summary>
    public bool ToolTemperatures { get; init; }

    /// <summary>Seconds for one unit of P in G4.</summary>
    public double DwellP { get; init; } = 0.001;

    /// <summary>Seconds for one unit of S in G4, which counts instead of P; 0 where S is ignored.</summary>
    public double DwellS { get; init; } = 1;

    /// <summary>P and S of G4 add up.</summary>
    public bool DwellSums { get; init; }

    /// <summary>Commands that wait for a time; the first is the one to write.</summary>
    public IReadOnlyList<string> Dwells { get; init; } = ["G4"];

    /// <summary>M220 S scales the speed by percent.</summary>
    public bool SpeedFactor { get; init; }

    public SpeedMemoryRule SpeedMemory { get; init; }

    /// <summary>What M221 S scales by percent.</summary>
    public FlowFactorRule FlowFactor { get; init; }

    /// <summary>The letter that names the tool of M221, or none.</summary>
    public string FlowToolLetter { get; init; } = "";

    /// <summary>M220 and M221 without S mean 100 %.</summary>
    public bool FactorsReset { get; init; }

    /// <summary>M200 D makes E a volume in mm³.</summary>
    public bool Volumetric { get; init; }

    /// <summary>E is in mm³ from the start.</summary>
    public bool StartsVolumetric { get; init; }

    public PositionOfERule PositionOfE { get; init; }

    /// <summary>M6 changes to the tool named by T; otherwise T alone does.</summary>
    public bool ToolByM6 { get; init; }

    /// <summary>Further commands that change to the tool that a word names: <c>M135 T</c>.</summary>
    public IReadOnlyList<string> ToolCommands { get; init; } = [];

    /// <summary>Numbers of T from here on are commands of a filament changer, or nothing, and no tools.</summary>
    public int ToolLimit { get; init; } = 1000;

    public FanScale Fan { get; init; } = FanScale.Byte;

    /// <summary>The letter of M106 with the speed of the fan.</summary>
    public char FanLetter { get; init; } = 'S';

    /// <summary>M126 and M127 switch the fan of the part.</summary>
    public bool ValveIsFan { get; init; }

    /// <summary>Letters of extrusion, best first. What the file uses decides.</summary>
    public string ExtruderLetters { get; init; } = "E";

    /// <summary>M101 and M103 switch the extruder on and off.</summary>
    public bool SwitchedExtruder { get; init; }

    /// <summary>M201, M301 … without words switch on the second extruder, the third …</summary>
    public bool SwitchedTools { get; init; }

    /// <summary>G1 to G3 of a file without any extrusion are strokes of a pen or another tool.</summary>
    public bool StrokesWithoutE { get; init; }

    /// <summary>M120 keeps the modes, M121 brings them back.</summary>
    public bool ModeStack { get; init; }

    /// <summary>R of G0 and G1 counts from a position that the firmware has kept; not followed, a warning says so.</summary>
    public bool RestorePoints { get; init; }

    /// <summary>SAVE_GCODE_STATE, RESTORE_GCODE_STATE, SET_GCODE_OFFSET and ACTIVATE_EXTRUDER.</summary>
    public bool ExtendedCommands { get; init; }

    /// <summary>Commands that wait for the user; the first is the one to write.</summary>
    public IReadOnlyList<string> Pauses { get; init; } = ["M0", "M1"];

    /// <summary>Commands that move the head or shift its coordinates in a way that is not followed: a warning says so.</summary>
    public IReadOnlyList<string> NotFollowed { get; init; } = [];

    /// <summary>Seconds that a dwell with these words takes; null for a missing word.</summary>
    public double DwellSeconds(double? p, double? s)
    {
        var ofP = (p ?? 0) * DwellP;
        if (s is null || DwellS == 0) return ofP;
        return DwellSums ? ofP + s.Value * DwellS : s.Value * DwellS;
    }

    /// <summary>True when one of the names is this letter with this number (<c>G28</c>, <c>G92.1</c>).</summary>
    internal static bool Names(IReadOnlyList<string> names, char letter, double number)
    {
        foreach (var name in names)
        {
            if (name[0] == letter && Basics.NumberReader.TryParse(name.Substring(1), out var value) && value == number) return true;
        }
        return false;
    }

    public override string ToString() => Title;
}
