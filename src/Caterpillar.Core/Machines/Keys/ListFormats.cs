namespace Caterpillar.Machines;

/// <summary>A value from a list of numbers of fixed length.</summary>
internal sealed class NumbersFormat<TValue>(string[] parts, double min, double max, Func<double[], TValue> make, Func<TValue, double[]> take)
    : KeyFormat<TValue>(KeyKind.Numbers, $"a list of {parts.Length} numbers [{string.Join(", ", parts)}]")
{
    public override string Range => "[" + string.Join(", ", parts) + "], each " + RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => ListSchema(parts.Length, min, max);

    public override object? Parse(string text) => RawValues.ParseNumbers(text);

    public override bool Fits(object raw) => RawValues.Numbers(raw, parts.Length) is not null;

    public override TValue Read(object raw) => make(RawValues.Numbers(raw, parts.Length)!);

    public override object Write(TValue value) => RawValues.List(take(value));

    public override string? Problem(TValue value)
        => Array.TrueForAll(take(value), n => n >= min && n <= max) ? null : "must have numbers of " + RawValues.Range(min, max);

    internal static IReadOnlyList<KeyValuePair<string, object>> ListSchema(int count, double min, double max) =>
    [
        new("type", "array"),
        new("items", new KeyValuePair<string, object>[] { new("type", "number"), new("minimum", min), new("maximum", max) }),
        new("minItems", (double)count),
        new("maxItems", (double)count),
    ];
}

/// <summary>A list of rows of numbers.</summary>
internal sealed class RowsFormat<TItem>(
    string[] parts, int most, double min, double max, Func<double[], TItem?> make, Func<TItem, double[]> take, Func<ValueList<TItem>, string?>? check = null)
    : KeyFormat<ValueList<TItem>>(KeyKind.Rows, $"a list of lists [{string.Join(", ", parts)}]")
    where TItem : struct
{
    /// <summary>Minimum number of rows.</summary>
    public int Fewest { get; init; }

    public override string Range => $"{NumberFormatter.Format(Fewest)} to {NumberFormatter.Format(most)} lists [{string.Join(", ", parts)}]";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema =>
    [
        new("type", "array"),
        new("items", NumbersFormat<double>.ListSchema(parts.Length, min, max)),
        new("minItems", (double)Fewest),
        new("maxItems", (double)most),
    ];

    public override object? Parse(string text) => RawValues.ParseRows(text);

    public override bool Fits(object raw) => raw is IReadOnlyList<object> rows && rows.All(row => Item(row) is not null);

    public override ValueList<TItem> Read(object raw) => new(((IReadOnlyList<object>)raw).Select(row => Item(row)!.Value));

    public override object Write(ValueList<TItem> value) => value.Select(i => RawValues.List(take(i))).ToArray();

    public override string? Problem(ValueList<TItem> value)
    {
        if (value.Count < Fewest || value.Count > most) return "must have " + Range;
        return value.SelectMany(take).All(n => n >= min && n <= max) ? check?.Invoke(value) : "must have numbers of " + RawValues.Range(min, max);
    }

    private TItem? Item(object row) => RawValues.Numbers(row, parts.Length) is { } numbers ? make(numbers) : null;
}
