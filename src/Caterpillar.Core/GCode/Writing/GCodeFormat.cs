namespace Caterpillar.GCode;

/// <summary>The format of written G-code.</summary>
/// <param name="Printer">Its flavor, the mode of its E, and decimals.</param>
internal sealed record GCodeFormat(Printer Printer)
{
    /// <summary>The G-code flavor.</summary>
    public FlavorRules Flavor => Printer.Flavor;

    /// <summary>
    /// Relative X, Y and Z (G91): differences of the rounded positions, so that rounding errors do not add up. E is then relative, too. Templates and moves
    /// from an unknown position are absolute.
    /// </summary>
    public bool RelativeXyz => Printer.RelativeXyz;

    /// <summary>Comments at the beginning of the file, without <c>;</c>.</summary>
    public IReadOnlyList<string> Header { get; init; } = [];

    /// <summary>Lines after the header that only the whole print tells: its time, images and objects.</summary>
    public IReadOnlyList<string> Facts { get; init; } = [];

    /// <summary>
    /// Mark objects with the commands of the flavor. Otherwise comments name them: relative moves that a firmware skips would shift all that follow.
    /// </summary>
    public bool LabelsObjects => Printer.ObjectLabels && !RelativeXyz;

    /// <summary>Start G-code.</summary>
    public IReadOnlyList<string> Start { get; init; } = [];

    /// <summary>End G-code.</summary>
    public IReadOnlyList<string> End { get; init; } = [];

    /// <summary>Layer change G-code for each layer except the first. Null = none.</summary>
    public Func<Layer, IReadOnlyList<string>>? LayerLines { get; init; }

    /// <summary>Tool change G-code from one tool number to another. Null or empty = only the tool command.</summary>
    public Func<int, int, IReadOnlyList<string>>? ToolLines { get; init; }

    /// <summary>The letter of extrusion. 0 = none.</summary>
    internal byte ExtruderLetter => HasE && Flavor.ExtruderLetters.Length > 0 ? (byte)Flavor.ExtruderLetters[0] : (byte)0;

    /// <summary>True if extrusion is only switched on and off (M101, M103).</summary>
    internal bool Switches => HasE && Flavor.ExtruderLetters.Length == 0 && Flavor.SwitchedExtruder;

    /// <summary>True if the format needs E values that a toolpath does not have: its file only switches the extruder.</summary>
    internal bool LacksAmounts(Toolpath toolpath)
    {
        if (ExtruderLetter == 0 || toolpath.Source != MoveSource.Lines) return false;
        var prints = false;
        foreach (var block in toolpath.Blocks)
        {
            var c = block.Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (c.E[i] != 0) return false;
                prints |= c.Kind[i] == MoveKind.Print;
            }
        }
        return prints;
    }

    /// <summary>True if E is written as relative. Without M83, E is an axis like the others and is absolute.</summary>
    internal bool WritesRelative => RelativeXyz || (Printer.ExtrusionMode == ExtrusionMode.Relative && Flavor.RelativeE != RelativeERule.OnlyG90G91);

    // False for pens, brushes and bare hot tools.
    private bool HasE => Printer.ExtrusionUnit != ExtrusionUnit.None;
}
