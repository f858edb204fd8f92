using System.Buffers;
using System.Text.Json;

namespace Caterpillar.Cli;

/// <summary>Statistics and states as JSON: snake_case keys with their units; null = unknown.</summary>
internal static class SimulationJson
{
    /// <summary>A JSON array with one object for each item.</summary>
    public static string Array<T>(System.Collections.Generic.IEnumerable<T> items, Action<Utf8JsonWriter, T> write)
    {
        var buffer = new ArrayBufferWriter<byte>();
        var options = new JsonWriterOptions { Indented = true, Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
        using (var json = new Utf8JsonWriter(buffer, options))
        {
            json.WriteStartArray();
            foreach (var item in items)
            {
                json.WriteStartObject();
                write(json, item);
                json.WriteEndObject();
            }
            json.WriteEndArray();
        }
        return Encoding.UTF8.GetString(buffer.WrittenSpan).Replace("\r\n", "\n") + "\n";
    }

    public static void Statistics(Utf8JsonWriter json, string file, PrintStatistics s, Toolpath toolpath, string limits)
    {
        json.WriteString("file", file);
        json.WriteString("limits", limits);
        Number(json, "time_s", s.Duration);
        Number(json, "print_time_s", s.PrintTime);
        Number(json, "travel_time_s", s.TravelTime);
        Number(json, "extruder_time_s", s.ExtruderTime);
        Number(json, "heating_s", s.Waits.Heating);
        Number(json, "dwells_s", s.Waits.Dwells);
        Number(json, "tool_changes_s", s.Waits.ToolChanges);
        Number(json, "homing_s", s.Waits.Homing);
        json.WriteNumber("moves", s.Moves);
        json.WriteNumber("retractions", s.Retractions);
        Number(json, "print_length_mm", s.PrintLength);
        Number(json, "travel_length_mm", s.TravelLength);
        Number(json, "filament_mm", s.Filament);
        Number(json, "volume_mm3", s.Volume);
        Number(json, "mass_g", s.Mass);
        Number(json, "cost", s.Cost);
        Number(json, "peak_flow_mm3_s", s.GreatestFlow);
        Number(json, "peak_flow_move", s.GreatestFlow is null ? null : s.GreatestFlowMove);
        Number(json, "peak_speed_mm_s", s.GreatestSpeed);
        if (s.PrintBounds.IsEmpty) json.WriteNull("print_box_mm");
        else Box(json, s.PrintBounds);
        List(json, "roles", s.Roles, r =>
        {
            json.WriteString("role", JsonNamingPolicy.SnakeCaseLower.ConvertName(r.Role.ToString()));
            Number(json, "time_s", r.Time);
            Number(json, "length_mm", r.Length);
            Number(json, "volume_mm3", r.Volume);
        });
        List(json, "tools", s.Tools, t =>
        {
            json.WriteNumber("tool", t.Tool);
            Number(json, "time_s", t.Time);
            Number(json, "filament_mm", t.Filament);
            Number(json, "volume_mm3", t.Volume);
            Number(json, "mass_g", t.Mass);
        });
        List(json, "layers", s.Layers, l =>
        {
            var layer = toolpath.Layers[l.Layer];
            json.WriteNumber("index", layer.Index);
            if (layer.Object.Length > 0) json.WriteString("object", layer.Object);
            Number(json, "z_mm", layer.Z);
            Number(json, "start_s", l.Start);
            Number(json, "time_s", l.Time);
            Number(json, "print_length_mm", l.Length);
            Number(json, "volume_mm3", l.Volume);
        });
    }

    public static void State(Utf8JsonWriter json, MachineState s, Toolpath toolpath)
    {
        Number(json, "time_s", s.Time);
        Number(json, "time_left_s", s.TimeLeft);
        json.WriteNumber("move", s.Move);
        Number(json, "done", s.Done);
        json.WriteNumber(toolpath.Source == MoveSource.Lines ? "line" : "step", s.Source);
        json.WriteBoolean("waits", s.Waits);
        json.WriteString("kind", JsonNamingPolicy.SnakeCaseLower.ConvertName(s.Kind.ToString()));
        json.WriteString("role", JsonNamingPolicy.SnakeCaseLower.ConvertName(s.Role.ToString()));
        Point(json, "position_mm", s.Position);
        Point(json, "direction", s.Direction);
        Number(json, "speed_mm_s", s.Speed);
        Number(json, "flow_mm3_s", s.Flow);
        if (s.Layer < 0) json.WriteNull("layer");
        else json.WriteNumber("layer", toolpath.Layers[s.Layer].Index);
        json.WriteNumber("tool", s.Tool);
        Number(json, "nozzle_c", s.NozzleTemperature);
        Number(json, "nozzle_target_c", s.NozzleTarget);
        Number(json, "bed_c", s.BedTemperature);
        Number(json, "bed_target_c", s.BedTarget);
        Number(json, "fan", s.Fan);
        Number(json, "length_mm", s.Length);
        Number(json, "e", s.Filament);
        Number(json, "volume_mm3", s.Volume);
    }

    private static void List<T>(Utf8JsonWriter json, string name, System.Collections.Generic.IReadOnlyList<T> items, Action<T> write)
    {
        json.WriteStartArray(name);
        foreach (var item in items)
        {
            json.WriteStartObject();
            write(item);
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    private static void Box(Utf8JsonWriter json, Bounds box)
    {
        json.WriteStartArray("print_box_mm");
        Values(json, box.Min);
        Values(json, box.Max);
        json.WriteEndArray();
    }

    private static void Point(Utf8JsonWriter json, string name, Vec3 p)
    {
        json.WritePropertyName(name);
        Values(json, p);
    }

    private static void Values(Utf8JsonWriter json, Vec3 p)
    {
        json.WriteStartArray();
        json.WriteNumberValue(Math.Round(p.X, 6));
        json.WriteNumberValue(Math.Round(p.Y, 6));
        json.WriteNumberValue(Math.Round(p.Z, 6));
        json.WriteEndArray();
    }

    private static void Number(Utf8JsonWriter json, string name, double? value)
    {
        if (value is { } known && double.IsFinite(known)) json.WriteNumber(name, Math.Round(known, 6));
        else json.WriteNull(name);
    }
}
