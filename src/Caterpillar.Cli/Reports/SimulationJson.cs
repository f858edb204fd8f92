namespace Caterpillar.Cli;

/// <summary>Statistics and states as JSON: snake_case keys with their units; null = unknown.</summary>
internal static class SimulationJson
{
    /// <summary>A JSON array of objects.</summary>
    public static string Array(IEnumerable<JObject> items) => Json.Text(List(items));

    public static JObject Statistics(string file, PrintStatistics s, Toolpath toolpath, string limits) => new()
    {
        ["file"] = file,
        ["limits"] = limits,
        ["time_s"] = Number(s.Duration),
        ["print_time_s"] = Number(s.PrintTime),
        ["travel_time_s"] = Number(s.TravelTime),
        ["extruder_time_s"] = Number(s.ExtruderTime),
        ["heating_s"] = Number(s.Waits.Heating),
        ["dwells_s"] = Number(s.Waits.Dwells),
        ["tool_changes_s"] = Number(s.Waits.ToolChanges),
        ["homing_s"] = Number(s.Waits.Homing),
        ["moves"] = s.Moves,
        ["retractions"] = s.Retractions,
        ["print_length_mm"] = Number(s.PrintLength),
        ["travel_length_mm"] = Number(s.TravelLength),
        ["filament_mm"] = Number(s.Filament),
        ["volume_mm3"] = Number(s.Volume),
        ["mass_g"] = Number(s.Mass),
        ["cost"] = Number(s.Cost),
        ["peak_flow_mm3_s"] = Number(s.GreatestFlow),
        ["peak_flow_move"] = Number(s.GreatestFlow is null ? null : s.GreatestFlowMove),
        ["peak_speed_mm_s"] = Number(s.GreatestSpeed),
        ["print_box_mm"] = s.PrintBounds.IsEmpty ? null : new JArray(Point(s.PrintBounds.Min), Point(s.PrintBounds.Max)),
        ["roles"] = List(s.Roles.Select(r => new JObject
        {
            ["role"] = Word(r.Role), ["time_s"] = Number(r.Time), ["length_mm"] = Number(r.Length), ["volume_mm3"] = Number(r.Volume),
        })),
        ["tools"] = List(s.Tools.Select(t => new JObject
        {
            ["tool"] = t.Tool,
            ["time_s"] = Number(t.Time),
            ["filament_mm"] = Number(t.Filament),
            ["volume_mm3"] = Number(t.Volume),
            ["mass_g"] = Number(t.Mass),
        })),
        ["layers"] = List(s.Layers.Select(l => Layer(l, toolpath.Layers[l.Layer]))),
    };

    public static JObject State(MachineState s, Toolpath toolpath) => new()
    {
        ["time_s"] = Number(s.Time),
        ["time_left_s"] = Number(s.TimeLeft),
        ["move"] = s.Move,
        ["done"] = Number(s.Done),
        [toolpath.Source == MoveSource.Lines ? "line" : "step"] = s.Source,
        ["waits"] = s.Waits,
        ["kind"] = Word(s.Kind),
        ["role"] = Word(s.Role),
        ["position_mm"] = Point(s.Position),
        ["direction"] = Point(s.Direction),
        ["speed_mm_s"] = Number(s.Speed),
        ["flow_mm3_s"] = Number(s.Flow),
        ["layer"] = s.Layer < 0 ? null : toolpath.Layers[s.Layer].Index,
        ["tool"] = s.Tool,
        ["nozzle_c"] = Number(s.NozzleTemperature),
        ["nozzle_target_c"] = Number(s.NozzleTarget),
        ["bed_c"] = Number(s.BedTemperature),
        ["bed_target_c"] = Number(s.BedTarget),
        ["fan"] = Number(s.Fan),
        ["length_mm"] = Number(s.Length),
        ["e"] = Number(s.Filament),
        ["volume_mm3"] = Number(s.Volume),
    };

    private static JObject Layer(LayerTime time, Layer layer)
    {
        var json = new JObject { ["index"] = layer.Index };
        if (layer.Object.Length > 0) json["object"] = layer.Object;
        json["z_mm"] = Number(layer.Z);
        json["start_s"] = Number(time.Start);
        json["time_s"] = Number(time.Time);
        json["print_length_mm"] = Number(time.Length);
        json["volume_mm3"] = Number(time.Volume);
        return json;
    }

    private static JArray List(IEnumerable<JObject> items) => new(items);

    private static JArray Point(Vec3 p) => new(Number(p.X), Number(p.Y), Number(p.Z));

    private static string Word<T>(T value)
        where T : struct, Enum
        => Words.Snake(value.ToString());

    private static JToken Number(double? value) => Json.Number(value);
}
