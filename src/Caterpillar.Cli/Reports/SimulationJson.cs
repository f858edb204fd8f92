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
        ["time_s"] = Json.Number(s.Duration),
        ["print_time_s"] = Json.Number(s.PrintTime),
        ["travel_time_s"] = Json.Number(s.TravelTime),
        ["extruder_time_s"] = Json.Number(s.ExtruderTime),
        ["heating_s"] = Json.Number(s.Waits.Heating),
        ["dwells_s"] = Json.Number(s.Waits.Dwells),
        ["tool_changes_s"] = Json.Number(s.Waits.ToolChanges),
        ["homing_s"] = Json.Number(s.Waits.Homing),
        ["moves"] = s.Moves,
        ["retractions"] = s.Retractions,
        ["print_length_mm"] = Json.Number(s.PrintLength),
        ["travel_length_mm"] = Json.Number(s.TravelLength),
        ["filament_mm"] = Json.Number(s.Filament),
        ["volume_mm3"] = Json.Number(s.Volume),
        ["mass_g"] = Json.Number(s.Mass),
        ["cost"] = Json.Number(s.Cost),
        ["peak_flow_mm3_s"] = Json.Number(s.GreatestFlow),
        ["peak_flow_move"] = Json.Number(s.GreatestFlow is null ? null : s.GreatestFlowMove),
        ["peak_speed_mm_s"] = Json.Number(s.GreatestSpeed),
        ["print_box_mm"] = s.PrintBounds.IsEmpty ? null : new JArray(Point(s.PrintBounds.Min), Point(s.PrintBounds.Max)),
        ["roles"] = List(s.Roles.Select(r => new JObject
        {
            ["role"] = Word(r.Role), ["time_s"] = Json.Number(r.Time), ["length_mm"] = Json.Number(r.Length), ["volume_mm3"] = Json.Number(r.Volume),
        })),
        ["tools"] = List(s.Tools.Select(t => new JObject
        {
            ["tool"] = t.Tool,
            ["time_s"] = Json.Number(t.Time),
            ["filament_mm"] = Json.Number(t.Filament),
            ["volume_mm3"] = Json.Number(t.Volume),
            ["mass_g"] = Json.Number(t.Mass),
        })),
        ["layers"] = List(s.Layers.Select(l => Layer(l, toolpath.Layers[l.Layer]))),
    };

    public static JObject State(MachineState s, Toolpath toolpath) => new()
    {
        ["time_s"] = Json.Number(s.Time),
        ["time_left_s"] = Json.Number(s.TimeLeft),
        ["move"] = s.Move,
        ["done"] = Json.Number(s.Done),
        [toolpath.Source == MoveSource.Lines ? "line" : "step"] = s.Source,
        ["waits"] = s.Waits,
        ["kind"] = Word(s.Kind),
        ["role"] = Word(s.Role),
        ["position_mm"] = Point(s.Position),
        ["direction"] = Point(s.Direction),
        ["speed_mm_s"] = Json.Number(s.Speed),
        ["flow_mm3_s"] = Json.Number(s.Flow),
        ["layer"] = s.Layer < 0 ? null : toolpath.Layers[s.Layer].Index,
        ["tool"] = s.Tool,
        ["nozzle_c"] = Json.Number(s.NozzleTemperature),
        ["nozzle_target_c"] = Json.Number(s.NozzleTarget),
        ["bed_c"] = Json.Number(s.BedTemperature),
        ["bed_target_c"] = Json.Number(s.BedTarget),
        ["fan"] = Json.Number(s.Fan),
        ["length_mm"] = Json.Number(s.Length),
        ["e"] = Json.Number(s.Filament),
        ["volume_mm3"] = Json.Number(s.Volume),
    };

    private static JObject Layer(LayerTime time, Layer layer)
    {
        var json = new JObject { ["index"] = layer.Index };
        if (layer.Object.Length > 0) json["object"] = layer.Object;
        json["z_mm"] = Json.Number(layer.Z);
        json["start_s"] = Json.Number(time.Start);
        json["time_s"] = Json.Number(time.Time);
        json["print_length_mm"] = Json.Number(time.Length);
        json["volume_mm3"] = Json.Number(time.Volume);
        return json;
    }

    private static JArray List(IEnumerable<JObject> items) => new(items);

    private static JArray Point(Vec3 p) => new(Json.Number(p.X), Json.Number(p.Y), Json.Number(p.Z));

    private static string Word<T>(T value)
        where T : struct, Enum
        => Words.Snake(value.ToString());
}
