namespace Caterpillar.Jobs;

/// <summary>Turns the lines of a header or footer into lines of a template.</summary>
internal sealed class HeaderTemplate(HeaderCode code, string file, DiagnosticList problems)
{
    private readonly List<string> _lines = [];
    private readonly SlicerTemplate _template = new(new Dictionary<string, string>(), file, problems.Add);

    public ValueList<string> Start()
    {
        foreach (var line in code.Lines)
        {
            if (line.Is('M', 104, 109)) Heat(line, code.NozzleTemperature, "nozzle_temperature_c", "start_nozzle_temperature_c");
            else if (line.Is('M', 140, 190)) Heat(line, code.BedTemperature, "bed_temperature_c", "start_bed_temperature_c");
            else Add(line);
        }
        return new ValueList<string>(_lines);
    }

    /// <summary>The footer. Modes that it inherits from the header are set first, and lifts end below the top of the build volume.</summary>
    public ValueList<string> End(HeaderCode before)
    {
        var relative = before.Relative == true;
        if (code.NeedsMode) _lines.Add(relative ? "G91 ; as set by the header" : "G90 ; as set by the header");
        if (code.NeedsModeE) _lines.Add(before.RelativeE == false ? "M82 ; as set by the header" : "M83 ; as set by the header");
        foreach (var line in code.Lines)
        {
            if (line.Is('G', 90, 91)) relative = line.Is('G', 91);
            if (relative && line.Is('G', 0, 1) && line['Z'] is >= 10 and var rise) Lift(line, NumberFormatter.Format(rise, 3));
            else Add(line);
        }
        return new ValueList<string>(_lines);
    }

    private void Add(HeaderLine line) => _lines.Add(Convert(line.Text));

    private string Convert(string text) => _template.Line(text, ProfileKinds.Printer.Find("start_gcode")!, new SourceLocation(file));

    // The temperature comes from the material, and the line is omitted for a material without one.
    private void Heat(HeaderLine line, double? own, string condition, string value)
    {
        var temperature = line.Temperature;
        if (temperature is null || temperature != own)
        {
            var converted = Convert(line.Text);
            if (converted == line.Text) _lines.Add(converted);
            else AddIf(condition, converted);
            if (temperature is not null && temperature != own)
            {
                problems.Add(Severity.Note, "header.other_temperature",
                    $"The header also sets {NumberFormatter.Format(temperature.Value, 1)} °C. That line keeps its number.", new SourceLocation(file));
            }
            return;
        }
        var (before, after) = line.Around(line['S'] == temperature ? 'S' : 'R');
        AddIf(condition, Convert(before) + "{" + value + "}" + Convert(after));
    }

    private void AddIf(string condition, string line)
    {
        _lines.Add("{if " + condition + " > 0}");
        _lines.Add(line);
        _lines.Add("{endif}");
    }

    private void Lift(HeaderLine line, string rise)
    {
        var (before, after) = line.Around('Z');
        _lines.Add(Convert(before) + "{max(0, min(" + rise + ", bed_max_z_mm - print_max_z_mm - 5))}" + Convert(after));
        problems.Add(Severity.Note, "header.end_height",
            $"The footer raises the head by {rise} mm. In the template the lift ends at most 5 mm below the top of the build volume.",
            new SourceLocation(file));
    }
}
