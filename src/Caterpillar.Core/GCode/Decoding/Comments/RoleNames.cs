using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Names of roles in the comments of slicers.</summary>
internal static class RoleNames
{
    private static readonly Dictionary<string, Role> Names = Table();

    /// <summary>The role with this name (case does not matter), or null.</summary>
    public static Role? Find(string name) => Names.TryGetValue(name.Trim().ToLowerInvariant(), out var role) ? role : null;

    /// <summary>The name in written files. PrusaSlicer's viewer reads it, too.</summary>
    public static string Of(Role role) => role switch
    {
        Role.OuterWall => "External perimeter",
        Role.InnerWall => "Perimeter",
        Role.OverhangWall => "Overhang perimeter",
        Role.Infill => "Internal infill",
        Role.SolidInfill => "Solid infill",
        Role.TopSurface => "Top solid infill",
        Role.BottomSurface => "Bottom surface",
        Role.Bridge => "Bridge infill",
        Role.GapFill => "Gap fill",
        Role.Ironing => "Ironing",
        Role.Skirt => "Skirt",
        Role.Brim => "Brim",
        Role.Raft => "Raft",
        Role.Support => "Support material",
        Role.SupportInterface => "Support material interface",
        Role.PrimeTower => "Wipe tower",
        Role.Purge => "Custom",
        _ => "Unspecified",
    };

    private static Dictionary<string, Role> Table()
    {
        var table = new Dictionary<string, Role>(StringComparer.Ordinal);
        void Add(Role role, params string[] names)
        {
            foreach (var name in names) table[name] = role;
        }
        Add(Role.OuterWall, "wall-outer", "external perimeter", "outer wall", "outer perimeter", "external perimeters", "perimeter path",
            "outer perimeter path", "thin wall");
        Add(Role.InnerWall, "wall-inner", "perimeter", "internal perimeter", "inner wall", "inner perimeter", "perimeters", "loop path", "single extrusion");
        Add(Role.OverhangWall, "overhang perimeter", "overhang wall");
        Add(Role.Infill, "fill", "internal infill", "infill", "sparse infill", "sparse infill path", "stacked sparse infill path", "fill-sparse");
        Add(Role.SolidInfill, "solid infill", "internal solid infill", "solid layer", "skin", "solid path", "solid-fill", "solid fill", "solid",
            "floating vertical shell");
        Add(Role.TopSurface, "top solid infill", "top surface", "crown path", "top-fill", "top solid fill", "skin-top");
        Add(Role.BottomSurface, "bottom surface", "bottom solid infill", "bottom-fill", "skin-bottom");
        Add(Role.Bridge, "bridge infill", "internal bridge infill", "bridge", "internal bridge", "bridge-infill");
        Add(Role.GapFill, "gap fill", "gap infill", "gap-fill", "gap");
        Add(Role.Ironing, "ironing");
        Add(Role.Skirt, "skirt", "skirt/brim", "skirt path", "ooze shield");
        Add(Role.Brim, "brim", "brim path");
        Add(Role.Raft, "raft", "raft path");
        Add(Role.Support, "support", "support material", "support (may stack) path", "support path", "support transition", "dense support material");
        Add(Role.SupportInterface, "support-interface", "support material interface", "support interface", "dense support", "support interface path");
        Add(Role.PrimeTower, "prime-tower", "wipe tower", "prime tower", "prime pillar", "pillar path", "prime pillar path", "purge", "wipe-tower");
        Add(Role.Purge, "custom", "start gcode", "end gcode");
        Add(Role.Unspecified, "unspecified", "unknown", "mixed", "travel");
        return table;
    }
}
