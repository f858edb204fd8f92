namespace Caterpillar.GCode;

/// <summary>Names of roles in the comments of slicers.</summary>
internal static class RoleNames
{
    // The first name is that of written files.
    private static readonly (Role Role, string[] Names)[] Table =
    [
        (Role.OuterWall, ["external perimeter", "wall-outer", "outer wall", "outer perimeter", "external perimeters", "perimeter path",
            "outer perimeter path", "thin wall"]),
        (Role.InnerWall, ["perimeter", "wall-inner", "internal perimeter", "inner wall", "inner perimeter", "perimeters", "loop path", "single extrusion"]),
        (Role.OverhangWall, ["overhang perimeter", "overhang wall"]),
        (Role.Infill, ["internal infill", "fill", "infill", "sparse infill", "sparse infill path", "stacked sparse infill path", "fill-sparse"]),
        (Role.SolidInfill, ["solid infill", "internal solid infill", "solid layer", "skin", "solid path", "solid-fill", "solid fill", "solid",
            "floating vertical shell"]),
        (Role.TopSurface, ["top solid infill", "top surface", "crown path", "top-fill", "top solid fill", "skin-top"]),
        (Role.BottomSurface, ["bottom surface", "bottom solid infill", "bottom-fill", "skin-bottom"]),
        (Role.Bridge, ["bridge infill", "internal bridge infill", "bridge", "internal bridge", "bridge-infill"]),
        (Role.GapFill, ["gap fill", "gap infill", "gap-fill", "gap"]),
        (Role.Ironing, ["ironing"]),
        (Role.Skirt, ["skirt", "skirt/brim", "skirt path", "ooze shield"]),
        (Role.Brim, ["brim", "brim path"]),
        (Role.Raft, ["raft", "raft path"]),
        (Role.Support, ["support material", "support", "support (may stack) path", "support path", "support transition", "dense support material"]),
        (Role.SupportInterface, ["support material interface", "support-interface", "support interface", "dense support", "support interface path"]),
        (Role.PrimeTower, ["wipe tower", "prime-tower", "prime tower", "prime pillar", "pillar path", "prime pillar path", "purge", "wipe-tower"]),
        (Role.Purge, ["custom", "start gcode", "end gcode"]),
        (Role.Unspecified, ["unspecified", "unknown", "mixed", "travel"]),
    ];

    private static readonly Dictionary<string, Role> Roles =
        Table.SelectMany(row => row.Names.Select(name => (name, row.Role))).ToDictionary(n => n.name, n => n.Role, StringComparer.Ordinal);

    private static readonly Dictionary<Role, string> Written =
        Table.ToDictionary(r => r.Role, r => char.ToUpperInvariant(r.Names[0][0]) + r.Names[0].Substring(1));

    /// <summary>The role with this name (case does not matter), or null.</summary>
    public static Role? Find(string name) => Roles.TryGetValue(name.Trim().ToLowerInvariant(), out var role) ? role : null;

    /// <summary>The name in written files. PrusaSlicer's viewer reads it, too.</summary>
    public static string Of(Role role) => Written[role];
}
