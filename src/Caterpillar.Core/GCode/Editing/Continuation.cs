namespace Caterpillar.GCode;

/// <summary>
/// Start code for the upper half of a cut file, which is printed on the lower half: the comments and settings of the file, then the height of the nozzle,
/// homing of X and Y only, heating and priming above the lower half.
/// </summary>
internal sealed class Continuation(DecodedGCode file, PrintCut cut)
{
    /// <summary>The setting in a comment with the height of the part on which the file continues, mm.</summary>
    public const string Setting = "continues_at_z_mm";

    // mm of filament, and mm/s.
    private const double Prime = 15;
    private const double PrimeSpeed = 3;
    private const double FilamentArea = 2.405;
    private static readonly Regex Heat = new(@"\b(BED|EXTRUDER|NOZZLE|HOTEND|TOOL)\w*=([0-9.]+)", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase);
    private static readonly CommandClass[] Settings =
        [CommandClass.Fan, CommandClass.Limits, CommandClass.ExtrusionScale, CommandClass.Object, CommandClass.Extrude];
    private readonly List<string> _comments = [];
    private readonly SortedDictionary<int, double> _nozzles = [];
    private readonly List<(string Key, string Line)> _settings = [];
    private readonly FlavorCommands _commands = FlavorCommands.Of(file.Flavor);
    private double _bed;

    /// <summary>The lines, or the error <c>cut.no_start</c> or <c>cut.no_temperature</c>.</summary>
    public Result<IReadOnlyList<string>> Start()
    {
        if (file.Flavor.StatesHeight is not { Length: > 0 } height)
            return Failed("cut.no_start", $"{file.Flavor.Title} cannot be told the height of a part that stands on the bed.");
        Read();
        if (_nozzles.Count == 0 && file.Axis.HasAmounts) return Failed("cut.no_temperature", "The file does not state the temperature of the nozzle.");
        string Number(double value, int decimals = 3) => NumberFormatter.Format(value, decimals);
        List<string> lines = [.. _comments,
            "; " + Setting + " = " + Number(cut.Height), "; The lower half stands on the bed. Before this file starts, the nozzle touches its top.",
            "G21", "G90", Regex.Replace(height, "{z}", Number(cut.Height)), $"G1 Z{Number(cut.SafeHeight)} F600"];
        var tool = cut.First.Tool;
        List<PrinterEvent> events = [new HomeEvent(Z: false)];
        if (_bed > 0) events.Add(new BedTemperatureEvent(_bed, true));
        events.AddRange(_nozzles.Select(n => new NozzleTemperatureEvent(n.Value, true, n.Key < 0 ? null : n.Key)));
        if (tool > 0) events.Add(new ToolEvent(tool));
        lines.AddRange(events.SelectMany(e => EventText.Lines(e, file.Flavor)));
        lines.AddRange(_settings.Select(s => s.Line));
        if (!file.Axis.HasAmounts) return new Result<IReadOnlyList<string>>(lines, []);
        var (letter, unit) = ((char)file.Axis.FirstLetter, file.Toolpath.VolumePerE(tool) == 1 ? FilamentArea : 1);
        if (file.Flavor.RelativeE != RelativeERule.OnlyG90G91) lines.Add("M82");
        lines.AddRange([$"G92 {letter}0", $"G1 {letter}{Number(Prime * unit)} F{Number(PrimeSpeed * unit * 60)}"]);
        if (cut.Retraction is { } back) lines.Add(back.E == 0 ? "G10" : $"G1 {letter}{Number(Prime * unit + back.E, 5)} F{Number(back.Speed * 60)}");
        return new Result<IReadOnlyList<string>>(lines, []);
    }

    private static Result<IReadOnlyList<string>> Failed(string code, string why)
        => new(null, [new Diagnostic(Severity.Error, code, why + " Give the start G-code of the upper half, which must not home Z onto it (--start-gcode).")]);

    // What the lines before the upper half say: comments of the head, temperatures and settings, the last of each kind.
    private void Read()
    {
        var (line, number, last) = (new ParsedLine(), 0, cut.Lines.Upper);
        foreach (var chunk in file.Document!.Chunks)
        {
            var starts = chunk.LineStarts();
            for (var i = 0; i + 1 < starts.Length && ++number < last; i++)
            {
                var end = LineEnds.Find(chunk.Text, starts[i], starts[i + 1]);
                line.Scan(chunk.Text, starts[i], end);
                if (line.Shape == LineShape.Empty && number >= file.FirstLayerLine) continue;
                if (line.Shape == LineShape.Code && line.Letters[0] == 'G') continue;
                if (line.Shape == LineShape.Empty) _comments.Add(TextEncoding.Decode(chunk.Text, starts[i], end));
                else Take(line, TextEncoding.Decode(chunk.Text, line.CodeStart, line.CodeEnd).Trim());
            }
        }
        foreach (var what in file.Toolpath.Events)
        {
            if (what.Source >= last) break;
            if (what.Event is NozzleTemperatureEvent nozzle) _nozzles[nozzle.Tool ?? -1] = nozzle.Celsius;
            else if (what.Event is BedTemperatureEvent bed) _bed = bed.Celsius;
        }
    }

    private void Take(ParsedLine line, string code)
    {
        foreach (Match match in Heat.Matches(code))
        {
            if (!NumberReader.TryParse(match.Groups[2].Value, out var celsius)) continue;
            if (match.Groups[1].Value.StartsWith("B", StringComparison.OrdinalIgnoreCase)) _bed = celsius;
            else _nozzles[-1] = celsius;
        }
        if (_commands.Find(code) is not { Use: CommandUse.Ok or CommandUse.Tracked } command || Array.IndexOf(Settings, command.Class) < 0) return;
        var key = KeyOf(line, code.ToUpperInvariant());
        _settings.RemoveAll(s => s.Key == key);
        _settings.Add((key, code));
    }

    // What a line sets: later lines with the same key replace it.
    private static string KeyOf(ParsedLine line, string code)
    {
        if (code.StartsWith("EXCLUDE_OBJECT_", StringComparison.Ordinal)) return code.IndexOf("DEFINE", StringComparison.Ordinal) > 0 ? code : "";
        if (line.Shape == LineShape.Macro) return Regex.Replace(code, "=[-+.0-9]+$|=[-+.0-9]+(?= )", "=");
        var number = line.Values[0];
        var key = "M" + NumberFormatter.Format(number is 107 or 127 ? number - 1 : number, 1);
        for (var i = 1; i < line.Count && key is not ("M106" or "M126" or "M486"); i++) key += (char)line.Letters[i];
        // Fans, tools and drives have numbers.
        return key + NumberFormatter.Format(number is 106 or 107 ? line.Get('P', 0) : number is 204 or 205 ? 0 : line.Get('T', line.Get('D', 0)), 1);
    }
}
