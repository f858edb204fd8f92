namespace Caterpillar.Flavors;

/// <summary>What a firmware does with a command, from <c>Commands.tsv</c>.</summary>
/// <param name="Name">The command, for example <c>M206</c>, <c>M862.3</c>, <c>SET_PIN</c>. A <c>*</c> at the end stands for any letters.</param>
/// <param name="When">Words of the line that it needs: <c>S0</c>, <c>X</c>, <c>!Z</c> (no Z), <c>~judge</c> (that text). Empty = any.</param>
/// <param name="Class">What it acts on.</param>
/// <param name="Use">What it means in a print.</param>
/// <param name="Effect">What it does, in words.</param>
/// <param name="Source">Short names of the sources, as explained in <see cref="CommandTable.Sources"/>.</param>
internal sealed record FlavorCommand(string Name, string When, CommandClass Class, CommandUse Use, string Effect, string Source)
{
    /// <summary>True if the firmware knows the command. Otherwise it ignores it.</summary>
    public bool IsKnown => Use != CommandUse.Ignored;
}

/// <summary>What a command acts on.</summary>
internal enum CommandClass
{
    Motion,

    /// <summary>Homing and probing.</summary>
    Home,

    /// <summary>Coordinates change, the head stays.</summary>
    Position,

    /// <summary>Scale or unit of E.</summary>
    ExtrusionScale,
    Extrude,
    Heat,
    Fan,

    /// <summary>Speeds, accelerations and currents.</summary>
    Limits,
    Calibration,
    Mode,
    Tool,

    /// <summary>Marks of objects.</summary>
    Object,

    /// <summary>Macros, conditions, loops and jumps.</summary>
    Flow,

    /// <summary>Pause or end of the print.</summary>
    Pause,

    /// <summary>Messages and reports.</summary>
    Host,

    /// <summary>Saved settings and files.</summary>
    Store,
}

/// <summary>What a command means in a print.</summary>
internal enum CommandUse
{
    /// <summary>Harmless.</summary>
    Ok,

    /// <summary>Harmless, because the decoder follows it.</summary>
    Tracked,

    /// <summary>Moves the head or shifts its coordinates in a way that the decoder does not follow.</summary>
    Untracked,

    /// <summary>Only before the print.</summary>
    Start,

    /// <summary>Only after the print.</summary>
    End,

    /// <summary>Waits with a hot nozzle. The firmware may move, retract and cool.</summary>
    Pause,

    /// <summary>Moves unpredictably, or loses position, scale or heat.</summary>
    Never,

    /// <summary>Depends on the configuration of the machine.</summary>
    Depends,

    /// <summary>Unknown to the firmware, which ignores it.</summary>
    Ignored,
}
