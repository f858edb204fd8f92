namespace Caterpillar.Toolpaths;

/// <summary>Role of an extrusion in the part.</summary>
public enum Role : byte
{
    /// <summary>Unspecified: turtle drawings, traces, curves, and files without comments.</summary>
    Unspecified,

    /// <summary>The outermost wall.</summary>
    OuterWall,

    /// <summary>Walls inside the outer wall.</summary>
    InnerWall,

    /// <summary>Walls that overhang the layer below for more than half of their length.</summary>
    OverhangWall,

    /// <summary>Sparse infill.</summary>
    Infill,

    /// <summary>Solid infill between top and bottom surfaces.</summary>
    SolidInfill,

    /// <summary>Top surfaces.</summary>
    TopSurface,

    /// <summary>Bottom surfaces.</summary>
    BottomSurface,

    /// <summary>Bridges: extrusions over air, anchored at both ends.</summary>
    Bridge,

    /// <summary>Gap fill between walls.</summary>
    GapFill,

    /// <summary>Ironing of top surfaces.</summary>
    Ironing,

    /// <summary>Skirt: loops around the print that prime the nozzle.</summary>
    Skirt,

    /// <summary>Brim: loops on the bed that hold the part.</summary>
    Brim,

    /// <summary>Raft below the part.</summary>
    Raft,

    /// <summary>Support of overhangs.</summary>
    Support,

    /// <summary>Dense layers between support and part.</summary>
    SupportInterface,

    /// <summary>Prime tower, for priming after a tool change.</summary>
    PrimeTower,

    /// <summary>Purge lines and other extrusions of start and end G-code.</summary>
    Purge,
}
