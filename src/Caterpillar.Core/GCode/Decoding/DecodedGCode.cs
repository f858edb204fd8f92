using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>A decoded file.</summary>
public sealed class DecodedGCode
{
    internal DecodedGCode(Toolpath toolpath, DecodeReport report, FlavorRules flavor)
    {
        Toolpath = toolpath;
        Report = report;
        Flavor = flavor;
    }

    /// <summary>The file, or null where it was decoded from a stream without keeping it.</summary>
    public GCodeDocument? Document { get; internal init; }

    /// <summary>What the machine does; positions in machine coordinates (G92 does not move them), sources are lines of the file.</summary>
    public Toolpath Toolpath { get; }

    /// <summary>Counts and sums.</summary>
    public DecodeReport Report { get; }

    /// <summary>The flavor by which it was read.</summary>
    public FlavorRules Flavor { get; }

    /// <summary>Why it was read in this flavor, in sentences; empty where the flavor was given.</summary>
    public IReadOnlyList<string> Evidence { get; internal init; } = [];

    /// <summary>Settings that the slicer left in comments.</summary>
    public IReadOnlyDictionary<string, string> Settings { get; internal init; } = new Dictionary<string, string>();

    /// <summary>Commands without effect on the toolpath, and how often.</summary>
    public IReadOnlyDictionary<string, int> Ignored { get; internal init; } = new Dictionary<string, int>();

    /// <summary>What counted as printing.</summary>
    public ExtrusionRule Rule { get; internal init; }

    /// <summary>
    /// The error <c>gcode.not_gcode</c> for a file without a command, with the kind of file it looks like (a mesh, an image, an archive …); null for G-code. It
    /// is no diagnostic of decoding, which takes any bytes.
    /// </summary>
    public Diagnostic? NotGCode { get; internal init; }

    /// <summary>The state of the machine before each chunk of the document.</summary>
    internal Checkpoint[] Checkpoints { get; init; } = [];

    internal ExtrusionAxis Axis { get; init; } = ExtrusionAxis.None;

    /// <summary>The last line that changes a mode.</summary>
    internal int LastModeLine { get; init; }

    /// <summary>True when words turn rotary axes.</summary>
    internal bool HasTurns
    {
        get
        {
            foreach (var block in Toolpath.Blocks)
            {
                if (block.Columns.A is not null) return true;
            }
            return false;
        }
    }

    /// <summary>The line where the first layer begins, or 0.</summary>
    internal int FirstLayerLine { get; init; }

    /// <summary>For a panel: moves, layers and flavor.</summary>
    public override string ToString()
        => NumberFormatter.Format(Toolpath.Count) + " moves, " + NumberFormatter.Format(Toolpath.CountLayers()) + " layers, " + Flavor.Title;
}
