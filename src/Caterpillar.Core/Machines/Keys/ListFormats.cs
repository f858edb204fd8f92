namespace Caterpillar.Machines;

/// <summary>A value from a list of numbers of fixed length.</summary>
internal sealed class NumbersFormat<TValue>(string[] parts, double min, double max, Func<double[], TValue> make, Func<TValue, double[]> take)
    : KeyFormat<TValue>(KeyKind.Numbers, $"a list of {parts.Length} numbers [{string.Join(", ", parts)}]")
{
    public override string Range => "[" + string.Join(", ", parts) + "], each " + RawValues.Range(min, max);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => ListSchema(parts.Length, min, max);

    public override object? Parse(string text) => RawValues.ParseNumbers(text);

    public override bool TryRead(object raw, out TValue? value)
    {
        var numbers = RawValues.Numbers(raw, parts.Length);
        value = numbers is null ? default : make(numbers);
        return numbers is not null;
    }

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

    public override bool TryRead(object raw, out ValueList<TItem>? value)
    {
        value = null;
        if (raw is not IReadOnlyList<object> list) return false;
        var items = new TItem[list.Count];
        for (var i = 0; i < items.Length; i++)
        {
            if (RawValues.Numbers(list[i], parts.Length) is not { } numbers || make(numbers) is not { } item) return false;
            items[i] = item;
        }
        value = new ValueList<TItem>(items);
        return true;
    }

    public override object Write(ValueList<TItem> value) => value.Select(i => RawValues.List(take(i))).ToArray();

    public override string? Problem(ValueList<TItem> value)
    {
        if (value.Count < Fewest || value.Count > most) return "must have " + Range;
        return value.SelectMany(take).All(n => n >= min && n <= max) ? check?.Invoke(value) : "must have numbers of " + RawValues.Range(min, max);
    }
}
