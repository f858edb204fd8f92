namespace Caterpillar.Toolpaths;

/// <summary>Kinds of moves, after the retraction balance.</summary>
public enum MoveKind : byte
{
    /// <summary>Motion that deposits material.</summary>
    Print,

    /// <summary>Motion that deposits nothing.</summary>
    Travel,

    /// <summary>Motion while filament is retracted.</summary>
    Wipe,

    /// <summary>Filament retracted in place.</summary>
    Retract,

    /// <summary>Retracted filament restored in place.</summary>
    Deretract,

    /// <summary>Motion that only restores retracted filament.</summary>
    MovingDeretract,

    /// <summary>Material extruded in place, beyond what was retracted.</summary>
    Prime,

    /// <summary>Waiting in place; the duration is in the event attached to the move.</summary>
    Dwell,
}
