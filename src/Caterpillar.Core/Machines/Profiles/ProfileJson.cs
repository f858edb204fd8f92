namespace Caterpillar.Machines;

/// <summary>Writes raw values as JSON text: numbers by <see cref="NumberFormatter"/>, one entry per line in objects, lists of numbers on one line.</summary>
internal static class ProfileJson
{
    public static string Write(IEnumerable<KeyValuePair<string, object>> entries)
    {
        var text = new StringWriter { NewLine = "\n" };
        using (var json = new JsonTextWriter(text) { Formatting = Formatting.Indented }) Write(json, entries);
        return text + "\n";
    }

    private static void Write(JsonTextWriter json, object value)
    {
        switch (value)
        {
            case IEnumerable<KeyValuePair<string, object>> entries:
                json.WriteStartObject();
                foreach (var entry in entries)
                {
                    json.WritePropertyName(entry.Key);
                    Write(json, entry.Value);
                }
                json.WriteEndObject();
                break;
            case IReadOnlyList<object> list when list.Count > 0 && list[0] is string:
                json.WriteStartArray();
                foreach (var item in list) Write(json, item);
                json.WriteEndArray();
                break;
            case double or IReadOnlyList<object>: json.WriteRawValue(OnOneLine(value)); break;
            default: json.WriteValue(value); break;
        }
    }

    private static string OnOneLine(object value)
        => value is double number ? NumberFormatter.Shortest(number) : "[" + string.Join(", ", ((IReadOnlyList<object>)value).Select(OnOneLine)) + "]";
}
