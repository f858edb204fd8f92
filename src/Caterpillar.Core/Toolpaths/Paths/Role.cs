namespace Caterpillar.Toolpaths;

/// <summary>What a printed extrusion is for.</summary>
public enum Role : byte
{
    /// <summary>Unspecified: turtle drawings, traces, user curves, files without comments.</summary>
    Unspecified,

    /// <summary>The wall that is seen.</summary>
    OuterWall,

    /// <summary>Walls inside of the outer one.</summary>
    InnerWall,

    /// <summary>Walls that hang over the layer below for more than half of their length.</summary>
    OverhangWall,

    /// <summary>Sparse filling.</summary>
    Infill,

    /// <summary>Closed layers between skins.</summary>
    SolidInfill,

    /// <summary>Closed areas that are seen from above.</summary>
    TopSurface,

    /// <summary>Closed areas that are seen from below.</summary>
    BottomSurface,

    /// <summary>Extrusions over air, held at both ends.</summary>
    Bridge,

    /// <summary>Extrusions in gaps between walls.</summary>
    GapFill,

    /// <summary>The nozzle smooths a top skin.</summary>
    Ironing,

    /// <summary>Loops around the print that prime the nozzle.</summary>
    Skirt,

    /// <summary>Loops on the bed that hold the part.</summary>
    Brim,

    /// <summary>Layers below the part.</summary>
    Raft,

    /// <summary>What holds up overhangs.</summary>
    Support,

    /// <summary>Dense layers of supports next to the part.</summary>
    SupportInterface,

    /// <summary>Where tools are primed after a change.</summary>
    PrimeTower,

    /// <summary>Printed by start and end code: purge lines.</summary>
    Purge,
}
