namespace Caterpillar.Flavors;

/// <summary>Origins and units: G20, G28, G53 to G59.3 and G92.</summary>
public sealed partial class FlavorRules
{
    /// <summary>What <c>G92</c> without letters does.</summary>
    internal BareG92Rule BareG92 { get; } = words.One(nameof(BareG92), BareG92Rule.Nothing);

    /// <summary>Commands that reset the offsets of G92.</summary>
    internal IReadOnlyList<string> ShiftResets { get; } = words.List(nameof(ShiftResets));

    /// <summary>What G28 does.</summary>
    internal HomingRule Homing { get; } = words.One(nameof(Homing), HomingRule.HomesToZero);

    /// <summary>Commands that home.</summary>
    internal IReadOnlyList<string> HomingCommands { get; } = words.List(nameof(HomingCommands), "G28");

    /// <summary>Homing keeps the offsets of G92. Otherwise it resets them for the homed axes.</summary>
    internal bool HomingKeepsShifts { get; } = words.Is(nameof(HomingKeepsShifts));

    /// <summary>Homing selects the XY plane (G17).</summary>
    internal bool HomingSelectsXy { get; } = words.Is(nameof(HomingSelectsXy));

    /// <summary>A number other than 0 after an axis of G28 is the position of that axis after homing.</summary>
    internal bool HomesToNumber { get; } = words.Is(nameof(HomesToNumber));

    /// <summary>
    /// Command that states the height of the nozzle, with <c>{z}</c> in mm, before X and Y are homed over a part that stands on the bed. Empty = none is safe.
    /// </summary>
    internal string StatesHeight { get; } = words.Text(nameof(StatesHeight), "G92 Z{z}");

    /// <summary>What <see cref="StatesHeight"/> needs, as a sentence. Empty = nothing.</summary>
    internal string HeightNeeds { get; } = words.Text(nameof(HeightNeeds));

    /// <summary>G53 (for one line), G54 to G59.3, and G10 L2 and L20, which set their origins.</summary>
    internal bool Workspaces { get; } = words.Is(nameof(Workspaces));

    /// <summary>
    /// G92 sets the origin of the selected coordinate system. Selecting one resets the offsets of G92, and homing leaves it. Before the first of G54 to G59.3
    /// none is selected. There is neither G53 for one line nor G10 L2.
    /// </summary>
    internal bool WorkspacesByG92 { get; } = words.Is(nameof(WorkspacesByG92));

    /// <summary>What M206, the home offset, does.</summary>
    internal HomeOffsetRule HomeOffset { get; } = words.One<HomeOffsetRule>(nameof(HomeOffset));

    /// <summary>Maximum distance of M290 in Z, mm; 0 = M290 does not move the head.</summary>
    internal double LargestBabystep { get; } = words.Number(nameof(LargestBabystep));

    /// <summary>Homing keeps what M290 has moved, and M290 R0 is the sum of all its distances.</summary>
    internal bool HomingKeepsBabysteps { get; } = words.Is(nameof(HomingKeepsBabysteps));

    /// <summary>G60 stores the position, and G61 returns to it.</summary>
    internal bool SavedPositions { get; } = words.Is(nameof(SavedPositions));

    /// <summary>G20 switches all lengths to inches. Otherwise it is refused and does nothing.</summary>
    internal bool Inches { get; } = words.Is(nameof(Inches), true);

    /// <summary>Effect of G20 on the extruder.</summary>
    internal InchesOfERule InchesOfE { get; } = words.One<InchesOfERule>(nameof(InchesOfE));
}

/// <summary>What <c>G92</c> without letters does.</summary>
internal enum BareG92Rule
{
    /// <summary>Nothing.</summary>
    Nothing,

    /// <summary>The current position becomes 0 0 0, and E becomes 0.</summary>
    ZeroAll,

    /// <summary>Offsets of X, Y and Z by earlier G92 are reset, and E becomes 0.</summary>
    ClearShifts,
}

/// <summary>What G28 does.</summary>
internal enum HomingRule
{
    /// <summary>Homes the named axes, or all axes, to position 0.</summary>
    HomesToZero,

    /// <summary>
    /// Moves via the named point to a stored position of the machine (stored by G28.1 and G30.1, otherwise 0), in the named axes or
    /// in all axes. Offsets of G92 stay.
    /// </summary>
    GoesToStoredPosition,
}

/// <summary>What M206 does.</summary>
internal enum HomeOffsetRule
{
    /// <summary>It is unknown, or is not followed.</summary>
    None,

    /// <summary>Its offsets are added to the coordinates at once and after each homing.</summary>
    AtOnce,

    /// <summary>Its offsets are the position after the next homing.</summary>
    AtHoming,

    /// <summary>Its offsets are the negative origin of the selected coordinate system.</summary>
    OfWorkspace,
}

/// <summary>Effect of G20 on the extruder.</summary>
internal enum InchesOfERule
{
    /// <summary>E is in inches too.</summary>
    Inches,

    /// <summary>E is in inches, or in cubic inches if it is a volume.</summary>
    InchesOrCubic,

    /// <summary>E is unchanged.</summary>
    Unchanged,
}
