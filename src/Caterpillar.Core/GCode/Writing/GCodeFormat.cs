using Caterpillar.Flavors;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>The format of G-code: everything that the moves themselves do not say.</summary>
internal sealed record GCodeFormat
{
    /// <summary>The firmware to write for.</summary>
    public FlavorRules Flavor { get; init; } = FlavorTable.Marlin2;

    /// <summary>Relative E (M83) or absolute E (M82).</summary>
    public bool RelativeE { get; init; } = true;

    /// <summary>
    /// X, Y and Z are differences (G91) of the rounded positions, so that rounding does not add up; E is then relative, too. Only a move from an unknown
    /// position, and what templates do, is absolute.
    /// </summary>
    public bool RelativeXyz { get; init; }

    /// <summary>Decimals of X, Y and Z; of E; of F (mm/min).</summary>
    public int DecimalsXyz { get; init; } = 3;

    /// <summary>Decimals of E.</summary>
    public int DecimalsE { get; init; } = 5;

    /// <summary>Decimals of F.</summary>
    public int DecimalsF { get; init; }

    /// <summary>Retractions and restores in place are G10 and G11 where the flavor has them.</summary>
    public bool FirmwareRetraction { get; init; }

    /// <summary>False for pens, brushes and bare hot tools: no E is written.</summary>
    public bool HasE { get; init; } = true;

    /// <summary>Arcs are G2 and G3 where the flavor has them; otherwise chords.</summary>
    public bool Arcs { get; init; } = true;

    /// <summary>Largest distance of a chord from its arc, mm.</summary>
    public double ChordTolerance { get; init; } = 0.01;

    /// <summary>Comments that say where layers, roles and objects begin; the decoder and slicers' viewers read them.</summary>
    public bool Comments { get; init; } = true;

    /// <summary>Comments at the very beginning, without their <c>;</c>.</summary>
    public IReadOnlyList<string> Header { get; init; } = [];

    /// <summary>Seconds that the print takes, for a line <c>;TIME:</c> as hosts read it; null for none.</summary>
    public double? PrintTime { get; init; }

    /// <summary>Lines before the moves (the start code) and after them.</summary>
    public IReadOnlyList<string> Start { get; init; } = [];

    /// <summary>Lines after the last move.</summary>
    public IReadOnlyList<string> End { get; init; } = [];

    /// <summary>Lines at the beginning of each layer but the first, by the layer; null for none.</summary>
    public Func<Layer, IReadOnlyList<string>>? LayerLines { get; init; }

    /// <summary>Lines for a change of the tool, from one number to another; null or none for the tool command alone.</summary>
    public Func<int, int, IReadOnlyList<string>>? ToolLines { get; init; }

    /// <summary>The letter of extrusion, or 0 where nothing is extruded by words.</summary>
    internal byte ExtruderLetter => HasE && Flavor.ExtruderLetters.Length > 0 ? (byte)Flavor.ExtruderLetters[0] : (byte)0;

    /// <summary>True where extrusion is only switched on and off, by M101 and M103.</summary>
    internal bool Switches => HasE && Flavor.ExtruderLetters.Length == 0 && Flavor.SwitchedExtruder;

    /// <summary>True where extrusions need amounts of E that a toolpath does not have: it was decoded from a file that only switches its extruder.</summary>
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

    /// <summary>True where E is written as relative. Without M83 (E is an axis like the others) it is absolute.</summary>
    internal bool WritesRelative => RelativeXyz || (RelativeE && Flavor.RelativeE != RelativeERule.OnlyG90G91);
}
