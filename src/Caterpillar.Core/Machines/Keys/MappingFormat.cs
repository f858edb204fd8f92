namespace Caterpillar.Machines;

/// <summary>A list of mapped axes as texts.</summary>
internal sealed class MappingFormat() : KeyFormat<ValueList<AxisMapping>>(KeyKind.Lines, "a list of texts such as \"X=A*2.86\"")
{
    public override string Range => "a list of AXIS=WORD*SCALE";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema =>
    [
        new("type", "array"),
        new("items", new KeyValuePair<string, object>[] { new("type", "string"), new("pattern", "^[XYZ]=[ABCXYZ]\\*[-0-9.]+(@[-0-9.]+)?$") }),
    ];

    public override object? Parse(string text)
        => text.Trim().Length == 0 ? Array.Empty<object>() : text.Split(',', '\n').Select(t => (object)t.Trim()).ToArray();

    public override bool TryRead(object raw, out ValueList<AxisMapping>? value)
    {
        value = null;
        if (raw is not IReadOnlyList<object> list) return false;
        var mappings = list.Select(t => t is string text ? AxisMapping.Parse(text) : null).ToArray();
        if (Array.IndexOf(mappings, null) >= 0) return false;
        value = new ValueList<AxisMapping>(mappings!);
        return true;
    }

    public override object Write(ValueList<AxisMapping> value) => value.Select(v => (object)v.ToString()).ToArray();

    public override string? Problem(ValueList<AxisMapping> value)
        => value.Select(m => m.From).Distinct().Count() == value.Count ? null : "maps a coordinate twice";
}
