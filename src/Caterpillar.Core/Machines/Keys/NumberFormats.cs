namespace Caterpillar.Machines;

/// <summary>A number in a range.</summary>
internal class NumberFormat(double min, double max, double leastAboveZero = 0, string expected = "a number")
    : KeyFormat<double>(KeyKind.Number, expected)
{
    /// <summary>Schema of a number in a range, or of a text with a pattern.</summary>
    public static IReadOnlyList<KeyValuePair<string, object>> OrText(double min, double max, string pattern)
        => [new("type", new object[] { "number", "string" }), new("minimum", min), new("maximum", max), new("pattern", pattern)];

    public override string Range => RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "number"), new("minimum", min), new("maximum", max)];

    public override object? Parse(string text) => NumberReader.TryParse(text.Trim(), out var value) ? value : null;

    public override bool Fits(object raw) => raw is double;

    public override double Read(object raw) => (double)raw;

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

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => NumberFormat.OrText(min, max, "^$");

    public override object? Parse(string text) => text.Trim().Length == 0 ? "" : _number.Parse(text);

    public override bool Fits(object raw) => raw is double or "";

    public override double? Read(object raw) => raw as double?;

    public override object Write(double? value) => value is { } number ? number : "";

    public override string? Problem(double? value) => value is { } number ? _number.Problem(number) : null;
}

/// <summary>
/// A size in mm, or in % of the nozzle diameter: 120%. Print settings keep percentages as negative shares, and give the size for their nozzle.
/// </summary>
internal sealed class NozzleSizeFormat() : NumberFormat(0, 1000, 0.001, "a number, or a percentage of the nozzle diameter")
{
    public override IReadOnlyList<KeyValuePair<string, object>> Schema => OrText(0, 1000, "^[0-9.]+ ?%$");

    public override object? Parse(string text) => Percent(text.Trim()) is null ? base.Parse(text) : text.Trim();

    public override bool Fits(object raw) => raw is double || Percent(raw) is not null;

    public override double Read(object raw) => Percent(raw) is { } percent ? -percent / 100 : (double)raw < 0 ? double.NaN : (double)raw;

    public override object Write(double value) => value < 0 ? NumberFormatter.Format(-value * 100, 6) + "%" : value;

    public override string? Problem(double value) => value is >= -10 and < 0 ? null : value < 0 ? "must be at most 1000%" : base.Problem(value);

    private static double? Percent(object raw)
        => raw is string text && text.EndsWith("%", StringComparison.Ordinal)
            && NumberReader.TryParse(text.Substring(0, text.Length - 1).Trim(), out var percent) && percent > 0 ? percent : null;
}

/// <summary>An integer in a range.</summary>
internal sealed class IntegerFormat(int min, int max) : KeyFormat<int>(KeyKind.Integer, "an integer")
{
    public override string Range => RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "integer"), new("minimum", (double)min), new("maximum", (double)max)];

    public override object? Parse(string text) => NumberReader.TryParse(text.Trim(), out var value) ? value : null;

    public override bool Fits(object raw) => raw is double number && number == Math.Floor(number) && Math.Abs(number) <= int.MaxValue;

    public override int Read(object raw) => (int)(double)raw;

    public override object Write(int value) => (double)value;

    public override string? Problem(int value) => value >= min && value <= max ? null : "must be " + Range + ", not " + NumberFormatter.Format(value);
}
