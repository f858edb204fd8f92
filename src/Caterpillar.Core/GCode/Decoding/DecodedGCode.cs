namespace Caterpillar.GCode;

/// <summary>A decoded file.</summary>
public sealed class DecodedGCode
{
    /// <summary>The name of mapped axes in the comments of a file.</summary>
    internal const string MappingsKey = "axis_mappings";

    /// <summary>The names of rotary axes and of what X, Y and Z say in the comments of a file.</summary>
    internal const string AxesKey = "rotary_axes";

    /// <inheritdoc cref="AxesKey"/>
    internal const string PositionsKey = "rotary_positions";

    internal DecodedGCode(Toolpath toolpath, DecodeReport report, FlavorRules flavor)
    {
        Toolpath = toolpath;
        Report = report;
        Flavor = flavor;
    }

    /// <summary>The text of the file. Null if it was decoded from a stream.</summary>
    public GCodeDocument? Document { get; internal init; }

    /// <summary>The toolpath in machine coordinates (G92 does not move them). Its sources are lines of the file.</summary>
    public Toolpath Toolpath { get; }

    /// <summary>Counts and sums.</summary>
    public DecodeReport Report { get; }

    /// <summary>The G-code flavor of the file.</summary>
    public FlavorRules Flavor { get; }

    /// <summary>Evidence for the detected flavor, in sentences. Empty if the flavor was given.</summary>
    public IReadOnlyList<string> Evidence { get; internal init; } = [];

    /// <summary>The slicer's settings in the comments.</summary>
    public IReadOnlyDictionary<string, string> Settings { get; internal init; } = new Dictionary<string, string>();

    /// <summary>Commands without effect on the toolpath, and their counts.</summary>
    public IReadOnlyDictionary<string, int> Ignored { get; internal init; } = new Dictionary<string, int>();

    /// <summary>Rule that decided which moves print.</summary>
    public ExtrusionRule Rule { get; internal init; }

    /// <summary>
    /// The error <c>gcode.not_gcode</c> for a file that is not G-code, with its likely kind (mesh, image, archive …). Null for G-code. The decoding diagnostics
    /// do not contain it, because any bytes can be decoded.
    /// </summary>
    public Diagnostic? NotGCode { get; internal init; }

    /// <summary>
    /// The toolpath on the part, for checks, times and pictures: of the unrolled surface, and of the tip where the file moves slides and rotary axes. Axes
    /// are those that the file states, else those of a printer. Edits need the toolpath as it was read.
    /// </summary>
    public Toolpath Unrolled(Printer? printer = null) => AxesOn(printer).ToPart(AxisMapping.Unroll(Toolpath, MappingsOn(printer)));

    /// <summary>The printer with the rotary axes that the file states, if it does.</summary>
    internal Printer AxesOn(Printer? printer)
    {
        printer ??= new Printer();
        if (!Settings.TryGetValue(AxesKey, out var text)) return printer;
        RotaryAxis?[] axes = Array.ConvertAll(Words.Replaced(text, "\\n", ",").Split(','), t => RotaryAxis.Parse(t.Trim()));
        if (Array.IndexOf(axes, null) >= 0 || Kinematics.Problem(axes!) is not null) return printer;
        Settings.TryGetValue(PositionsKey, out var positions);
        return printer with
        {
            RotaryAxes = new(axes!),
            RotaryPositions = positions switch { "machine" => RotaryPositions.Machine, "polar" => RotaryPositions.Polar, _ => RotaryPositions.Tip },
        };
    }

    internal IReadOnlyList<AxisMapping> MappingsOn(Printer? printer)
    {
        // The header separates them with commas, the setup as lines.
        var stated = Settings.TryGetValue(MappingsKey, out var text)
            ? Array.ConvertAll(Words.Replaced(text, "\\n", ",").Split(','), t => AxisMapping.Parse(t.Trim())) : [];
        return stated.Length > 0 && Array.IndexOf(stated, null) < 0 ? stated! : printer?.AxisMappings ?? ValueList<AxisMapping>.Empty;
    }

    /// <summary>The state of the machine before each chunk of the document.</summary>
    internal Checkpoint[] Checkpoints { get; init; } = [];

    /// <summary>Commands that are not harmless everywhere, and where the file uses them.</summary>
    internal IReadOnlyList<UsedCommand> Used { get; init; } = [];

    /// <summary>The diagnostics of decoding.</summary>
    internal IReadOnlyList<Diagnostic> Problems { get; init; } = [];

    internal ExtrusionAxis Axis { get; init; } = ExtrusionAxis.None;

    /// <summary>What the numbers of layers, in order of their comments, became in the end. Null without printed layers.</summary>
    internal int[]? LayerNumbers { get; init; }

    /// <summary>The last line that changes a mode.</summary>
    internal int LastModeLine { get; init; }

    /// <summary>First line of the first layer. 0 = none.</summary>
    internal int FirstLayerLine { get; init; }

    /// <summary>False if those who took blocks were told of other layers.</summary>
    internal bool HasExpectedLayers { get; init; } = true;

    /// <summary>Lines of the first and of the last extrusion of a layer. The largest number and 0 = none.</summary>
    internal (int First, int Last) PrintLines
    {
        get
        {
            var (first, last) = (int.MaxValue, 0);
            foreach (var block in Toolpath.Blocks)
            {
                var c = block.Columns;
                for (var i = 0; i < c.Count; i++)
                {
                    if (c.Kind[i] != MoveKind.Print || c.Layer[i] < 0) continue;
                    last = c.Source[i];
                    first = Math.Min(first, last);
                }
            }
            return (first, last);
        }
    }

    /// <summary>The first line of the first layer and the line of the last extrusion of the print. The last is 0 without layers.</summary>
    internal (int First, int Last) PrintedLines => (FirstLayerLine > 0 ? FirstLayerLine : PrintLines.First, PrintLines.Last);

    /// <summary>Moves, layers and flavor, for a panel.</summary>
    public override string ToString()
        => NumberFormatter.Format(Toolpath.Count) + " moves, " + NumberFormatter.Format(Toolpath.CountLayers()) + " layers, " + Flavor.Title;
}
