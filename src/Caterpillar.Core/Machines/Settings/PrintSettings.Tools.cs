namespace Caterpillar.Machines;

// Which tool prints what, and where a tool purges the last material.
public sealed partial record PrintSettings
{
    /// <summary>Tool for a part, from 0.</summary>
    public int PartTool { get; init => field = Keys.Check(value); }

    /// <summary>Heights above the bottom of the model from which another tool replaces part_tool: a list of [from, tool].</summary> <value>mm.</value>
    public ValueList<ToolChange> ToolChanges { get; init => field = Keys.Check(value); } = ValueList<ToolChange>.Empty;

    /// <summary>Tool for walls; -1 = as part_tool.</summary>
    public int WallTool { get; init => field = Keys.Check(value); } = -1;

    /// <summary>Tool for sparse infill; -1 = as part_tool.</summary>
    public int InfillTool { get; init => field = Keys.Check(value); } = -1;

    /// <summary>Tool for solid infill, top and bottom surfaces, and bridges; -1 = as part_tool.</summary>
    public int SolidInfillTool { get; init => field = Keys.Check(value); } = -1;

    /// <summary>Tool for supports and raft; -1 = as part_tool.</summary>
    public int SupportTool { get; init => field = Keys.Check(value); } = -1;

    /// <summary>Tool for support interfaces; -1 = as support_tool.</summary>
    public int SupportInterfaceTool { get; init => field = Keys.Check(value); } = -1;

    /// <summary>Purge tools after a change on a tower beside the models.</summary>
    public bool PurgeTower { get; init; }

    /// <summary>Purge tools after a change into infill, as far as there is some. Infill may then have the tool of another part.</summary>
    public bool PurgeIntoInfill { get; init; }

    /// <summary>Volume purged at each tool change; 0 = 140 for a shared nozzle, otherwise 15.</summary> <value>mm³.</value>
    public double PurgeVolume { get; init => field = Keys.Check(value); }

    /// <summary>Width of the purge tower in X. Its depth depends on the volume.</summary> <value>mm.</value>
    public double PurgeTowerWidth { get; init => field = Keys.Check(value); } = 35;

    /// <summary>Front left corner of the purge tower without its brim: a list of one [x, y]; empty = near the middle of the bed.</summary> <value>mm.</value>
    public ValueList<Vec3> PurgeTowerPlace { get; init => field = Keys.Check(value); } = ValueList<Vec3>.Empty;

    /// <summary>Width of the brim of the purge tower; 0 = off.</summary> <value>mm.</value>
    public double PurgeTowerBrimWidth { get; init => field = Keys.Check(value); } = 3;

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
