namespace Caterpillar.Machines;

/// <summary>Writes raw values as JSON text: numbers by <see cref="NumberFormatter"/>, one entry per line in objects, lists of numbers on one line.</summary>
internal static class ProfileJson
{
    public static string Write(IEnumerable<KeyValuePair<string, object>> entries) => Json.Text(Token(entries));

    private static JToken Token(object value) => value switch
    {
        IEnumerable<KeyValuePair<string, object>> entries => new JObject(entries.Select(e => new JProperty(e.Key, Token(e.Value)))),
        IReadOnlyList<object> { Count: > 0 } list when list[0] is string => new JArray(list.Select(Token)),
        double or IReadOnlyList<object> => new JRaw(OnOneLine(value)),
        _ => new JValue(value),
    };

    private static string OnOneLine(object value)
        => value is double number ? NumberFormatter.Shortest(number) : "[" + string.Join(", ", ((IReadOnlyList<object>)value).Select(OnOneLine)) + "]";
}
