using System.Collections.Generic;

namespace Caterpillar.Machines;

/// <summary>Which of G90, G91, M82 and M83 decide whether numbers of E are increments.</summary>
public enum RelativeERule
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

/// <summary>What <c>G92</c> without letters does.</summary>
public enum BareG92Rule
{
    /// <summary>Nothing.</summary>
    Nothing,

    /// <summary>The present place is called 0 0 0, and E is 0.</summary>
    ZeroAll,

    /// <summary>The shifts of X, Y and Z by earlier G92 are taken back, and E is 0.</summary>
    ClearShifts,
}

/// <summary>When axis words move without a G0 to G3 in their line.</summary>
public enum ModalMotionRule
{
    /// <summary>Never: such a line does nothing.</summary>
    Never,

    /// <summary>In lines without any G word.</summary>
    WithoutG,

    /// <summary>Also behind modal words (<c>G90 X10</c>), as in the NIST standard.</summary>
    Standard,
}

/// <summary>What G28 does.</summary>
public enum HomingRule
{
    /// <summary>Homes the named axes, or all, which then stand at 0.</summary>
    HomesToZero,

    /// <summary>Goes to a stored position that the file does not know (taken as machine zero), over the point named.</summary>
    GoesToStoredPosition,
}

/// <summary>How the number of M106 S is meant.</summary>
public enum FanScale
{
    /// <summary>0 to 255.</summary>
    Byte,

    /// <summary>0 to 1, and 0 to 255 above that.</summary>
    FractionOrByte,
}

/// <summary>
/// What the words of G-code mean to one firmware, as data. The decoder, the writer, the converter and <c>docs/gcode.md</c> all read it; none of them knows a firmware by name.
/// </summary>
public sealed record DialectRules
{
    /// <summary>Name in options and profiles, for example <c>marlin2</c>.</summary>
    public string Name { get; init; } = "slicer";

    /// <summary>Name for people.</summary>
    public string Title { get; init; } = "Slicers";

    /// <summary>Where the rules stand.</summary>
    public string Source { get; init; } = "";

    /// <summary>The rules were compared with that source; false where they are from documentation and experience.</summary>
    public bool Confirmed { get; init; } = true;

    public RelativeERule RelativeE { get; init; } = RelativeERule.EitherG91OrM83;

    public BareG92Rule BareG92 { get; init; } = BareG92Rule.ZeroAll;

    public ModalMotionRule ModalMotion { get; init; } = ModalMotionRule.WithoutG;

    public HomingRule Homing { get; init; } = HomingRule.HomesToZero;

    /// <summary>G20 makes inches of all lengths; otherwise it is refused and does nothing.</summary>
    public bool Inches { get; init; } = true;

    /// <summary>G2 and G3 exist.</summary>
    public bool Arcs { get; init; } = true;

    /// <summary>Arcs by R; otherwise an arc without centre is refused and does nothing.</summary>
    public bool RadiusArcs { get; init; } = true;

    /// <summary>Arcs in G91; otherwise they are refused and do nothing.</summary>
    public bool ArcsInRelativeMode { get; init; } = true;

    /// <summary>P of an arc counts its turns.</summary>
    public bool ArcTurns { get; init; } = true;

    /// <summary>An arc with neither centre nor radius is a straight line; otherwise it is refused.</summary>
    public bool ArcWithoutCenterIsLine { get; init; }

    /// <summary>G90.1 and G91.1 switch the centres of arcs.</summary>
    public bool AbsoluteCenters { get; init; }

    /// <summary>G18 and G19 choose other planes for arcs.</summary>
    public bool Planes { get; init; } = true;

    /// <summary>G10 and G11 without further words retract and restore.</summary>
    public bool FirmwareRetraction { get; init; } = true;

    /// <summary>Seconds for one unit of P in G4.</summary>
    public double DwellP { get; init; } = 0.001;

    /// <summary>Seconds for one unit of S in G4; 0 where S is ignored.</summary>
    public double DwellS { get; init; } = 1;

    /// <summary>M220 S scales the speed by percent.</summary>
    public bool SpeedFactor { get; init; }

    /// <summary>M221 S scales the extrusion by percent.</summary>
    public bool FlowFactor { get; init; }

    /// <summary>M200 D makes E a volume in mm³.</summary>
    public bool Volumetric { get; init; }

    /// <summary>E is in mm³ from the start.</summary>
    public bool StartsVolumetric { get; init; }

    /// <summary>The tools have one position of E in common; otherwise each has its own.</summary>
    public bool SharedE { get; init; } = true;

    /// <summary>M6 changes to the tool named by T; otherwise T alone does.</summary>
    public bool ToolByM6 { get; init; }

    /// <summary>Numbers of T from here on are commands of the filament changer and no tools.</summary>
    public int ToolLimit { get; init; } = 1000;

    public FanScale Fan { get; init; } = FanScale.Byte;

    /// <summary>Letters of extrusion, best first. What the file uses decides.</summary>
    public string ExtruderLetters { get; init; } = "EAB";

    /// <summary>M101 and M103 switch the extruder on and off.</summary>
    public bool SwitchedExtruder { get; init; } = true;

    /// <summary>G1 to G3 of a file without any extrusion are strokes of a pen or another tool.</summary>
    public bool StrokesWithoutE { get; init; }

    /// <summary>Commands that wait for the user; the first is the one to write.</summary>
    public IReadOnlyList<string> Pauses { get; init; } = ["M0", "M1"];

    public override string ToString() => Title;
}
