namespace Caterpillar.Machines;

/// <summary>Values for templates: all numbers and words of the three profiles by their keys, and values of the print.</summary>
internal static class PrintValues
{
    /// <summary>The values of a setup, and of the print if a toolpath is given; keys of materials are those of a tool.</summary>
    public static TemplateValues Of(PrintSetup whole, Toolpath? toolpath = null, int tool = 0)
    {
        var setup = whole.OfTool(tool);
        var numbers = new Dictionary<string, double>(StringComparer.Ordinal);
        var texts = new Dictionary<string, string>(StringComparer.Ordinal);
        Take(ProfileKinds.Printer.Keys, setup.Printer, numbers, texts);
        Take(ProfileKinds.Material.Keys, setup.Material, numbers, texts);
        Take(ProfileKinds.Settings.Keys, setup.Settings, numbers, texts);
        texts["printer_name"] = setup.Printer.Name;
        texts["material_name"] = setup.Material.Name;
        texts["settings_name"] = setup.Settings.Name;
        var material = setup.Material;
        numbers["start_nozzle_temperature_c"] = material.FirstLayerNozzleTemperature > 0 ? material.FirstLayerNozzleTemperature : material.NozzleTemperature;
        numbers["start_bed_temperature_c"] = material.FirstLayerBedTemperature > 0 ? material.FirstLayerBedTemperature : material.BedTemperature;
        numbers["material_retraction_length_mm"] = setup.RetractionLength;
        numbers["material_retraction_speed_mm_s"] = setup.RetractionSpeed;
        numbers["material_z_hop_mm"] = setup.ZHop;
        numbers["material_wipe_distance_mm"] = setup.WipeDistance;
        var bed = setup.Printer.BuildBounds;
        numbers["bed_min_x_mm"] = bed.Min.X;
        numbers["bed_min_y_mm"] = bed.Min.Y;
        numbers["bed_max_x_mm"] = bed.Max.X;
        numbers["bed_max_y_mm"] = bed.Max.Y;
        numbers["bed_max_z_mm"] = bed.Max.Z;
        numbers["volume_per_e_mm3"] = setup.Extrusion.VolumePerE ?? 0;
        numbers["tool_count"] = setup.Printer.ToolCount;
        return new TemplateValues(numbers, texts, toolpath is null ? null : new(() => Measure(toolpath, whole)));
    }

    private static void Take<T>(IReadOnlyList<ProfileKey<T>> keys, T profile, Dictionary<string, double> numbers, Dictionary<string, string> texts)
        where T : class
    {
        foreach (var key in keys)
        {
            switch (key.Kind)
            {
                case KeyKind.Number or KeyKind.Integer: numbers[key.Name] = key.Get(profile) as double? ?? 0; break;
                case KeyKind.Boolean: numbers[key.Name] = (bool)key.Get(profile) ? 1 : 0; break;
                case KeyKind.Choice: texts[key.Name] = (string)key.Get(profile); break;
            }
        }
    }

    private static Dictionary<string, double> Measure(Toolpath toolpath, PrintSetup setup)
    {
        var numbers = new Dictionary<string, double>(StringComparer.Ordinal);
        var bounds = ToolpathTotals.Of(toolpath) is { PrintMoves: > 0 } totals ? totals.PrintBounds : Bounds.Empty;
        double volume = 0, filament = 0, mass = 0, cost = 0;
        var tools = Enumerable.Range(0, Math.Max(toolpath.Tools.Count, 1)).Select(setup.OfTool).Select(s => (s.Material, s.Extrusion.FilamentPerE)).ToArray();
        foreach (var c in toolpath.Blocks.Select(b => b.Columns))
        {
            for (var i = 0; i < c.Count; i++)
            {
                if (c.Deposited[i] == 0) continue;
                var (material, length) = tools[Math.Min(c.Tool[i], tools.Length - 1)];
                var added = toolpath.VolumePerE(c.Tool[i]) * c.Deposited[i] ?? 0;
                volume += added;
                filament += c.Deposited[i] * length;
                mass += added / 1000 * material.Density;
                cost += added / 1_000_000 * material.Density * material.CostPerKg;
            }
        }
        numbers["layer_count"] = toolpath.CountLayers();
        numbers["print_min_x_mm"] = bounds.Min.X;
        numbers["print_min_y_mm"] = bounds.Min.Y;
        numbers["print_min_z_mm"] = bounds.Min.Z;
        numbers["print_max_x_mm"] = bounds.Max.X;
        numbers["print_max_y_mm"] = bounds.Max.Y;
        numbers["print_max_z_mm"] = bounds.Max.Z;
        numbers["material_used_mm3"] = volume;
        numbers["filament_used_mm"] = filament;
        numbers["material_used_g"] = mass;
        numbers["material_cost"] = cost;
        return numbers;
    }
}
