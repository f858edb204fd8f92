namespace Caterpillar.Machines;

// Which tool prints what, and where a tool purges the last material.
public sealed partial record PrintSettings
{
    /// <summary>Tool for a part, from 0.</summary>
    public int PartTool { get; init => field = ToolKeys.PartTool.Check(value); }

    /// <summary>Heights above the bottom of the model from which another tool replaces part_tool: a list of [from, tool].</summary> <value>mm.</value>
    public ValueList<ToolChange> ToolChanges { get; init => field = ToolKeys.ToolChanges.Check(value); } = ValueList<ToolChange>.Empty;

    /// <summary>Tool for walls; -1 = as part_tool.</summary>
    public int WallTool { get; init => field = ToolKeys.WallTool.Check(value); } = -1;

    /// <summary>Tool for sparse infill; -1 = as part_tool.</summary>
    public int InfillTool { get; init => field = ToolKeys.InfillTool.Check(value); } = -1;

    /// <summary>Tool for solid infill, top and bottom surfaces, and bridges; -1 = as part_tool.</summary>
    public int SolidInfillTool { get; init => field = ToolKeys.SolidInfillTool.Check(value); } = -1;

    /// <summary>Tool for supports and raft; -1 = as part_tool.</summary>
    public int SupportTool { get; init => field = ToolKeys.SupportTool.Check(value); } = -1;

    /// <summary>Tool for support interfaces; -1 = as support_tool.</summary>
    public int SupportInterfaceTool { get; init => field = ToolKeys.SupportInterfaceTool.Check(value); } = -1;

    /// <summary>Purge tools after a change on a tower beside the models.</summary>
    public bool PurgeTower { get; init; }

    /// <summary>Purge tools after a change into infill, as far as there is some. Infill may then have the tool of another part.</summary>
    public bool PurgeIntoInfill { get; init; }

    /// <summary>Volume purged at each tool change; 0 = 140 for a shared nozzle, otherwise 15.</summary> <value>mm³.</value>
    public double PurgeVolume { get; init => field = ToolKeys.PurgeVolume.Check(value); }

    /// <summary>Width of the purge tower in X. Its depth depends on the volume.</summary> <value>mm.</value>
    public double PurgeTowerWidth { get; init => field = ToolKeys.PurgeTowerWidth.Check(value); } = 35;

    /// <summary>Width of the brim of the purge tower; 0 = off.</summary> <value>mm.</value>
    public double PurgeTowerBrimWidth { get; init => field = ToolKeys.PurgeTowerBrimWidth.Check(value); } = 3;

    /// <summary>All tools that may be needed.</summary>
    internal IEnumerable<int> Tools => ToolChanges.Select(c => c.Tool)
        .Concat([PartTool, WallTool, InfillTool, SolidInfillTool, SupportTool, SupportInterfaceTool]).Where(t => t >= 0);

    /// <summary>The tool that prints a role.</summary>
    /// <param name="role">The role.</param>
    /// <param name="top">Top of the layer above the bottom of the model, mm.</param>
    public int ToolOf(Role role, double top = 0)
    {
        const double Rounding = 1e-6;
        var own = role switch
        {
            Role.OuterWall or Role.InnerWall or Role.OverhangWall or Role.GapFill => WallTool,
            Role.Infill => InfillTool,
            Role.SolidInfill or Role.TopSurface or Role.BottomSurface or Role.Bridge or Role.Ironing => SolidInfillTool,
            Role.SupportInterface when SupportInterfaceTool >= 0 => SupportInterfaceTool,
            Role.Support or Role.SupportInterface or Role.Raft => SupportTool,
            _ => -1,
        };
        if (own >= 0) return own;
        var tool = PartTool;
        foreach (var change in ToolChanges)
        {
            if (top > change.From + Rounding) tool = change.Tool;
        }
        return tool;
    }
}

/// <summary>Keys of print settings: tools, and purging after their changes.</summary>
internal static class ToolKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    // The highest number of a tool.
    private const int Highest = 63;

    public static readonly IntegerKey PartTool = All.Integer("part_tool", 0, Highest, s => s.PartTool, (s, v) => s with { PartTool = v });
    public static readonly ProfileKey<PrintSettings, ValueList<ToolChange>> ToolChanges = All.Of(
        "tool_changes_mm", new RowsFormat<ToolChange>(["from", "tool"], 1000, 0, 10_000, ToolChange.Of, c => [c.From, c.Tool], ToolChange.Problem),
        s => s.ToolChanges, (s, v) => s with { ToolChanges = v });
    public static readonly IntegerKey WallTool = Own("wall_tool", s => s.WallTool, (s, v) => s with { WallTool = v });
    public static readonly IntegerKey InfillTool = Own("infill_tool", s => s.InfillTool, (s, v) => s with { InfillTool = v });
    public static readonly IntegerKey SolidInfillTool = Own("solid_infill_tool", s => s.SolidInfillTool, (s, v) => s with { SolidInfillTool = v });
    public static readonly IntegerKey SupportTool = Own("support_tool", s => s.SupportTool, (s, v) => s with { SupportTool = v });
    public static readonly IntegerKey SupportInterfaceTool
        = Own("support_interface_tool", s => s.SupportInterfaceTool, (s, v) => s with { SupportInterfaceTool = v });

    public static readonly FlagKey PurgeTower = All.Boolean("purge_tower", s => s.PurgeTower, (s, v) => s with { PurgeTower = v });
    public static readonly FlagKey PurgeIntoInfill
        = All.Boolean("purge_into_infill", s => s.PurgeIntoInfill, (s, v) => s with { PurgeIntoInfill = v });
    public static readonly NumberKey PurgeVolume = All.Number("purge_volume_mm3", 0, 100_000, s => s.PurgeVolume, (s, v) => s with { PurgeVolume = v });
    public static readonly NumberKey PurgeTowerWidth
        = All.Number("purge_tower_width_mm", 10, 10_000, s => s.PurgeTowerWidth, (s, v) => s with { PurgeTowerWidth = v });
    public static readonly NumberKey PurgeTowerBrimWidth
        = All.Number("purge_tower_brim_width_mm", 0, 1000, s => s.PurgeTowerBrimWidth, (s, v) => s with { PurgeTowerBrimWidth = v });
    private static IntegerKey Own(string name, Func<PrintSettings, int> get, Func<PrintSettings, int, PrintSettings> set)
        => All.Integer(name, -1, Highest, get, set);
}
