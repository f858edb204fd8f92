namespace Caterpillar.Toolpaths;

/// <summary>What the machine does in a move, after the retraction balance.</summary>
public enum MoveKind : byte
{
    /// <summary>Motion that deposits material.</summary>
    Print,

    /// <summary>Motion that deposits nothing.</summary>
    Travel,

    /// <summary>Motion while filament is pulled back.</summary>
    Wipe,

    /// <summary>Filament pulled back in place.</summary>
    Retract,

    /// <summary>Retracted filament pushed forward again in place.</summary>
    Restore,

    /// <summary>Motion that only pushes retracted filament forward again.</summary>
    MovingRestore,

    /// <summary>Material pushed out in place, beyond what was retracted.</summary>
    Prime,

    /// <summary>Waiting in place; the duration is in the event that hangs on the move.</summary>
    Dwell,
}
