namespace Caterpillar.Toolpaths;

/// <summary>What a printed strand is for.</summary>
public enum Role : byte
{
    /// <summary>Unspecified: turtle drawings, traces, user curves, files without comments.</summary>
    Unspecified,
    OuterWall,
    InnerWall,
    OverhangWall,
    Infill,
    SolidInfill,
    TopSkin,
    BottomSkin,
    Bridge,
    GapFill,
    Ironing,
    Skirt,
    Brim,
    Raft,
    Support,
    SupportInterface,
    PrimeTower,

    /// <summary>Printed by start and end code: purge lines.</summary>
    Purge,
}
