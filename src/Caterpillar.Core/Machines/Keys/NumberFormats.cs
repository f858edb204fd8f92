namespace Caterpillar.Machines;

/// <summary>A number in a range.</summary>
internal sealed class NumberFormat(double min, double max, double leastAboveZero = 0) : KeyFormat<double>(KeyKind.Number, "a number")
{
    public override string Range => RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "number"), new("minimum", min), new("maximum", max)];

    public override object? Parse(string text) => NumberReader.TryParse(text.Trim(), out var value) ? value : null;

    public override bool TryRead(object raw, out double value)
    {
        value = raw is double number ? number : 0;
        return raw is double;
    }

    public override object Write(double value) => value;

    public override string? Problem(double value)
    {
        if (value > 0 && value < leastAboveZero) return "must be 0 or at least " + NumberFormatter.Shortest(leastAboveZero) + ", not " + Shown(value);
        return value >= min && value <= max ? null : "must be " + Range + (double.IsNaN(value) ? "" : ", not " + Shown(value));
    }

    private static string Shown(double value) => double.IsInfinity(value) ? "infinite" : NumberFormatter.Shortest(value);
}

/// <summary>A number in a range, or nothing: an empty text.</summary>
internal sealed class OptionalNumberFormat(double min, double max) : KeyFormat<double?>(KeyKind.Number, "a number, or an empty text")
{
    private readonly NumberFormat _number = new(min, max);

    public override string Range => _number.Range + ", or empty";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema
        => [new("type", new object[] { "number", "string" }), new("minimum", min), new("maximum", max), new("maxLength", 0.0)];

    public override object? Parse(string text) => text.Trim().Length == 0 ? "" : _number.Parse(text);

    public override bool TryRead(object raw, out double? value)
    {
        value = raw as double?;
        return raw is double or "";
    }

    public override object Write(double? value) => value is { } number ? number : "";

    public override string? Problem(double? value) => value is { } number ? _number.Problem(number) : null;
}

/// <summary>An integer in a range.</summary>
internal sealed class IntegerFormat(int min, int max) : KeyFormat<int>(KeyKind.Integer, "an integer")
{
    public override string Range => RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "integer"), new("minimum", (double)min), new("maximum", (double)max)];

    public override object? Parse(string text) => NumberReader.TryParse(text.Trim(), out var value) ? value : null;

    public override bool TryRead(object raw, out int value)
    {
        var whole = raw is double number && number == Math.Floor(number) && Math.Abs(number) <= int.MaxValue;
        value = whole ? (int)(double)raw : 0;
        return whole;
    }

    public override object Write(int value) => (double)value;

    public override string? Problem(int value) => value >= min && value <= max ? null : "must be " + Range + ", not " + NumberFormatter.Format(value);
}
