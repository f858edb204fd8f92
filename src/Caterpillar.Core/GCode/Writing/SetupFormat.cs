namespace Caterpillar.GCode;

/// <summary>The G-code format of a printer: flavor, mode of E, decimals, and its templates filled with the values of the print.</summary>
internal static class SetupFormat
{
    /// <summary>The format for a toolpath, or errors if a template of the printer is wrong or the toolpath lacks E values.</summary>
    public static Result<GCodeFormat> Of(PrintSetup setup, Toolpath toolpath)
    {
        var printer = setup.Printer;
        var problems = new DiagnosticList();
        var format = Format(setup, toolpath, true, toolpath.Layers.FirstOrDefault(), problems);
        if (LayerRounding.Check(toolpath, printer.DecimalsXyz, new SourceLocation(printer.Name, Key: "decimals_xyz")) is { } rounded) problems.Add(rounded);
        if (problems.HasErrors) return new Result<GCodeFormat>(null, problems.ToList());
        if (format.LacksAmounts(toolpath))
        {
            problems.Add(Severity.Error, "gcode.no_e_values", "The toolpath prints without any amount of E, and " + printer.Flavor.Title
                + " needs them; they cannot be guessed. For a machine without an extruder set e_unit to none.");
            return new Result<GCodeFormat>(null, problems.ToList());
        }
        if (format.Switches)
            problems.Add(Severity.Warning, "gcode.e_values_lost", printer.Flavor.Title
                + " only switches its extruder on and off (M101, M103). E values and retractions are not written.");
        return new Result<GCodeFormat>(format, problems.ToList());
    }

    /// <summary>The same format without end G-code, for a future toolpath. Null if a template needs the toolpath.</summary>
    internal static GCodeFormat? OfUnknown(PrintSetup setup)
    {
        var problems = new DiagnosticList();
        var format = Format(setup, null, false, new Layer(0, 0, 0, ""), problems);
        return problems.HasErrors ? null : format;
    }

    private static GCodeFormat Format(PrintSetup setup, Toolpath? toolpath, bool hasEnd, Layer? first, DiagnosticList problems)
    {
        var printer = setup.Printer;
        var values = PrintValues.Of(setup, toolpath);
        var start = Lines(printer, "start_gcode", printer.StartGCode, values, problems);
        var end = hasEnd ? Lines(printer, "end_gcode", printer.EndGCode, values, problems) : [];
        var layers = Template(printer, "layer_change_gcode", printer.LayerChangeGCode, problems);
        var tools = Template(printer, "tool_change_gcode", printer.ToolChangeGCode, problems);
        TemplateValues[] ofTools = tools is null ? [] : [.. Enumerable.Range(0, printer.ToolCount).Select(tool => PrintValues.Of(setup, toolpath, tool))];
        // Layer and tool templates are tried once with the values of the first, so that an error is found before anything is written.
        if (layers is not null && first is not null) problems.AddRange(layers.Render(OfLayer(values, first)).Diagnostics);
        if (tools is not null) problems.AddRange(tools.Render(OfTools(values, 0, 0)).Diagnostics);
        return new GCodeFormat(printer)
        {
            Header = Header(setup),
            Start = start,
            End = end,
            LayerLines = layers is null ? null : layer => layers.Render(OfLayer(values, layer)).Value ?? [],
            ToolLines = tools is null ? null : (from, to) => tools.Render(OfTools(to < ofTools.Length ? ofTools[to] : values, from, to)).Value ?? [],
        };
    }

    // The unit of E is stated as slicers state it, so that the extrusions can be measured in the file.
    private static string[] Header(PrintSetup setup)
    {
        Material[] materials = [setup.Material, .. setup.ToolMaterials];
        string[] header = [FileComments.Producer, "Flavor " + setup.Printer.Flavor.Name,
            $"Printer {setup.Printer.Name}, material {string.Join(" + ", materials.Select(m => m.Name))}, settings {setup.Settings.Name}"];
        if (setup.Printer.AxisMappings.Count > 0) header = [.. header, DecodedGCode.MappingsKey + " = " + string.Join(", ", setup.Printer.AxisMappings)];
        if (setup.Printer.RotaryAxes.Count > 0)
        {
            var positions = Words.Snake(setup.Printer.RotaryPositions.ToString());
            header = [.. header, $"{DecodedGCode.AxesKey} = {string.Join(", ", setup.Printer.RotaryAxes)}", $"{DecodedGCode.PositionsKey} = {positions}"];
        }
        return setup.Printer.ExtrusionUnit switch
        {
            ExtrusionUnit.Mm => [.. header, "filament_diameter = " + string.Join(",", materials.Select(m => NumberFormatter.Format(m.FilamentDiameter, 4)))],
            ExtrusionUnit.Mm3 => [.. header, "use_volumetric_e = 1"],
            _ => header,
        };
    }

    private static TemplateValues OfTools(TemplateValues values, int from, int to) => values.With("tool", to).With("previous_tool", from);

    private static TemplateValues OfLayer(TemplateValues values, Layer layer) => values.With("layer", layer.Index).With("layer_z_mm", layer.Z);

    private static IReadOnlyList<string> Lines(Printer printer, string key, IReadOnlyList<string> lines, TemplateValues values, DiagnosticList problems)
    {
        if (Template(printer, key, lines, problems) is not { } template) return [];
        var rendered = template.Render(values);
        problems.AddRange(rendered.Diagnostics);
        return rendered.Value ?? [];
    }

    private static Template? Template(Printer printer, string key, IReadOnlyList<string> lines, DiagnosticList problems)
    {
        if (lines.Count == 0) return null;
        var template = PrintTemplate.Parse(lines, new SourceLocation(printer.Name, Key: key));
        problems.AddRange(template.Diagnostics);
        return template.Value;
    }
}
