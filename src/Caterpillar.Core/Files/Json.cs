namespace Caterpillar.Files;

/// <summary>Makes JSON.</summary>
internal static class Json
{
    /// <summary>An object of the entries that have a value.</summary>
    public static JObject Object(params (string Name, JToken? Value)[] entries)
        => new(entries.Where(e => e.Value is { Type: not JTokenType.Null }).Select(e => new JProperty(e.Name, e.Value)));

    /// <summary>A number with up to six decimals; null if it is null or not finite.</summary>
    public static JToken Number(double? value)
        => value is { } known && !double.IsNaN(known - known) ? new JRaw(NumberFormatter.Format(known, 6)) : JValue.CreateNull();

    /// <summary>The text of a value, with a line for each entry.</summary>
    public static string Text(JToken value)
    {
        using var text = new StringWriter { NewLine = "\n" };
        using (var json = new JsonTextWriter(text) { Formatting = Formatting.Indented }) value.WriteTo(json);
        return text + "\n";
    }
}
