namespace Caterpillar.Machines;

/// <summary>How the value of a key is read, written and checked.</summary>
internal abstract class KeyFormat(KeyKind kind, string expected)
{
    public KeyKind Kind => kind;

    /// <summary>The expected value, for messages: <c>a number</c>.</summary>
    public string Expected => expected;

    public abstract string Range { get; }

    /// <summary>Constraints as a JSON schema: keys and raw values in order.</summary>
    public abstract IReadOnlyList<KeyValuePair<string, object>> Schema { get; }

    /// <summary>The words of a choice.</summary>
    public virtual IReadOnlyList<string> Choices => [];

    /// <summary>Reads text after <c>key=</c>; null if it has another type.</summary>
    public abstract object? Parse(string text);

    /// <summary>Whether a raw value has the type.</summary>
    public abstract bool Fits(object raw);

    /// <summary>The value of a raw value that fits.</summary>
    public abstract object? ValueOf(object raw);

    /// <summary>The raw value.</summary>
    public abstract object Written(object? value);

    /// <summary>What is wrong with a value, or null.</summary>
    public abstract string? ProblemOf(object? value);

    /// <summary>The sentence " Did you mean …?" for an unknown word, or nothing.</summary>
    public virtual string Hint(string word) => "";

    public static string Describe(object raw) => raw switch
    {
        string text => "the text \"" + (text.Length > 40 ? text.Substring(0, 40) + "…" : text) + "\"",
        bool flag => flag ? "true" : "false",
        double number => NumberFormatter.Shortest(number),
        IReadOnlyList<object> list => list.Count == 1 ? "a list of 1 value" : "a list of " + NumberFormatter.Shortest(list.Count) + " values",
        _ => "an object",
    };
}

/// <inheritdoc/>
internal abstract class KeyFormat<TValue>(KeyKind kind, string expected) : KeyFormat(kind, expected)
{
    /// <inheritdoc cref="KeyFormat.ValueOf"/>
    public abstract TValue Read(object raw);

    public abstract object Write(TValue value);

    /// <inheritdoc cref="KeyFormat.ProblemOf"/>
    public abstract string? Problem(TValue value);

    public sealed override object? ValueOf(object raw) => Read(raw);

    public sealed override object Written(object? value) => Write((TValue)value!);

    public sealed override string? ProblemOf(object? value) => Problem((TValue)value!);
}

/// <summary>A list of texts, each of which is one item.</summary>
/// <param name="expected">The expected value, for messages.</param>
/// <param name="range">The range in words.</param>
/// <param name="item">An item from its text; null if the text is wrong.</param>
/// <param name="problem">What is wrong with a list, or null.</param>
/// <param name="pattern">The pattern of a text in JSON schemas, or null.</param>
internal class TextsFormat<TItem>(
    string expected, string range, Func<string, TItem?> item, Func<ValueList<TItem>, string?> problem, string? pattern = null)
    : KeyFormat<ValueList<TItem>>(KeyKind.Lines, expected)
{
    public override string Range => range;

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "array"), new("items", SchemaOfItem)];

    public override object? Parse(string text)
        => text.Trim().Length == 0 ? Array.Empty<object>()
            : RawValues.Unbracketed(text).Split(',', '\n').Select(t => (object)t.Trim().Trim('"')).ToArray();

    public override bool Fits(object raw) => raw is IReadOnlyList<object> list && list.All(i => i is string text && item(text) is not null);

    public override ValueList<TItem> Read(object raw) => new(((IReadOnlyList<object>)raw).Select(i => item((string)i)!));

    public override object Write(ValueList<TItem> value) => value.Select(v => (object)v!.ToString()!).ToArray();

    public override string? Problem(ValueList<TItem> value) => problem(value);

    private KeyValuePair<string, object>[] SchemaOfItem => pattern is null ? [new("type", "string")] : [new("type", "string"), new("pattern", pattern)];
}
