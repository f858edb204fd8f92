namespace Caterpillar.Toolpaths;

/// <summary>Kinds of moves. Deretraction does not count as printing.</summary>
public enum MoveKind : byte
{
    /// <summary>Motion that deposits material.</summary>
    Print,

    /// <summary>Motion without extrusion (travel move).</summary>
    Travel,

    /// <summary>Motion while filament is retracted.</summary>
    Wipe,

    /// <summary>Retraction in place.</summary>
    Retract,

    /// <summary>Deretraction in place.</summary>
    Deretract,

    /// <summary>Motion that only deretracts.</summary>
    MovingDeretract,

    /// <summary>Extrusion in place, beyond deretraction.</summary>
    Prime,

    /// <summary>Waiting in place. The event of the move states the duration.</summary>
    Dwell,
}
