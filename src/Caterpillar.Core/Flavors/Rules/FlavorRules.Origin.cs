namespace Caterpillar.Flavors;

/// <summary>Origins and units: G20, G28, G53 to G59.3 and G92.</summary>
public sealed partial record FlavorRules
{
    /// <summary>What <c>G92</c> without letters does.</summary>
    internal BareG92Rule BareG92 { get; init; } = BareG92Rule.Nothing;

    /// <summary>Commands that take back what G92 has shifted.</summary>
    internal IReadOnlyList<string> ShiftResets { get; init; } = [];

    /// <summary>What G28 does.</summary>
    internal HomingRule Homing { get; init; } = HomingRule.HomesToZero;

    /// <summary>Commands that home.</summary>
    internal IReadOnlyList<string> HomingCommands { get; init; } = ["G28"];

    /// <summary>Shifts by G92 stay when the machine homes; otherwise those of the homed axes are gone.</summary>
    internal bool HomingKeepsShifts { get; init; }

    /// <summary>Homing chooses the plane XY (G17).</summary>
    internal bool HomingSelectsXy { get; init; }

    /// <summary>A number after an axis of G28, unless it is 0, is the position of that axis afterwards.</summary>
    internal bool HomesToNumber { get; init; }

    /// <summary>G53 (for one line), G54 to G59.3, and G10 L2 and L20, which set where their zeros are.</summary>
    internal bool Workspaces { get; init; }

    /// <summary>G20 makes inches of all lengths; otherwise it is refused and does nothing.</summary>
    internal bool Inches { get; init; } = true;

    /// <summary>What G20 means to the extruder.</summary>
    internal InchesOfERule InchesOfE { get; init; }
}

/// <summary>What <c>G92</c> without letters does.</summary>
internal enum BareG92Rule
{
    /// <summary>Nothing.</summary>
    Nothing,

    /// <summary>The present place is called 0 0 0, and E is 0.</summary>
    ZeroAll,

    /// <summary>The shifts of X, Y and Z by earlier G92 are taken back, and E is 0.</summary>
    ClearShifts,
}

/// <summary>What G28 does.</summary>
internal enum HomingRule
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
internal enum InchesOfERule
{
    /// <summary>E is in inches too.</summary>
    Inches,

    /// <summary>E is in inches, and in cubic inches where it is a volume.</summary>
    InchesOrCubic,

    /// <summary>E stays as it is.</summary>
    Unchanged,
}
