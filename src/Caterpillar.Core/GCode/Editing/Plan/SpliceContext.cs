namespace Caterpillar.GCode;

/// <summary>Shared state of the splicer: the file, a machine that reads the original file, and a machine that reads the written lines.</summary>
internal sealed class SpliceContext
{
    public const double NoChange = InterpreterState.NoChange;

    public SpliceContext(DecodedGCode decoding, ConvertTarget? target, LineStyle style, SplicedText text)
    {
        Decoding = decoding;
        Target = target;
        (Style, Text) = (style, text);
        Rules = target?.Flavor ?? decoding.Flavor;
        Axis = target?.Axis ?? decoding.Axis;
        Read = new GCodeInterpreter(decoding.Flavor, decoding.Rule, decoding.Axis);
        Written = new GCodeInterpreter(Rules, decoding.Rule, Axis);
    }

    public DecodedGCode Decoding { get; }

    /// <summary>Null if the file is edited and not converted.</summary>
    public ConvertTarget? Target { get; }

    public LineStyle Style { get; }

    /// <summary>The G-code flavor of the output, and the words that extrude in it.</summary>
    public FlavorRules Rules { get; }

    public ExtrusionAxis Axis { get; }

    /// <summary>The letter of written E values, or 0.</summary>
    public byte Extruder => Axis.FirstLetter;

    /// <summary>Reads the original file.</summary>
    public GCodeInterpreter Read { get; }

    /// <summary>Reads the written lines.</summary>
    public GCodeInterpreter Written { get; }

    public SplicedText Text { get; }

    /// <summary>The words of the current line of the file, and its number.</summary>
    public ParsedLine Line { get; } = new();

    public int Number { get; set; }

    public DiagnosticList Diagnostics { get; } = new();

    /// <summary>mm per unit of X, Y and Z in the current output.</summary>
    public double Unit => Written.State.Modes.Unit;

    /// <summary>mm (or mm³) per unit of E in the current output.</summary>
    public double UnitOfE => Written.State.Modes.UnitOfE(Rules);

    /// <summary>True if the current line switches to inches that are converted.</summary>
    public bool LineBringsInches => Target is { Millimeters: true } && Line.HasCode(20);

    /// <summary>True if the current line homes.</summary>
    public bool LineHomes => Read.LastEvents.Any(e => e.Event is HomeEvent);

    /// <summary>Writes a new line.</summary>
    public void Command(string line)
    {
        var bytes = TextEncoding.Encode(Style.LowerCase ? line.ToLowerInvariant() : line);
        Written.ReadLine(bytes, 0, bytes.Length, out _);
        Text.AddOwn(bytes, bytes.Length);
    }

    public void Command(string command, char letter, double value, int decimals) => Command(command + " " + letter + NumberFormatter.Format(value, decimals));

    public void Event(PrinterEvent what)
    {
        foreach (var line in EventText.Lines(what, Rules)) Command(line);
    }

    /// <summary>Writes the modes of the current line in separate lines before its other words. True if there were any.</summary>
    public bool WriteModes()
    {
        var any = false;
        for (var i = 0; i < Line.Count; i++)
        {
            if (!IsMode(i) || (Line.Values[i] == 20 && Target is { Millimeters: true })) continue;
            var mode = "G" + NumberFormatter.Format(Line.Values[i], 1);
            if (Target is not null && FlavorCommands.Of(Rules).Find(mode) is not { IsKnown: true }) continue;
            Command(mode);
            any = true;
        }
        return any;
    }

    public bool IsMode(int word)
        => Line.Letters[word] == 'G' && Line.HasValue[word] && Line.Values[word] is 17 or 18 or 19 or 20 or 21 or 90 or 91 or 90.1 or 91.1;

    /// <summary>The comment of the current line, for another command.</summary>
    public string Comment(FileLine line) => Line.CommentStart >= 0 ? " " + TextEncoding.Decode(line.Text, Line.CommentStart, line.End) : "";

    /// <summary>True if the same coordinates mean the same position in the file and in the output.</summary>
    public bool HasSameShift => Read.State.Head.HasShiftOf(Written.State.Head);

    /// <summary>The G92 line after which coordinates have the same meaning as in the file.</summary>
    public string RenamePosition(bool x, bool y, bool z, bool e)
    {
        var file = Read.State;
        var head = Written.State.Head;
        var line = "G92";
        // While nothing is known of an axis, its name is its position.
        if (x) line += " X" + Format(head.X + head.ShiftX - (head.KnownX ? file.Head.ShiftX : 0), Unit);
        if (y) line += " Y" + Format(head.Y + head.ShiftY - (head.KnownY ? file.Head.ShiftY : 0), Unit);
        if (z) line += " Z" + Format(head.Z + head.ShiftZ - (head.KnownZ ? file.Head.ShiftZ : 0), Unit);
        if (e && Extruder != 0) line += " " + (char)Extruder + Format(file.Extrusion.E * (Target?.Factor(Written.State.Tool) ?? 1), UnitOfE);
        return line;
    }

    /// <summary>A length in mm in another unit. Inches get more decimals.</summary>
    public static string Format(double value, double unit = 1) => NumberFormatter.Format(value / unit, unit > 1000 ? 11 : unit > 1 ? 8 : 6);

    /// <summary>A position, as words.</summary>
    public static string Format(Vec3 p, double unit) => "X" + Format(p.X, unit) + " Y" + Format(p.Y, unit) + " Z" + Format(p.Z, unit);
}
