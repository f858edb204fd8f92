namespace Caterpillar.Drawings;

/// <summary>Settings of curves from the attributes of elements, mm, mm² and mm/s. The values are area, width, height, speed and flow.</summary>
internal sealed record SvgSettings(double?[] Values, double Z, int Tool, int? Layer, string Name)
{
    /// <summary>No settings.</summary>
    public static SvgSettings None => new(new double?[5], 0, 0, null, "");

    /// <summary>The settings of the current element and the elements around it. Null after an error.</summary>
    public SvgSettings? Inside(SvgXml xml, CurveReadOptions options)
    {
        var values = (double?[])Values.Clone();
        string[] names = ["data-area", "data-width", "data-height", "data-speed", "data-flow"];
        for (var i = 0; i < names.Length; i++)
        {
            if (xml.Attribute(names[i]) is not { } text) continue;
            if (Value(text, CurveColumns.Whole(CurveColumn.Area + i, options)) is not (>= 0 and var value))
                return xml.Fail<SvgSettings>(names[i], "Settings of an extrusion must be numbers of 0 or more, or percentages with a known reference.");
            values[i] = value;
        }
        var (z, tool, layer) = (Z, Tool, Layer);
        if (xml.Attribute("data-z") is { } height)
        {
            if (Value(height, 0) is not { } value) return xml.Fail<SvgSettings>("data-z", "The height must be a number in mm.");
            z = value;
        }
        if (xml.Attribute("data-tool") is { } toolText && (!NumberReader.TryParseInt(toolText.Trim(), out tool) || tool is < 0 or > 1000))
            return xml.Fail<SvgSettings>("data-tool", "The tool must be a number from 0 to 1000.");
        if (xml.Attribute("data-layer") is { } layerText)
        {
            if (!NumberReader.TryParseInt(layerText.Trim(), out var number)) return xml.Fail<SvgSettings>("data-layer", "The layer must be an integer.");
            layer = number;
        }
        return new SvgSettings(values, z, tool, layer, xml.Attribute("data-name") ?? xml.Attribute("id") ?? "");
    }

    private static double? Value(string text, double reference)
    {
        text = text.Trim();
        if (!text.EndsWith("%", StringComparison.Ordinal)) return NumberReader.TryParse(text, out var plain) && Math.Abs(plain) <= 1e9 ? plain : null;
        return reference > 0 && NumberReader.TryParse(text.Substring(0, text.Length - 1).Trim(), out var percent) ? percent / 100 * reference : null;
    }

    /// <summary>A curve with these settings.</summary>
    public UserCurve Of(Curve curve, SourceLocation place) => CurveColumns.With(new UserCurve(curve), Values) with
    {
        Name = Name,
        Tool = Tool,
        Layer = Layer is { } layer ? new Layer(layer, curve.Bounds.Max.Z) : null,
        Source = place,
    };
}
