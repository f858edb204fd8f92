namespace Caterpillar.Dialects;

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

    /// <summary>
    /// Goes over the point named to a stored position of the machine (G28.1 and G30.1 store it; taken as 0 where the file does not), in the named axes, or in
    /// all. Shifts by G92 stay.
    /// </summary>
    GoesToStoredPosition,
}

/// <summary>What G20 means to the extruder.</summary>
public enum InchesOfERule
{
    /// <summary>E is in inches too.</summary>
    Inches,

    /// <summary>E is in inches, and in cubic inches where it is a volume.</summary>
    InchesOrCubic,

    /// <summary>E stays as it is.</summary>
    Unchanged,
}

/// <summary>Where E stands after a change of the tool.</summary>
public enum PositionOfERule
{
    /// <summary>The tools have one position of E in common.</summary>
    Shared,

    /// <summary>Each tool has its own.</summary>
    PerTool,

    /// <summary>At each change it is 0.</summary>
    ZeroAtChange,
}

/// <summary>What M221 S scales.</summary>
public enum FlowFactorRule
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

/// <summary>What B and R of M220 do: B keeps the speed factor, R brings it back.</summary>
public enum SpeedMemoryRule
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>B, then S, then R.</summary>
    RestoresLast,

    /// <summary>R, then B (of the factor before the line), then S.</summary>
    RestoresFirst,
}

/// <summary>How the number of M106 S is meant.</summary>
public enum FanScale
{
    /// <summary>0 to 255.</summary>
    Byte,

    /// <summary>0 to 1, and 0 to 255 above that.</summary>
    FractionOrByte,

    /// <summary>0 is off, all others are on.</summary>
    Switch,

    /// <summary>M106 and M107 are unknown.</summary>
    None,
}

/// <summary>Which G words of a line are executed.</summary>
public enum CommandsRule
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

/// <summary>What P of an arc means.</summary>
public enum ArcTurnsRule
{
    /// <summary>Nothing.</summary>
    Ignored,

    /// <summary>The turns in all: P1 is the arc itself.</summary>
    Count,

    /// <summary>Full circles more, which share rise and extrusion with the arc.</summary>
    Added,

    /// <summary>Full circles in the plane and without extrusion first, then the arc.</summary>
    CirclesFirst,

    /// <summary>Only P1, and only of a full circle; other arcs with P are refused.</summary>
    OneCircle,

    /// <summary>Arcs with P are refused.</summary>
    Refused,
}

/// <summary>What an arc with both R and I J K is.</summary>
public enum RadiusAndCenterRule
{
    /// <summary>R is ignored.</summary>
    CenterWins,

    /// <summary>I, J and K are ignored.</summary>
    RadiusWins,

    /// <summary>The arc is refused.</summary>
    Refused,
}
