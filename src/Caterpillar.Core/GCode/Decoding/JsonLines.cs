namespace Caterpillar.GCode;

/// <summary>A JSON object with one entry per line, written without a library so that numbers keep our format.</summary>
internal sealed class JsonLines
{
    private const int Decimals = 5;
    private readonly StringBuilder _text = new();
    private readonly string _indent;

    public JsonLines(string indent)
    {
        _indent = indent;
        _text.Append('{');
    }

    public void Raw(string key, string value)
        => _text.Append(_text.Length > 1 ? ",\n" : "\n").Append(_indent).Append("  \"").Append(key).Append("\": ").Append(value);

    public void Number(string key, long value) => Raw(key, NumberFormatter.Format(value));

    /// <summary>Numbers with their keys.</summary>
    public void Numbers(IEnumerable<KeyValuePair<string, double?>> numbers)
    {
        foreach (var pair in numbers) Raw(pair.Key, pair.Value is { } value ? Number(value) : "null");
    }

    public void Text(string key, string value) => Raw(key, Quoted(value));

    public static string Quoted(string value) => Newtonsoft.Json.JsonConvert.ToString(value);

    public override string ToString() => _text.ToString() + "\n" + _indent + "}";

    public static string Number(double value) => NumberFormatter.Format(value, Decimals);

    public static string Point(Vec3 p) => "[" + Number(p.X) + ", " + Number(p.Y) + ", " + Number(p.Z) + "]";

    public static string Box(Bounds box) => box.IsEmpty ? "null" : "[" + Point(box.Min) + ", " + Point(box.Max) + "]";
}
